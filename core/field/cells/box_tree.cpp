#include "core/field/cells/box_tree.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::size_t alone = 8192; ///< boxes that one thread sorts

struct Item {
    std::array<float, 3> centre;
    std::uint32_t number;
};

/// Sorts items so that each run of 4, 16, 64 ... is compact: every child of the implicit tree is one of
/// those.
void arrange(std::span<Item> items) {
    if (items.size() <= 4)
        return;
    std::size_t run = 4; // the largest power of four that is less than all
    while (run * 4 < items.size())
        run *= 4;
    const std::size_t runs = (items.size() + run - 1) / run;
    const std::size_t middle = runs / 2 * run;
    std::array<float, 3> lo{infinite, infinite, infinite};
    std::array<float, 3> hi{-infinite, -infinite, -infinite};
    for (const Item& item : items)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lo[axis] = std::min(lo[axis], item.centre[axis]);
            hi[axis] = std::max(hi[axis], item.centre[axis]);
        }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (hi[axis] - lo[axis] > hi[widest] - lo[widest])
            widest = axis;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                     items.end(), [&](const Item& a, const Item& b) {
                         return a.centre[widest] != b.centre[widest]
                                    ? a.centre[widest] < b.centre[widest]
                                    : a.number < b.number;
                     });
    const auto first = items.first(middle);
    const auto second = items.subspan(middle);
    if (items.size() > alone) {
        tbb::parallel_invoke([&] { arrange(first); }, [&] { arrange(second); });
    } else {
        arrange(first);
        arrange(second);
    }
}

float below(double x) {
    const auto near = static_cast<float>(x);
    return static_cast<double>(near) > x ? std::nextafter(near, -infinite) : near;
}

float above(double x) {
    return -below(-x);
}

} // namespace

FloatBox rounded_outward(const Box& box) {
    const Vec3 margin = 1e-9 * box.extent();
    FloatBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        result.lo[i] = below(box.lo[axis] - margin[axis]);
        result.hi[i] = above(box.hi[axis] + margin[axis]);
        if (!std::isfinite(result.lo[i]) || !std::isfinite(result.hi[i]))
            return {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
    }
    return result;
}

BoxTree::BoxTree(std::span<const FloatBox> boxes) {
    if (boxes.empty())
        return;
    std::vector<Item> items(boxes.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, boxes.size(), alone), [&](const auto& some) {
            for (std::size_t i = some.begin(); i != some.end(); ++i) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const float centre = 0.5f * (boxes[i].lo[axis] + boxes[i].hi[axis]);
                    items[i].centre[axis] =
                        std::isfinite(centre) ? centre : 0.0f; // keeps order total
                }
                items[i].number = static_cast<std::uint32_t>(i);
            }
        });
    arrange(items);
    number_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        number_[i] = items[i].number;
    std::size_t nodes = 0;
    for (std::size_t below = items.size(); level_.empty() || below > 1;) {
        below = (below + ways - 1) / ways;
        level_.push_back(nodes);
        nodes += below;
    }
    node_.resize(nodes);
    for (std::size_t level = 0; level < level_.size(); ++level) {
        const std::size_t end = level + 1 < level_.size() ? level_[level + 1] : nodes;
        const std::size_t children = level > 0 ? level_[level] - level_[level - 1] : items.size();
        const auto child = [&](std::size_t k) {
            if (level == 0)
                return boxes[number_[k]];
            const Node& node = node_[level_[level - 1] + k];
            FloatBox box;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box.lo[axis] = infinite;
                box.hi[axis] = -infinite;
                for (std::size_t i = 0; i < ways; ++i) {
                    box.lo[axis] = std::min(box.lo[axis], node.lo[axis][i]);
                    box.hi[axis] = std::max(box.hi[axis], node.hi[axis][i]);
                }
            }
            return box;
        };
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, end - level_[level], 1024),
                          [&](const auto& some) {
                              for (std::size_t k = some.begin(); k != some.end(); ++k)
                                  for (std::size_t i = 0; i < ways; ++i) {
                                      FloatBox box{{infinite, infinite, infinite},
                                                   {-infinite, -infinite, -infinite}};
                                      if (ways * k + i < children)
                                          box = child(ways * k + i);
                                      for (std::size_t axis = 0; axis < 3; ++axis) {
                                          node_[level_[level] + k].lo[axis][i] = box.lo[axis];
                                          node_[level_[level] + k].hi[axis][i] = box.hi[axis];
                                      }
                                  }
                          });
    }
}

std::size_t BoxTree::bytes() const {
    return number_.size() * sizeof(number_[0]) + node_.size() * sizeof(Node);
}

std::uint32_t BoxTree::nearest(const Vec3& p) const {
    std::uint32_t found = none();
    if (number_.empty() || !finite(p))
        return found;

    struct Candidate {
        double square;
        Place at;
    };

    std::vector<Candidate> stack{{0.0, {static_cast<std::uint32_t>(level_.size() - 1), 0}}};
    double least = std::numeric_limits<double>::infinity();
    while (!stack.empty()) {
        const Candidate next = stack.back();
        stack.pop_back();
        if (next.square > least)
            continue;
        const Node& node = node_[level_[next.at.level] + next.at.index];
        std::array<Candidate, ways> child;
        for (std::uint32_t i = 0; i < ways; ++i) {
            child[i] = {0.0,
                        {next.at.level - 1, static_cast<std::uint32_t>(ways) * next.at.index + i}};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = p[static_cast<int>(axis)];
                const double away = std::max(std::max(double{node.lo[axis][i]} - x, 0.0),
                                             x - double{node.hi[axis][i]});
                child[i].square += away * away;
            }
        }
        // The nearest last, so that it is next.
        std::sort(child.begin(), child.end(), [](const Candidate& a, const Candidate& b) {
            return a.square != b.square ? a.square > b.square : a.at.index > b.at.index;
        });
        for (const Candidate& each : child) {
            if (!(each.square < std::numeric_limits<double>::infinity()) || each.square > least)
                continue;
            if (next.at.level > 0) {
                stack.push_back(each);
                continue;
            }
            const std::uint32_t number = number_[each.at.index];
            if (each.square < least || number < found) {
                least = each.square;
                found = number;
            }
        }
    }
    return found;
}

} // namespace wakesurf::core
