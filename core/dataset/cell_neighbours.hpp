// The neighbours of cells across faces, found from the nodes that faces share. The importer fills the mesh
// with them and then decides which of the remaining faces are walls.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// Fills `beyond` of every cell, overwriting what was there: `beyond_domain` where no other cell has a face
/// of the same nodes. Nodes repeated within a face count once, so that a hexahedron collapsed to a wedge
/// meets its neighbours; a face collapsed to a line has none. Where more than two cells share a face, the two
/// of lowest number are neighbours. Runs in parallel; the result does not depend on the number of threads.
/// Takes 4 bytes a face and 8 a node meanwhile.
/// @throws std::length_error  more than 2^29 cells; std::out_of_range  a node number without a point
void connect_cells(CellMesh& mesh);

struct BoundaryFace {
    std::uint32_t cell;
    std::uint32_t face; ///< index into MeshCell::beyond
};

/// Faces with no cell beyond them, by cell and face; without those that are collapsed to a line.
std::vector<BoundaryFace> boundary_faces(const CellMesh& mesh);

/// The nodes of a face, each once, in ascending order; entries not used are 0xffffffff.
std::array<std::uint32_t, 4> face_nodes(const MeshCell& cell, std::size_t face);

} // namespace wakesurf::core
