// The volume of a cell by its corners, and turning cells that are numbered inside out.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <span>

namespace wakesurf::importer {

/// Returns the volume, negative for a cell numbered inside out. A face of 4 nodes counts as 4 triangles round
/// its centre.
double cell_volume(const core::MeshCell& cell, std::span<const core::Vec3> points);

enum class Turned { Kept, Reordered, Flat };

/// Makes the volume positive by numbering the nodes the other way round. Returns Flat if the volume is below
/// rounding errors of the coordinates.
Turned turn_outside_out(core::MeshCell& cell, std::span<const core::Vec3> points);

} // namespace wakesurf::importer
