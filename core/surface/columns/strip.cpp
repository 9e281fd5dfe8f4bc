#include "core/surface/columns/strip.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t unlimited = std::numeric_limits<std::uint32_t>::max();

} // namespace

Strip::Strip(const SeededCurve& left, const SeededCurve& right, double right_s)
    : columns_{{&left, &left.column, 0}, {&right, &right.column, 0}}, version_{1, 1} {
    Node root;
    root.left_s = left.s;
    root.right_s = right_s;
    nodes_.push_back(root);
}

void Strip::zip(const StripLimits& limits) {
    failures_.clear();
    quads_ = 0;
    zip_node(limits, 0, left_column, right_column, {});
}

void Strip::zip_node(const StripLimits& limits,
                     std::int32_t node,
                     std::uint32_t left,
                     std::uint32_t right,
                     StripFront start) {
    Node& here = nodes_[static_cast<std::size_t>(node)];
    const bool free = here.torn || !joinable(columns_[left].column->segments() - start.left,
                                             columns_[right].column->segments() - start.right);
    if (here.left != left || here.right != right || here.left_version != version_[left] ||
        here.right_version != version_[right] || here.start != start || here.free != free) {
        here.left = left;
        here.right = right;
        here.left_version = version_[left];
        here.right_version = version_[right];
        here.start = here.front = start;
        here.free = free;
        here.cells.clear();
        here.split = false;
    }
    const bool splits = here.middle != nullptr;
    if (!splits || here.cells.size() != here.rows) {
        here.split = false;
        if (!here.cells.empty())
            here.cells.back().mid[2] = {};
    }
    const bool reached = extend(limits, here, splits ? here.rows : unlimited);
    quads_ += here.cells.size();
    const auto fail = [&](bool exhausted, bool too_short) {
        failures_.push_back(
            {node, static_cast<std::uint32_t>(here.cells.size()),
             front_width(*columns_[left].column, *columns_[right].column, here.front), exhausted,
             too_short});
    };
    if (!reached) {
        if (!here.torn)
            fail(here.front.left == columns_[left].column->segments() ||
                     here.front.right == columns_[right].column->segments(),
                 false);
        return;
    }
    if (!splits || here.cells.size() < here.rows)
        return;
    if (!here.split && !place_middle(limits, here)) {
        fail(false, true);
        return;
    }
    const StripFront front = here.front;
    const std::uint32_t middle = here.column;
    const std::int32_t child[2] = {here.child[0], here.child[1]};
    zip_node(limits, child[0], left, middle, {front.left, 0});
    zip_node(limits, child[1], middle, right, {0, front.right});
}

/// Zips until the node has so many quads or its columns are used up. Returns false where no quad fits.
bool Strip::extend(const StripLimits& limits, Node& node, std::uint32_t rows) {
    const Column& left = *columns_[node.left].column;
    const Column& right = *columns_[node.right].column;
    const auto vertex = [](std::uint32_t column, std::size_t index) {
        return StripVertex{column, static_cast<std::uint32_t>(index)};
    };
    if (node.cells.size() > rows) {
        const StripCell& next = node.cells[rows];
        node.front = {next.corner[0].index, next.corner[1].index};
        node.cells.resize(rows);
    }
    StripFront& front = node.front;
    while (node.cells.size() < rows) {
        if (front.left == left.segments() && front.right == right.segments())
            return true;
        const auto step = next_quad(limits.rules, left.position, right.position, front,
                                    node.free ? ZipMode::Free : ZipMode::ToBothEnds);
        if (!step)
            return false;
        StripCell cell;
        cell.corner = {vertex(node.left, front.left), vertex(node.right, front.right),
                       vertex(node.right, front.right + step->right),
                       vertex(node.left, front.left + step->left)};
        if (step->right == 2)
            cell.mid[1] = vertex(node.right, front.right + 1);
        if (step->left == 2)
            cell.mid[3] = vertex(node.left, front.left + 1);
        node.cells.push_back(cell);
        front.left += step->left;
        front.right += step->right;
    }
    return true;
}

/// Starts the middle column at the middle of the node's front. Returns false where it cannot.
bool Strip::place_middle(const StripLimits& limits, Node& node) {
    const Column& left = *columns_[node.left].column;
    const Column& right = *columns_[node.right].column;
    const Vec3& l = left.position[node.front.left];
    const Vec3& r = right.position[node.front.right];
    const Curve& curve = node.middle->curve;
    const double start = nearest_arc(
        curve, 0.5 * (l + r), 0.5 * (left.arc[node.front.left] + right.arc[node.front.right]),
        limits.spacing.longest);
    if (start > curve.last.arc - 1e-3 * limits.spacing.longest)
        return false; // the new column ends before it would begin
    const Vec3 first = curve.at_arc(start).position;
    if (std::max(glm::length(first - l), glm::length(first - r)) > limits.rules.separation)
        return false; // the new column has left the strip by here
    if (node.column == no_column) {
        node.column = static_cast<std::uint32_t>(columns_.size());
        inner_.push_back(std::make_unique<Column>());
        columns_.push_back({node.middle, inner_.back().get(), node.depth + 1});
        version_.push_back(0);
    }
    Column& column = *inner_[node.column - 2];
    if (column.position.empty() || column.start != start) {
        column = make_column(node.middle->s, curve, start, limits.spacing);
        ++version_[node.column];
    }
    node.cells.back().mid[2] = {node.column, 0};
    node.split = true;
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
        child.depth = nodes_[static_cast<std::size_t>(node)].depth + 1;
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
        if (failure.middle_too_short && node.bent) {
            node.middle = nullptr;
            node.bent = false;
            node.flat = true;
            demand.changed = true;
        } else if (node.middle && failure.rows >= 1 && !failure.middle_too_short) {
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

/// Splits a node at a row, or moves its split there.
void Strip::split_bend(std::int32_t node, std::uint32_t row, Demand& demand) {
    Node& here = nodes_[static_cast<std::size_t>(node)];
    if (row == 0 && here.parent < 0) {
        demand.new_seed = middle_s(here);
        demand.changed = true;
        return;
    }
    if (row == 0 && nodes_[static_cast<std::size_t>(here.parent)].rows > 1) {
        lower(here.parent, demand);
        return;
    }
    row = std::max(row, 1u); // it hangs on the row before
    if (here.middle == nullptr) {
        if (row >= here.cells.size())
            return;
        branch(node, row, demand);
        nodes_[static_cast<std::size_t>(node)].bent = true;
        return;
    }
    if (row >= here.rows)
        return;
    const std::uint32_t moved = here.rows - row;
    here.rows = row;
    for (const std::int32_t child : here.child)
        if (nodes_[static_cast<std::size_t>(child)].middle)
            nodes_[static_cast<std::size_t>(child)].rows += moved;
    demand.changed = true;
}

Strip::Demand Strip::split_bends(const StripLimits& limits, std::span<const std::uint32_t> rows) {
    Demand demand;
    std::vector<bool> done(rows.size()); // or below one that is: its rows will be others
    for (std::size_t i = 0; i < rows.size() && !demand.new_seed; ++i) {
        const Node& node = nodes_[i];
        done[i] = node.parent >= 0 && done[static_cast<std::size_t>(node.parent)];
        if (done[i] || rows[i] == no_row || node.torn || node.flat ||
            node.right_s - node.left_s <= 2.0 * limits.least_interval)
            continue;
        split_bend(static_cast<std::int32_t>(i), rows[i], demand);
        done[i] = true;
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

} // namespace wakesurf::core
