// The cells that stay, in the numbers vertices have after the update: what both ends know before the new cells are there.
// protocol/wire/README.md, Cells code. Twin: web-client/src/protocol/keptCells.ts.
#pragma once

#include "protocol/wire/runs.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

struct KeptCells {
    std::uint32_t stay = 0;         ///< vertices that stay
    std::vector<std::uint32_t> now; ///< the new number of each old vertex; empty where none goes
    std::vector<core::Cell> cells;  ///< removed vertices are `core::no_vertex`
    std::vector<std::uint8_t>
        touched; ///< of each vertex that stays: not all its cells stay as they are

    /// Those that are not replaced and have a touched vertex, ascending; found by leave_out().
    std::vector<std::uint32_t> near;

    void touch(const core::Cell& cell);

    /// Those cells will be replaced: touches their vertices, then finds `near`. Once, last.
    void leave_out(const Runs& replaced);
};

/// Vertices of removed cells and of cells that lose a vertex are touched. Cost: O(before).
KeptCells keep_cells(const Runs& removed_vertices,
                     std::uint32_t vertices_before,
                     const Runs& removed_cells,
                     std::span<const core::Cell> before);

} // namespace wakesurf::protocol
