// The compact code of the cells: which vertices a cell has is expected from the cells around it and from those before it, and
// only whether that is so is coded. protocol/wire/README.md, Cells code. Twin: web-client/src/protocol/cellsCode.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/kept_cells.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// What both ends know when they come to the cells of an update: replaced ones first, then those that are added.
struct CellContext {
    std::uint32_t vertices = 0; ///< of the state after; at most 2^24
    const KeptCells& kept;      ///< those to be replaced as they were before, but left out
    const Runs& replaced;
};

/// REQUIRES: as many cells as are replaced at least, of vertices that there are. Cost: O(kept + cells).
Bytes encode_cells(std::span<const core::Cell> cells, const CellContext& context);

/// Error: Corrupt. Allocates `count` cells at most, and O(vertices).
core::Result<std::vector<core::Cell>>
decode_cells(std::span<const std::byte> code, std::uint32_t count, const CellContext& context);

} // namespace wakesurf::protocol
