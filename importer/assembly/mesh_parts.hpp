// Which parts of a mesh touch no others, and which lie over others: what particles make of it nobody sees in the data.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <string>

namespace wakesurf::importer {

/// What a user should know; empty where all cells hang together, by faces of the same nodes or by faces that meet. Parts that are closer than
/// a rounding of coordinates in 32 bits touch: particles get across. Distances are those of the nearest nodes.
/// Cost: that of CellLocator, where there is more than one part.
std::string note_on_parts(const core::CellMesh& mesh);

} // namespace wakesurf::importer
