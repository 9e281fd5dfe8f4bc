// The quad complex with hanging nodes: the one mesh of every integral surface. A cell is a quad with four
// corners and at most one mid node a side; a mid node belongs to the coarse cell's polygon as well, so the
// surface is watertight by construction. Source: McLoughlin, Laramee, Zhang, Easy Integral Surfaces, CGI 2009
// (quads, local operations); hanging nodes as in Bürger et al. 2009.
#pragma once

#include "core/base/vec3.hpp"
#include "core/surface/carried_error.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::core {

using VertexId = std::uint32_t;
inline constexpr VertexId no_vertex = 0xffffffffu;

/// A quad. Corners run counter-clockwise round the cell: (s-, t young), (s+, young), (s+, old), (s-, old).
/// mid[i] hangs on the side from corner[i] to corner[(i + 1) % 4], or is no_vertex.
struct Cell {
    /// The four corners.
    std::array<VertexId, 4> corner{no_vertex, no_vertex, no_vertex, no_vertex};
    /// The node that hangs on each side, if any.
    std::array<VertexId, 4> mid{no_vertex, no_vertex, no_vertex, no_vertex};

    bool operator==(const Cell&) const = default;
};

/// A cell's outline: 4 to 8 vertices, corners and mid nodes in order.
struct CellPolygon {
    std::array<VertexId, 8> vertex; ///< the first `count` count
    std::uint32_t count = 0;        ///< 4 to 8
};

CellPolygon polygon(const Cell& cell);

/// Returns the cell facing the other way: its first side keeps its place and is run through backward.
Cell mirror(const Cell& cell);

/// Structure of arrays; every vertex array has one entry a vertex.
struct QuadComplex {
    std::vector<Vec3> position; ///< in the dataset's length unit
    std::vector<double> s;      ///< seed parameter along the rake, 0..1
    std::vector<double> t; ///< time since release; streak: of the release; time: place in the patch
    std::vector<Vec3f> velocity;    ///< of the flow there and then
    std::vector<float> deformation; ///< log2 of area now / area at birth; empty when not asked for
    std::vector<std::uint32_t> component;   ///< which connected part it is in, the largest is 0
    std::vector<std::uint8_t> approximated; ///< 1: interpolated, not traced from the rake
    /// The estimated distance of the vertex from the true surface, across it, a length; empty for a mesh that
    /// no builder has made.
    std::vector<float> error;
    /// How far interpolating between stored times puts the vertex off, a length; NaN: the stored times do not
    /// resolve it. Empty: not estimated.
    std::vector<float> interval_error;
    std::vector<SurfaceTangents> tangents; ///< dx/ds and dx/dt; empty when not asked for
    /// Vectors of length 1, or 0 without a normal; empty: computed from the cells.
    std::vector<Vec3f> normal;
    std::vector<Cell> cells; ///< quads, with their hanging nodes

    /// Returns the number of vertices.
    std::size_t vertices() const { return position.size(); }

    /// Returns the magnitude of a vertex's velocity.
    double speed(VertexId v) const { return glm::length(glm::dvec3(velocity[v])); }

    /// The invariants a watertight oriented surface must keep: ids in range, no repeated vertex in a cell,
    /// every directed edge once, no two vertices at one (s, t). Returns the first violation, or an empty
    /// string. Cost: O(cells + vertices log vertices).
    std::string validate() const;
};

/// Numbers the edge-connected parts of the surface, largest first, into `component`.
void label_components(QuadComplex& complex);

/// Returns the bytes of all arrays.
std::size_t memory_of(const QuadComplex& complex);

/// Sums up the estimated errors of a surface's vertices.
struct StatedError {
    /// A length: 99 % of the vertices that are not uncertain have no larger error.
    double error99 = 0.0;
    std::uint64_t uncertain = 0; ///< vertices whose error exceeds the separation

    bool operator==(const StatedError&) const = default;
};

/// Returns the stated error; empty if no errors are estimated.
std::optional<StatedError> stated_error(const QuadComplex& complex, double separation);

/// Returns the length of the longest sub-edge (sides cut at their mid nodes).
double longest_edge(const QuadComplex& complex);

/// A mesh whose vertices and cells have ids that last from one state of a surface to the next. Ids ascend;
/// an id is never used again for something else.
struct KeyedMesh {
    QuadComplex mesh;                     ///< the mesh itself
    std::vector<std::uint32_t> vertex_id; ///< of each vertex
    std::vector<std::uint32_t> cell_id;   ///< of each cell
    double time = 0.0;                    ///< simulation time
};

} // namespace wakesurf::core
