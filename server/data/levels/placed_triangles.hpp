// From the answer of the process that extracts level sets to triangles of the dataset: checked, in its
// coordinates, and without those in cells of which a node has no value.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "server/data/levels/level_process.hpp"

#include <span>

namespace wakesurf::server {

/// Returns the triangles, without unused points. Error: Io for points outside of the grid.
/// @param values  one a node. @param gaps  some are missing
core::Result<LevelMesh>
placed_triangles(const core::Grid& grid, std::span<const float> values, bool gaps, LevelMesh mesh);

} // namespace wakesurf::server
