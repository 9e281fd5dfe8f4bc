// Boxes that are found by place: a tree of four children a node, whose shape follows from the number of boxes
// alone, so that it needs no pointers. Splitting at medians keeps it balanced however finely parts of a mesh
// are graded. Boxes are float, rounded outward: a node is a line and a half of cache, and its four children
// are tested in a few instructions.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace wakesurf::core {

struct FloatBox {
    std::array<float, 3> lo;
    std::array<float, 3> hi;
};

/// The smallest float box round a box that is larger by a billionth on every side. What is not a number makes
/// a box that is never found.
FloatBox rounded_outward(const Box& box);

/// Finds boxes near a place. Memory: 36 bytes a box. Thread safety: concurrent queries are fine.
class BoxTree {
  public:
    BoxTree() = default;

    /// Builds the tree in parallel; it is the same on any number of threads. Cost: O(n log n), 0.3 us a box
    /// on one thread.
    explicit BoxTree(std::span<const FloatBox> boxes);

    bool empty() const { return number_.empty(); }

    std::size_t bytes() const;

    /// Calls visit(number) for each box that may overlap one, always in the same order, until it returns
    /// true. Returns whether it did.
    template <class Visit>
    bool visit(const Box& box, const Visit& visit) const {
        const auto lo = nearest_float(box.lo);
        const auto hi = nearest_float(box.hi);
        return descend([&](const Node& node) { return overlaps(node, lo, hi); }, visit);
    }

    /// Visits the boxes that may contain a point.
    template <class Visit>
    bool visit(const Vec3& p, const Visit& visit) const {
        // Rounding to nearest is monotonic: a point inside a box stays inside the rounded one.
        const auto at = nearest_float(p);
        return descend([&](const Node& node) { return overlaps(node, at, at); }, visit);
    }

    /// The box nearest to a point, the one of lowest number among equals; none() if there are none.
    std::uint32_t nearest(const Vec3& p) const;

    static constexpr std::uint32_t none() { return 0xffffffffu; }

  private:
    static constexpr std::size_t ways = 4;
    using Floats = float __attribute__((vector_size(16)));
    using Bits = std::int32_t __attribute__((vector_size(16)));

    /// Bounds of the children; those that do not exist are empty.
    struct alignas(32) Node {
        Floats lo[3];
        Floats hi[3];
    };

    struct Place {
        std::uint32_t level; ///< 0: its children are boxes
        std::uint32_t index;
    };

    static std::array<float, 3> nearest_float(const Vec3& p) {
        return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }

    static Bits
    overlaps(const Node& node, const std::array<float, 3>& lo, const std::array<float, 3>& hi) {
        return (node.lo[0] <= hi[0]) & (node.hi[0] >= lo[0]) & (node.lo[1] <= hi[1]) &
               (node.hi[1] >= lo[1]) & (node.lo[2] <= hi[2]) & (node.hi[2] >= lo[2]);
    }

    template <class Test, class Visit>
    bool descend(const Test& test, const Visit& visit) const {
        if (number_.empty())
            return false;
        Place stack[64];
        std::size_t height = 0;
        stack[height++] = {static_cast<std::uint32_t>(level_.size() - 1), 0};
        while (height > 0) {
            const Place at = stack[--height];
            const Bits hit = test(node_[level_[at.level] + at.index]);
            const auto first = static_cast<std::uint32_t>(ways * at.index);
            if (at.level > 0) {
                for (std::uint32_t i = ways; i-- > 0;)
                    if (hit[i])
                        stack[height++] = {at.level - 1, first + i};
                continue;
            }
            for (std::uint32_t i = 0; i < ways; ++i)
                if (hit[i] && visit(number_[first + i]))
                    return true;
        }
        return false;
    }

    std::vector<std::uint32_t> number_; ///< of the boxes in the tree's order
    std::vector<Node> node_;            ///< level by level, from the boxes up
    std::vector<std::size_t> level_;    ///< where each begins
};

} // namespace wakesurf::core
