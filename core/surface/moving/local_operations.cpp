#include "core/surface/moving/local_operations.hpp"

#include <algorithm>
#include <array>

namespace wakesurf::core {

namespace {

constexpr VertexId none = no_vertex;

/// The sub-edge of `cell` from `from` to `to`.
const SubEdge* find(const Outline& edges, VertexId from, VertexId to) {
    const auto found = std::find_if(edges.begin(), edges.end(),
                                    [&](const SubEdge& e) { return e.from == from && e.to == to; });
    return found == edges.end() ? nullptr : found;
}

std::array<Cell, 2> halves(const Cell& c, Axis axis) {
    if (axis == Axis::S)
        return {Cell{{c.corner[0], c.mid[0], c.mid[2], c.corner[3]}, {none, none, none, c.mid[3]}},
                Cell{{c.mid[0], c.corner[1], c.corner[2], c.mid[2]}, {none, c.mid[1], none, none}}};
    return {Cell{{c.corner[0], c.corner[1], c.mid[1], c.mid[3]}, {c.mid[0], none, none, none}},
            Cell{{c.mid[3], c.mid[1], c.corner[2], c.corner[3]}, {none, none, c.mid[2], none}}};
}

Cell joined(const Cell& a, const Cell& b, Axis axis) {
    if (axis == Axis::S)
        return {{a.corner[0], b.corner[1], b.corner[2], a.corner[3]},
                {a.corner[1], b.mid[1], a.corner[2], a.mid[3]}};
    return {{a.corner[0], a.corner[1], b.corner[2], b.corner[3]},
            {a.mid[0], a.corner[2], b.mid[2], a.corner[3]}};
}

} // namespace

void LocalOperations::replace(std::span<const CellIndex> removed,
                              std::span<const Cell> made,
                              std::size_t kept) {
    mesh_.quads.replace(removed, made, kept);
    touched_.insert(touched_.end(), mesh_.quads.made().begin(), mesh_.quads.made().end());
}

bool LocalOperations::ensure_mid(CellIndex cell, std::size_t side) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        const LinkedCell here = mesh_.quads[cell];
        if (here.cell.mid[side] != none)
            return true;
        const VertexId a = here.cell.corner[side];
        const VertexId b = here.cell.corner[(side + 1) % 4];
        const CellIndex neighbour = here.across[side][0];
        Cell changed = here.cell;
        if (neighbour == no_cell) {
            changed.mid[side] = insert_(cell, side);
            replace(std::array{cell}, std::array{changed}, 1);
            return true;
        }
        Cell beyond = mesh_.quads[neighbour].cell;
        const Outline edges = outline(beyond);
        const SubEdge* facing = find(edges, b, a);
        if (!facing)
            return false;
        if (beyond.mid[facing->side] == none) {
            changed.mid[side] = beyond.mid[facing->side] = insert_(cell, side);
            replace(std::array{cell, neighbour}, std::array{changed, beyond}, 2);
            return true;
        }
        // Our side is half of the neighbour's: it must be cut first.
        busy_.push_back(cell);
        const bool cut = split(neighbour, facing->side % 2 == 0 ? Axis::S : Axis::T);
        busy_.pop_back();
        if (!cut)
            return false;
    }
    return false;
}

bool LocalOperations::split(CellIndex cell, Axis axis) {
    if (std::find(busy_.begin(), busy_.end(), cell) != busy_.end() || busy_.size() > 64)
        return false;
    const auto side = static_cast<std::size_t>(axis);
    if (!ensure_mid(cell, side) || !ensure_mid(cell, side + 2))
        return false;
    const Cell& here = mesh_.quads[cell].cell;
    if (axis == Axis::T && !(clear_of_young(here, here.mid[3], here.mid[1]) &&
                             clear_of_old(here, here.mid[3], here.mid[1])))
        return false;
    replace(std::array{cell}, halves(mesh_.quads[cell].cell, axis), 0);
    return true;
}

/// A cross edge must not pass a mid node of the side it faces: the cell between them would be turned over.
bool LocalOperations::clear_of_young(const Cell& cell, VertexId left, VertexId right) const {
    if (cell.mid[0] == none)
        return true;
    const auto& place = mesh_.vertices.place;
    const double inwards = place[cell.corner[3]].row - place[cell.corner[0]].row;
    return mesh_.row_beyond(left, right, cell.mid[0]) * inwards > 0.0;
}

bool LocalOperations::clear_of_old(const Cell& cell, VertexId left, VertexId right) const {
    if (cell.mid[2] == none)
        return true;
    const auto& place = mesh_.vertices.place;
    const double inwards = place[cell.corner[0]].row - place[cell.corner[3]].row;
    return mesh_.row_beyond(left, right, cell.mid[2]) * inwards > 0.0;
}

CellIndex LocalOperations::whole_neighbour(CellIndex cell, std::size_t side) const {
    const LinkedCell& here = mesh_.quads[cell];
    const CellIndex neighbour = here.across[side][0];
    if (here.cell.mid[side] != none || neighbour == no_cell || neighbour == cell)
        return no_cell;
    const Cell& beyond = mesh_.quads[neighbour].cell;
    const std::size_t facing = (side + 2) % 4;
    return beyond.mid[facing] == none &&
                   beyond.corner[facing] == here.cell.corner[(side + 1) % 4] &&
                   beyond.corner[(facing + 1) % 4] == here.cell.corner[side]
               ? neighbour
               : no_cell;
}

CellIndex LocalOperations::partner(CellIndex cell, Axis axis) const {
    const auto side = static_cast<std::size_t>(axis);
    const CellIndex other = whole_neighbour(cell, axis == Axis::S ? 1 : 2);
    if (other == no_cell)
        return no_cell;
    const Cell& a = mesh_.quads[cell].cell;
    const Cell& b = mesh_.quads[other].cell;
    for (const std::size_t k : {side, side + 2})
        if (a.mid[k] != none || b.mid[k] != none)
            return no_cell;
    if (axis == Axis::T || !mesh_.lattice.closed)
        return other;
    // From half the ring on the short way between two corners would no longer be the cell's own side.
    const auto& place = mesh_.vertices.place;
    const auto width = [&](const Cell& c, std::size_t left, std::size_t right) {
        return mesh_.lattice.columns_between(place[c.corner[left]].column,
                                             place[c.corner[right]].column);
    };
    const double widest =
        std::max(width(a, 0, 1) + width(b, 0, 1), width(a, 3, 2) + width(b, 3, 2));
    return 2.0 * widest < mesh_.lattice.columns ? other : no_cell;
}

void LocalOperations::drop_mid(CellIndex cell,
                               std::size_t side,
                               const std::function<bool(VertexId, VertexId, VertexId)>& droppable) {
    const LinkedCell here = mesh_.quads[cell];
    const VertexId mid = here.cell.mid[side];
    const VertexId a = here.cell.corner[side];
    const VertexId b = here.cell.corner[(side + 1) % 4];
    const CellIndex neighbour = here.across[side][0];
    if (mid == none || neighbour != here.across[side][1])
        return;
    Cell changed = here.cell;
    changed.mid[side] = none;
    if (mesh_.row_beyond(a, b, mid) != 0.0 && side % 2 == 0)
        return; // a bend on the lattice: a straight edge could pass a vertex of either cell
    if (neighbour == no_cell) {
        if (droppable(a, mid, b)) {
            replace(std::array{cell}, std::array{changed}, 1);
            mesh_.vertices.remove(mid);
        }
        return;
    }
    Cell beyond = mesh_.quads[neighbour].cell;
    for (std::size_t k = 0; k < 4; ++k)
        if (beyond.mid[k] == mid) {
            beyond.mid[k] = none;
            replace(std::array{cell, neighbour}, std::array{changed, beyond}, 2);
            mesh_.vertices.remove(mid);
            return;
        }
}

void LocalOperations::merge(CellIndex cell,
                            Axis axis,
                            const std::function<bool(VertexId, VertexId, VertexId)>& droppable) {
    const CellIndex other = partner(cell, axis);
    const Cell made = joined(mesh_.quads[cell].cell, mesh_.quads[other].cell, axis);
    replace(std::array{cell, other}, std::array{made}, 0);
    const auto side = static_cast<std::size_t>(axis);
    drop_mid(cell, side, droppable);
    drop_mid(cell, side + 2, droppable);
}

LocalOperations::CrossEdge LocalOperations::reconnected(CellIndex cell, Reconnection how) const {
    const CrossEdge edge = shifted(cell, how);
    if (edge.left == none || !clear_of_young(mesh_.quads[cell].cell, edge.left, edge.right))
        return {};
    CellIndex last = whole_neighbour(cell, 2);
    if (how == Reconnection::PairRight || how == Reconnection::PairLeft)
        last = whole_neighbour(last, 2);
    return clear_of_old(mesh_.quads[last].cell, edge.left, edge.right) ? edge : CrossEdge{};
}

LocalOperations::CrossEdge LocalOperations::shifted(CellIndex cell, Reconnection how) const {
    const CellIndex old = whole_neighbour(cell, 2);
    if (old == no_cell)
        return {};
    const Cell& a = mesh_.quads[cell].cell;
    const Cell& b = mesh_.quads[old].cell;
    switch (how) {
    case Reconnection::LeftYoung:
        return b.mid[3] == none && a.mid[3] != none ? CrossEdge{a.mid[3], a.corner[2]}
                                                    : CrossEdge{};
    case Reconnection::RightYoung:
        return b.mid[1] == none && a.mid[1] != none ? CrossEdge{a.corner[3], a.mid[1]}
                                                    : CrossEdge{};
    case Reconnection::LeftOld:
        return a.mid[3] == none && b.mid[3] != none ? CrossEdge{b.mid[3], a.corner[2]}
                                                    : CrossEdge{};
    case Reconnection::RightOld:
        return a.mid[1] == none && b.mid[1] != none ? CrossEdge{a.corner[3], b.mid[1]}
                                                    : CrossEdge{};
    case Reconnection::PairRight:
    case Reconnection::PairLeft:
        break;
    }
    const CellIndex oldest = whole_neighbour(old, 2);
    if (oldest == no_cell || oldest == cell)
        return {};
    const Cell& c = mesh_.quads[oldest].cell;
    for (const std::size_t side : {1u, 3u})
        if (a.mid[side] != none || b.mid[side] != none || c.mid[side] != none)
            return {};
    return how == Reconnection::PairRight ? CrossEdge{a.corner[3], b.corner[2]}
                                          : CrossEdge{b.corner[3], a.corner[2]};
}

void LocalOperations::reconnect(CellIndex cell, Reconnection how) {
    const auto [left, right] = reconnected(cell, how);
    const CellIndex old = whole_neighbour(cell, 2);
    Cell a = mesh_.quads[cell].cell;
    Cell b = mesh_.quads[old].cell;
    const VertexId was_left = a.corner[3];
    const VertexId was_right = a.corner[2];
    a.corner[3] = b.corner[0] = left;
    a.corner[2] = b.corner[1] = right;
    switch (how) {
    case Reconnection::LeftYoung:
        a.mid[3] = none, b.mid[3] = was_left;
        break;
    case Reconnection::RightYoung:
        a.mid[1] = none, b.mid[1] = was_right;
        break;
    case Reconnection::LeftOld:
        b.mid[3] = none, a.mid[3] = was_left;
        break;
    case Reconnection::RightOld:
        b.mid[1] = none, a.mid[1] = was_right;
        break;
    case Reconnection::PairRight:
    case Reconnection::PairLeft: {
        const CellIndex oldest = whole_neighbour(old, 2);
        const Cell& c = mesh_.quads[oldest].cell;
        const Cell middle = mesh_.quads[old].cell;
        Cell young = mesh_.quads[cell].cell;
        young.corner[2] = right;
        young.corner[3] = left;
        Cell rest = c;
        rest.corner[0] = left;
        rest.corner[1] = right;
        if (how == Reconnection::PairRight) {
            young.mid[1] = was_right;
            rest.mid[3] = middle.corner[3];
        } else {
            young.mid[3] = was_left;
            rest.mid[1] = middle.corner[2];
        }
        replace(std::array{cell, oldest, old}, std::array{young, rest}, 2);
        return;
    }
    }
    replace(std::array{cell, old}, std::array{a, b}, 2);
}

void LocalOperations::tear(CellIndex cell) {
    mesh_.quads.replace(std::array{cell}, {}, 0);
}

} // namespace wakesurf::core
