// From what the process that extracts level sets answers to triangles of the dataset: checked, in its coordinates, and without those in cells of
// which a node has no value.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "server/service/levels/level_process.hpp"

#include <span>

namespace wakesurf::server {

/// Points that no triangle has are left out.
/// @param values  one a node. @param gaps  some are none
/// Error: Io for points that are not of the grid.
core::Result<LevelMesh>
placed_triangles(const core::Grid& grid, std::span<const float> values, bool gaps, LevelMesh mesh);

} // namespace wakesurf::server
