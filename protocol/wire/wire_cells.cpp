#include "protocol/wire/wire_cells.hpp"

#include "protocol/wire/corrupt.hpp"

#include <array>

namespace wakesurf::protocol {

namespace {

using core::Cell;
using core::no_vertex;

constexpr std::size_t slots = 8; ///< corners 0 to 3, then mids 0 to 3

template <class AnyCell>
auto& vertex_of(AnyCell& cell, std::size_t slot) {
    return slot < 4 ? cell.corner[slot] : cell.mid[slot - 4];
}

std::uint32_t mids_of(const Cell& cell) {
    std::uint32_t mids = 0;
    for (std::size_t side = 0; side < 4; ++side)
        mids |= cell.mid[side] != no_vertex ? 1u << side : 0u;
    return mids;
}

/// Calls code(vertex, base) for each vertex in turn, which returns the vertex. Encoder and decoder use this
/// walk.
template <class Cells, class Code>
void walk(const Cells& cells, const CellContext& context, Code code) {
    /// For each slot, the one of the same cell that a new vertex is near; corners 0 and 1 have that of the
    /// cell before.
    constexpr std::array<std::size_t, slots> near{0, 1, 1, 0, 0, 1, 2, 3};
    for (std::size_t slot = 0; slot < slots; ++slot) {
        std::uint32_t before = context.stay;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            auto& vertex = vertex_of(cells[i], slot);
            if (slot >= 4 && vertex == no_vertex)
                continue;
            const std::uint32_t old =
                i < context.replaced.size() ? vertex_of(context.replaced[i], slot) : no_vertex;
            const std::uint32_t base = old != no_vertex ? old
                                       : slot < 2       ? before
                                                        : cells[i].corner[near[slot]];
            const std::uint32_t now = code(vertex, base);
            if (old == no_vertex)
                before = now;
        }
    }
}

} // namespace

void append_cells(std::vector<std::uint32_t>& numbers,
                  std::span<const Cell> cells,
                  const CellContext& context) {
    for (const Cell& cell : cells)
        numbers.push_back(mids_of(cell));
    walk(cells, context, [&](std::uint32_t vertex, std::uint32_t base) {
        numbers.push_back(zigzag(vertex - base));
        return vertex;
    });
}

core::Result<std::vector<Cell>>
read_cells(Numbers& numbers, std::size_t count, const CellContext& context) {
    const auto mids = numbers.take(count);
    std::vector<Cell> cells(mids.size());
    bool fine = mids.size() == count;
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t side = 0; side < 4; ++side)
            cells[i].mid[side] = (mids[i] >> side & 1u) != 0 ? 0u : no_vertex;
    walk(std::span(cells), context, [&](std::uint32_t& vertex, std::uint32_t base) {
        vertex = base + unzigzag(numbers.next());
        fine = fine && vertex < context.vertices;
        return vertex;
    });
    if (fine && !numbers.failed())
        return cells;
    return corrupt("a cell of a mesh update has a vertex that is not there");
}

} // namespace wakesurf::protocol
