// A mesh of cells: curvilinear blocks and unstructured grids in one form, in which a particle walks from cell
// to cell through their faces. Polyhedra are cut at import into pyramids and tetrahedra round a point of
// their own.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::core {

/// Nodes are numbered as VTK numbers them; the values are those of the store's shapes.u8.
enum class CellShape : std::uint8_t { Tetrahedron, Pyramid, Wedge, Hexahedron };

/// Stands for the neighbour across a face that no other cell shares.
inline constexpr std::uint32_t beyond_domain = 0xffffffffu;
inline constexpr std::uint32_t beyond_wall = 0xfffffffeu; ///< a wall: particles end here

/// Entries past the shape's own are `beyond_domain`. One cache line.
struct alignas(64) MeshCell {
    std::array<std::uint32_t, 8> node; ///< numbers of its nodes, as VTK orders them
    /// The cell on the other side of each face, by number, or one of the two above.
    std::array<std::uint32_t, 6> beyond;
    CellShape shape; ///< which of the four it is
};

/// The axis of a flow that is the same all the way round it.
struct SymmetryAxis {
    Vec3 origin;    ///< a point of it
    Vec3 direction; ///< of length 1
    Vec3 radial;    ///< of length 1, across it: into the half plane round which the mesh lies

    bool operator==(const SymmetryAxis&) const = default;
};

/// Nodes and cells, connected through faces (cell_neighbours.hpp).
struct CellMesh {
    std::vector<Vec3> points;    ///< of the nodes
    std::vector<MeshCell> cells; ///< in no order that matters
    /// The mesh is a thin wedge of an axisymmetric flow, which fills the body of revolution.
    std::optional<SymmetryAxis> axis{};
};

/// A face of a cell.
struct CellFace {
    std::uint8_t count = 0; ///< 3 or 4 nodes
    /// Indices into MeshCell::node, counterclockwise seen from outside.
    std::array<std::uint8_t, 4> node{};
};

/// Faces of a shape in the order of MeshCell::beyond; those of a hexahedron are r = 0, r = 1, s = 0, s = 1, t
/// = 0, t = 1.
std::size_t node_count(CellShape shape);
std::size_t face_count(CellShape shape);
CellFace face(CellShape shape, std::size_t number);

} // namespace wakesurf::core
