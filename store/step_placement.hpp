// The choice of whole time-steps or bricks for a new store.
#pragma once

#include "core/base/result.hpp"
#include "store/store_layout.hpp"

#include <cstdint>
#include <string_view>

namespace wakesurf::store {

enum class StepPlacement {
    /// Uses bricks where a time-step's velocity is larger than whole_at_most; a store that is gone on with
    /// stays as it was begun.
    Auto,
    Whole,
    Bricks
};

/// A size in bytes, in single precision. A time-step of this size is read in a second or two, and four of
/// them fit into the memory of most machines. It is the same everywhere: a store does not depend on the
/// machine it was made on.
inline constexpr std::uint64_t whole_at_most = std::uint64_t{1} << 30;

/// Parses auto, whole or bricks. Error: InvalidArgument.
core::Result<StepPlacement> parse_step_placement(std::string_view text);

/// Returns StoreLayout::brick_cells of a grid; 0 of a mesh of cells. Error: Unsupported for Bricks of a mesh
/// of cells.
core::Result<std::uint32_t> brick_cells_for(StepPlacement placement, const StoredGrid& grid);

/// A store that was begun with bricks of so many cells is what was asked for.
bool goes_on(StepPlacement placement, std::uint32_t brick_cells);

} // namespace wakesurf::store
