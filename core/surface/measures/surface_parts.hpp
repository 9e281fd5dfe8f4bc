// The triangles of a mesh, each cut down to the part where some functions are not negative: the part younger than an
// age, the part inside a box. Clipping after Sutherland and Hodgman, Reentrant Polygon Clipping, CACM 1974; in
// barycentric coordinates, so that whatever the vertices have is known on every part.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// A function on a mesh: one value a vertex, linear in each triangle.
using VertexFunction = std::vector<double>;

/// A side of the part of a triangle.
struct PartSide {
    Vec3 begin, end; ///< barycentric, as the part is run through
    /// The function that cut it, or where negative the side of the triangle: -1 from vertex 0 to 1, -2, -3.
    int bound;
};

/// The part of a triangle.
struct SurfacePart {
    std::array<VertexId, 3> vertex; ///< of the triangle
    Vec3 normal;                    ///< of the triangle, as long as its area is large
    /// The integrals of the barycentric coordinates over the part, divided by the triangle's area: their sum is the
    /// part's share of it, and the integral of a linear function is their product with its values at the vertices.
    Vec3 moment{0.0};
    std::vector<PartSide> sides; ///< in order

    /// Returns a linear function's values at the vertices.
    template <class Values>
    Vec3 at_vertices(const Values& values) const {
        return {double(values[vertex[0]]), double(values[vertex[1]]), double(values[vertex[2]])};
    }
};

/// Cuts triangles; keeps its memory between them.
class PartCutter {
  public:
    /// Returns the part where no bound is negative; null if there is none.
    const SurfacePart* cut(const QuadComplex& mesh,
                           const std::array<VertexId, 3>& triangle,
                           std::span<const VertexFunction> bounds);

  private:
    void keep(const Vec3& values, int bound);

    SurfacePart part_;
    std::vector<PartSide> before_;
};

/// Splits a cell's outline, 4 to 8 vertices, into triangles. They face as the cell does, and none has its three
/// vertices on one side of the cell.
template <class Visit>
void visit_triangles(const Cell& cell, const Visit& visit) {
    const CellPolygon outline = polygon(cell);
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < outline.count; ++i)
        for (const VertexId mid : cell.mid)
            if (mid != no_vertex && outline.vertex[i] == mid)
                first = i;
    for (std::uint32_t i = 1; i + 1 < outline.count; ++i)
        visit(std::array{outline.vertex[first], outline.vertex[(first + i) % outline.count],
                         outline.vertex[(first + i + 1) % outline.count]});
}

/// Visits every part that there is, in the order of the cells. Cost: O(cells).
template <class Visit>
void visit_parts(const QuadComplex& mesh,
                 std::span<const VertexFunction> bounds,
                 const Visit& visit) {
    PartCutter cutter;
    for (const Cell& cell : mesh.cells)
        visit_triangles(cell, [&](const std::array<VertexId, 3>& triangle) {
            if (const SurfacePart* part = cutter.cut(mesh, triangle, bounds))
                visit(*part);
        });
}

} // namespace wakesurf::core
