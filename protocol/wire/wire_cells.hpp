// New cells as numbers: slot by slot, each vertex as the difference from the one it replaces, or else from
// one that it is near. protocol/wire/FORMAT.md, Topology. Twin: readCells in
// web-client/src/protocol/wireEdit.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/numbers.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Holds what both ends know of the new cells.
struct CellContext {
    /// The old cells that the first of the new ones replace, one each.
    std::span<const core::Cell> replaced;
    std::uint32_t stay = 0;     ///< vertices that were there before
    std::uint32_t vertices = 0; ///< after the update
};

/// Appends new cells. REQUIRES: at least as many cells as are replaced.
void append_cells(std::vector<std::uint32_t>& numbers,
                  std::span<const core::Cell> cells,
                  const CellContext& context);

/// Reads `count` cells. Error: Corrupt. Allocates O(numbers) at most.
core::Result<std::vector<core::Cell>>
read_cells(Numbers& numbers, std::size_t count, const CellContext& context);

} // namespace wakesurf::protocol
