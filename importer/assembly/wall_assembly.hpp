// The walls among the faces of a mesh of cells, and the geometry of obstacles for display.
#pragma once

#include "importer/assembly/grid_assembly.hpp"
#include "importer/base/source.hpp"
#include "store/store_reader.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::importer {

struct Walls {
    std::vector<std::uint32_t> still; ///< nodes on no-slip walls, ascending: their velocity is zero
    std::size_t unmatched = 0; ///< faces the reader gave that are no boundary face of the mesh
};

/// Makes boundary faces walls: first those that the reader names, then those between pieces that stay apart, and
/// the boundaries of holes in the domain.
/// Faces of other grids are never walls.
Walls find_walls(GridAssembly& assembly, const SourceStep& step);

/// Makes each remaining boundary face a wall if all its nodes have exactly zero velocity at both time-steps
/// (xyz a node).
void add_still_walls(GridAssembly& assembly,
                     std::span<const float> first,
                     std::span<const float> last);

/// Returns the triangles of walls and solids, without walls in a plane of the box round the domain, which
/// would hide everything in it. May be empty.
core::WallGeometry wall_geometry(const GridAssembly& assembly, const SourceStep& step);

} // namespace wakesurf::importer
