// Whether the time-steps of a new store are whole or in bricks.
#pragma once

#include "core/base/result.hpp"
#include "store/store_layout.hpp"

#include <cstdint>
#include <string_view>

namespace wakesurf::store {

enum class StepPlacement {
    Auto, ///< in bricks where a time-step's velocity is larger than whole_at_most; where a store is gone on with, as it was begun
    Whole,
    Bricks
};

/// In single precision. A time-step of this size is read in a second or two, and four of them fit into the memory of most machines.
/// The same everywhere: a store does not depend on the machine it was made on.
inline constexpr std::uint64_t whole_at_most = std::uint64_t{1} << 30;

/// auto, whole or bricks. Error: InvalidArgument.
core::Result<StepPlacement> parse_step_placement(std::string_view text);

/// StoreLayout::brick_cells of a grid; 0 of a mesh of cells. Error: Unsupported for Bricks of a mesh of cells.
core::Result<std::uint32_t> brick_cells_for(StepPlacement placement, const StoredGrid& grid);

/// A store that was begun with bricks of so many cells is what was asked for.
bool goes_on(StepPlacement placement, std::uint32_t brick_cells);

} // namespace wakesurf::store
