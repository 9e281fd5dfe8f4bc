#include "core/surface/columns/strip.hpp"

#include <algorithm>

namespace wakesurf::core {

Strip::Strip(const SeededCurve& left, const SeededCurve& right, double right_s)
    : ends_{&left, &right} {
    Node root;
    root.left_s = left.s;
    root.right_s = right_s;
    nodes_.push_back(root);
}

void Strip::zip(const StripLimits& limits) {
    cells_.clear();
    failures_.clear();
    columns_.clear();
    column_curves_.assign({ends_[0], ends_[1]});
    for (const SeededCurve* end : column_curves_)
        columns_.push_back(make_column(end->s, end->curve, 0.0, limits.spacing));
    zip_node(limits, 0, left_column, right_column, {});
}

void Strip::zip_node(const StripLimits& limits,
                     std::int32_t node,
                     std::uint32_t left,
                     std::uint32_t right,
                     StripFront front) {
    const auto rest = [&](std::uint32_t column, std::size_t at) {
        return columns_[column].segments() - at;
    };
    const bool free = nodes_[static_cast<std::size_t>(node)].torn ||
                      !joinable(rest(left, front.left), rest(right, front.right));
    std::int64_t below = -1;
    for (std::uint32_t rows = 0;; ++rows) {
        const Node& here = nodes_[static_cast<std::size_t>(node)];
        if (here.middle && rows == here.rows) {
            if (!split(limits, node, left, right, front, below))
                failures_.push_back(
                    {node, rows, front_width(columns_[left], columns_[right], front), false, true});
            return;
        }
        const std::size_t left_rest = rest(left, front.left);
        const std::size_t right_rest = rest(right, front.right);
        if (left_rest == 0 && right_rest == 0)
            return;
        const auto step = next_quad(limits.rules, columns_[left], columns_[right], front,
                                    free ? ZipMode::Free : ZipMode::ToBothEnds);
        if (!step) {
            if (!here.torn)
                failures_.push_back({node, rows,
                                     front_width(columns_[left], columns_[right], front),
                                     left_rest == 0 || right_rest == 0, false});
            return;
        }
        const auto vertex = [](std::uint32_t column, std::size_t index) {
            return StripVertex{column, static_cast<std::uint32_t>(index)};
        };
        StripCell cell;
        cell.corner = {vertex(left, front.left), vertex(right, front.right),
                       vertex(right, front.right + step->right),
                       vertex(left, front.left + step->left)};
        if (step->right == 2)
            cell.mid[1] = vertex(right, front.right + 1);
        if (step->left == 2)
            cell.mid[3] = vertex(left, front.left + 1);
        below = static_cast<std::int64_t>(cells_.size());
        cells_.push_back(cell);
        front.left += step->left;
        front.right += step->right;
    }
}

bool Strip::split(const StripLimits& limits,
                  std::int32_t node,
                  std::uint32_t left,
                  std::uint32_t right,
                  StripFront front,
                  std::int64_t below) {
    const Node here = nodes_[static_cast<std::size_t>(node)];
    const CurvePoint& l = columns_[left].points[front.left];
    const CurvePoint& r = columns_[right].points[front.right];
    const double start = nearest_arc(here.middle->curve, 0.5 * (l.position + r.position),
                                     0.5 * (l.arc + r.arc), limits.spacing);
    if (start > here.middle->curve.last.arc - 1e-3 * limits.spacing)
        return false; // the new column ends before it would begin
    const Vec3 first = here.middle->curve.at_arc(start).position;
    if (std::max(glm::length(first - l.position), glm::length(first - r.position)) >
        limits.rules.separation)
        return false; // the new column has left the strip by here
    const auto middle = static_cast<std::uint32_t>(columns_.size());
    columns_.push_back(make_column(here.middle->s, here.middle->curve, start, limits.spacing));
    column_curves_.push_back(here.middle);
    cells_[static_cast<std::size_t>(below)].mid[2] = {middle, 0};
    zip_node(limits, here.child[0], left, middle, {front.left, 0});
    zip_node(limits, here.child[1], middle, right, {0, front.right});
    return true;
}

/// Makes a leaf split after `rows` quads.
void Strip::branch(std::int32_t node, std::uint32_t rows, Demand& demand) {
    const double middle = middle_s(nodes_[static_cast<std::size_t>(node)]);
    for (int side = 0; side < 2; ++side) {
        Node child;
        child.left_s = side == 0 ? nodes_[static_cast<std::size_t>(node)].left_s : middle;
        child.right_s = side == 0 ? middle : nodes_[static_cast<std::size_t>(node)].right_s;
        child.parent = node;
        nodes_[static_cast<std::size_t>(node)].child[side] =
            static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back(child);
    }
    nodes_[static_cast<std::size_t>(node)].rows = rows;
    nodes_[static_cast<std::size_t>(node)].wants_middle = true;
    demand.middles.push_back(middle);
    demand.changed = true;
}

/// Moves the split of `node` closer to the rake, its children's splits staying where they are. By one quad
/// the first time, then two, four ...: a split that must go far down gets there in few rounds.
void Strip::lower(std::int32_t node, Demand& demand) {
    demand.changed = true;
    if (node < 0) {
        demand.new_seed = middle_s(nodes_.front());
        return;
    }
    Node& here = nodes_[static_cast<std::size_t>(node)];
    std::uint32_t moved = std::min(here.drop, here.rows - 1);
    here.drop *= 2;
    if (moved == 0) {
        const std::int32_t parent = here.parent;
        lower(parent, demand);
        moved = here.rows - 1;
    }
    here.rows -= moved;
    for (const std::int32_t child : here.child)
        if (nodes_[static_cast<std::size_t>(child)].middle)
            nodes_[static_cast<std::size_t>(child)].rows += std::max(moved, 1u);
}

Strip::Demand Strip::refine(const StripLimits& limits) {
    Demand demand;
    std::vector<std::int32_t> lowered;
    for (const Failure& failure : failures_) {
        Node& node = nodes_[static_cast<std::size_t>(failure.node)];
        const bool can_split = failure.width > limits.least_width &&
                               node.right_s - node.left_s > 2.0 * limits.least_interval;
        if (node.middle && failure.rows >= 1 && !failure.middle_too_short) {
            node.rows = failure.rows; // the tree below shifted: split where it fails now
            demand.changed = true;
        } else if (failure.middle_too_short || (can_split && failure.rows == 0)) {
            const std::int32_t target = failure.middle_too_short ? failure.node : node.parent;
            if (std::find(lowered.begin(), lowered.end(), target) != lowered.end())
                continue;
            lowered.push_back(target);
            lower(target, demand);
        } else if (can_split) {
            // Where a column ends, the next one needs a row of its own beside it.
            branch(failure.node, failure.exhausted ? std::max(failure.rows - 1, 1u) : failure.rows,
                   demand);
        } else {
            node.torn = true;
            demand.changed = true;
        }
    }
    return demand;
}

void Strip::supply(const SeededCurve& curve) {
    for (Node& node : nodes_)
        if (node.wants_middle && middle_s(node) == curve.s) {
            node.middle = &curve;
            node.wants_middle = false;
        }
}

void Strip::tear_rest() {
    for (const Failure& failure : failures_)
        nodes_[static_cast<std::size_t>(failure.node)].torn = true;
}

bool Strip::torn() const {
    return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.torn; });
}

} // namespace wakesurf::core
