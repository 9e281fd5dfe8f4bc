// The faces of a mesh that no other cell shares, as the source has them: a large face that was cut is known by the centre
// it was cut round.
#pragma once

#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/cell_neighbours.hpp"
#include "importer/assembly/grid_assembly.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::importer {

/// The source's nodes of the polygon a face is, or is a triangle of; ascending.
std::vector<std::uint32_t>
source_polygon(const GridAssembly& assembly, const core::MeshCell& cell, std::size_t face);

} // namespace wakesurf::importer
