// The walls among the faces of a mesh of cells, and the geometry of obstacles for display.
#pragma once

#include "importer/assembly/grid_assembly.hpp"
#include "importer/base/source.hpp"
#include "store/store_reader.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct Walls {
    std::vector<std::uint32_t> still; ///< nodes on no-slip walls, ascending: their velocity is zero
    std::size_t unmatched = 0;        ///< faces of walls that are no boundary face of the mesh
    /// The names of patches, fit to be shown: those of faces that are on the mesh's boundary.
    std::vector<std::string> names;
    /// Of each of core::boundary_faces the number of its name; no_name: it has none.
    std::vector<std::uint32_t> name_of_face;
};

inline constexpr std::uint32_t no_name = 0xffffffffu;

/// More patches than this share a name: a list of them would be of no use.
inline constexpr std::size_t most_patches = 256;

/// For display, of what is no wall or lies in a side of the domain.
inline constexpr std::size_t most_side_faces = 250'000;

/// Makes boundary faces walls: first those that the reader names, then those between pieces that stay apart, and
/// the boundaries of holes in the domain.
/// Faces of other grids are never walls.
Walls find_walls(GridAssembly& assembly, const SourceStep& step);

/// Makes each remaining boundary face a wall if all its nodes have exactly zero velocity at both time-steps
/// (xyz a node).
void add_still_walls(GridAssembly& assembly,
                     std::span<const float> first,
                     std::span<const float> last);

/// Returns the triangles of walls and solids, and with `walls` that has names their patches. What is no wall, and walls in a
/// plane of the box round the domain, which would hide everything in it, are there only as patches of their own kinds; a
/// note says so where they are left out as too many. May be empty.
core::WallGeometry
wall_geometry(GridAssembly& assembly, const SourceStep& step, const Walls& walls = {});

} // namespace wakesurf::importer
