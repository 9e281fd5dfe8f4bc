#include "core/surface/moving/linked_quads.hpp"

#include <algorithm>
#include <unordered_map>

namespace wakesurf::core {

namespace {

struct OpenEdge {
    VertexId from, to;
    CellIndex cell; ///< for edges of the outside: whom they belong to
};

bool contains(std::span<const CellIndex> cells, CellIndex cell) {
    return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

} // namespace

Outline outline(const Cell& cell) {
    Outline result;
    for (std::uint8_t side = 0; side < 4; ++side) {
        const VertexId from = cell.corner[side];
        const VertexId to = cell.corner[(side + 1) % 4];
        const VertexId mid = cell.mid[side];
        if (mid == no_vertex) {
            result.edge[result.count++] = {from, to, side, 0};
        } else {
            result.edge[result.count++] = {from, mid, side, 0};
            result.edge[result.count++] = {mid, to, side, 1};
        }
    }
    return result;
}

CellIndex LinkedQuads::place(const Cell& cell) {
    CellIndex index;
    if (free_.empty()) {
        index = static_cast<CellIndex>(slots_.size());
        if (slots_.size() == slots_.capacity())
            slots_.reserve(slots_.size() + slots_.size() / 8 + 256);
        slots_.emplace_back();
    } else {
        index = free_.back();
        free_.pop_back();
    }
    slots_[index] = LinkedCell{};
    slots_[index].cell = cell;
    slots_[index].id = next_id_++;
    slots_[index].live = true;
    return index;
}

void LinkedQuads::link(CellIndex cell, const SubEdge& edge, CellIndex neighbour) {
    slots_[cell].across[edge.side][edge.half] = neighbour;
}

void LinkedQuads::relink(CellIndex cell, VertexId from, VertexId to, CellIndex neighbour) {
    for (const SubEdge& edge : outline(slots_[cell].cell))
        if (edge.from == from && edge.to == to)
            link(cell, edge, neighbour);
}

void LinkedQuads::replace(std::span<const CellIndex> removed,
                          std::span<const Cell> made,
                          std::size_t kept) {
    std::vector<OpenEdge> outside;
    outside.reserve(32);
    for (const CellIndex old : removed)
        for (const SubEdge& edge : outline(slots_[old].cell)) {
            const CellIndex neighbour = slots_[old].across[edge.side][edge.half];
            if (neighbour != no_cell && !contains(removed, neighbour))
                outside.push_back({edge.from, edge.to, neighbour});
        }
    made_.clear();
    for (std::size_t k = 0; k < std::max(made.size(), removed.size()); ++k) {
        if (k >= removed.size()) {
            made_.push_back(place(made[k]));
            continue;
        }
        const CellIndex slot = removed[k];
        if (k >= made.size()) {
            slots_[slot] = LinkedCell{};
            free_.push_back(slot);
            continue;
        }
        const std::uint32_t id = k < kept ? slots_[slot].id : next_id_++;
        slots_[slot] = LinkedCell{};
        slots_[slot].cell = made[k];
        slots_[slot].id = id;
        slots_[slot].live = true;
        made_.push_back(slot);
    }
    std::vector<OpenEdge> inside;
    inside.reserve(32);
    for (const CellIndex cell : made_)
        for (const SubEdge& edge : outline(slots_[cell].cell))
            inside.push_back({edge.from, edge.to, cell});
    for (const CellIndex cell : made_)
        for (const SubEdge& edge : outline(slots_[cell].cell)) {
            const auto out = std::find_if(outside.begin(), outside.end(), [&](const OpenEdge& e) {
                return e.from == edge.from && e.to == edge.to;
            });
            if (out != outside.end()) {
                link(cell, edge, out->cell);
                relink(out->cell, edge.to, edge.from, cell);
                out->cell = no_cell;
                continue;
            }
            const auto twin = std::find_if(inside.begin(), inside.end(), [&](const OpenEdge& e) {
                return e.from == edge.to && e.to == edge.from;
            });
            if (twin != inside.end())
                link(cell, edge, twin->cell);
        }
    for (const OpenEdge& edge : outside)
        if (edge.cell != no_cell)
            relink(edge.cell, edge.to, edge.from, no_cell);
}

void LinkedQuads::append(std::span<const Cell> made, std::span<const CellIndex> beside) {
    const auto key = [](VertexId from, VertexId to) { return std::uint64_t{from} << 32 | to; };
    std::unordered_map<std::uint64_t, CellIndex> open; // looked up only: its order decides nothing
    made_.clear();
    for (const Cell& cell : made)
        made_.push_back(place(cell));
    for (const CellIndex cell : beside)
        for (const SubEdge& edge : outline(slots_[cell].cell))
            if (slots_[cell].across[edge.side][edge.half] == no_cell)
                open[key(edge.from, edge.to)] = cell;
    for (const CellIndex cell : made_)
        for (const SubEdge& edge : outline(slots_[cell].cell))
            open[key(edge.from, edge.to)] = cell;
    for (const CellIndex cell : made_)
        for (const SubEdge& edge : outline(slots_[cell].cell)) {
            const auto twin = open.find(key(edge.to, edge.from));
            if (twin == open.end())
                continue;
            link(cell, edge, twin->second);
            relink(twin->second, edge.to, edge.from, cell);
        }
}

void LinkedQuads::renumber(std::span<const CellIndex> order,
                           std::span<const VertexId> vertex_slot) {
    std::vector<CellIndex> cell_slot(slots_.size(), no_cell);
    for (std::size_t i = 0; i < order.size(); ++i)
        cell_slot[order[i]] = static_cast<CellIndex>(i);
    std::vector<LinkedCell> sorted;
    sorted.reserve(order.size() + order.size() / 8);
    for (const CellIndex old : order) {
        LinkedCell cell = slots_[old];
        for (std::size_t k = 0; k < 4; ++k) {
            cell.cell.corner[k] = vertex_slot[cell.cell.corner[k]];
            if (cell.cell.mid[k] != no_vertex)
                cell.cell.mid[k] = vertex_slot[cell.cell.mid[k]];
            for (CellIndex& neighbour : cell.across[k])
                if (neighbour != no_cell)
                    neighbour = cell_slot[neighbour];
        }
        sorted.push_back(cell);
    }
    slots_ = std::move(sorted);
    free_.clear();
}

} // namespace wakesurf::core
