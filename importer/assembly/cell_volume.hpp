// The volume of a cell by its corners, and turning cells that are numbered inside out.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <span>

namespace wakesurf::importer {

/// Negative for a cell numbered inside out. Faces of 4 nodes count as 4 triangles round their centre.
double cell_volume(const core::MeshCell& cell, std::span<const core::Vec3> points);

enum class Turned { Kept, Reordered, Flat };

/// Makes the volume positive by numbering the nodes the other way round; Flat where there is none: below rounding
/// errors of the coordinates.
Turned turn_outside_out(core::MeshCell& cell, std::span<const core::Vec3> points);

} // namespace wakesurf::importer
