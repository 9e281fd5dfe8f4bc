// Parts of a mesh that touch no others, and parts that lie over others: neither is visible in the data, both
// change where particles go.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <string>

namespace wakesurf::importer {

/// Returns a note for the user; empty if all cells hang together, by faces of the same nodes or by faces that
/// meet. Parts closer than a rounding of 32-bit coordinates touch: particles cross there. Distances are those
/// of the nearest nodes. Cost: that of CellLocator, if there is more than one part.
std::string note_on_parts(const core::CellMesh& mesh);

} // namespace wakesurf::importer
