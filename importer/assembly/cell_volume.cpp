#include "importer/assembly/cell_volume.hpp"

#include <algorithm>
#include <array>

namespace wakesurf::importer {

using core::CellShape;
using core::MeshCell;
using core::Vec3;

namespace {

// The bound on rounding errors of a volume, as a part of the cube of the cell's size: some units of double
// precision.
constexpr double rounding = 1e-15;

double size_of(const MeshCell& cell, std::span<const Vec3> points) {
    Vec3 lo = points[cell.node[0]];
    Vec3 hi = lo;
    for (std::size_t i = 1; i < core::node_count(cell.shape); ++i) {
        lo = glm::min(lo, points[cell.node[i]]);
        hi = glm::max(hi, points[cell.node[i]]);
    }
    return glm::length(hi - lo);
}

template <std::size_t N>
void renumber(MeshCell& cell, const std::array<std::size_t, N>& order) {
    const auto before = cell.node;
    for (std::size_t i = 0; i < N; ++i)
        cell.node[i] = before[order[i]];
}

void mirror(MeshCell& cell) {
    switch (cell.shape) {
    case CellShape::Tetrahedron:
        return renumber<4>(cell, {1, 0, 2, 3});
    case CellShape::Pyramid:
        return renumber<5>(cell, {0, 3, 2, 1, 4});
    case CellShape::Wedge:
        return renumber<6>(cell, {3, 4, 5, 0, 1, 2});
    case CellShape::Hexahedron:
        return renumber<8>(cell, {4, 5, 6, 7, 0, 1, 2, 3});
    }
}

} // namespace

double cell_volume(const MeshCell& cell, std::span<const Vec3> points) {
    const Vec3 origin = points[cell.node[0]];
    std::array<Vec3, 8> corner;
    for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
        corner[i] = points[cell.node[i]] - origin;
    const std::size_t faces = core::face_count(cell.shape);
    double sixfold = 0.0;
    for (std::size_t f = 0; f < faces; ++f) {
        const core::CellFace face = core::face(cell.shape, f);
        Vec3 centre(0.0);
        for (std::size_t i = 0; i < face.count; ++i)
            centre += corner[face.node[i]];
        centre /= static_cast<double>(face.count);
        for (std::size_t i = 0; i < face.count; ++i) {
            const std::size_t next = i + 1 < face.count ? i + 1 : 0;
            sixfold += glm::dot(centre, glm::cross(corner[face.node[i]], corner[face.node[next]]));
        }
    }
    return sixfold / 6.0;
}

Turned turn_outside_out(MeshCell& cell, std::span<const Vec3> points) {
    const double volume = cell_volume(cell, points);
    const double size = size_of(cell, points);
    if (!(std::abs(volume) > rounding * size * size * size))
        return Turned::Flat;
    if (volume > 0.0)
        return Turned::Kept;
    mirror(cell);
    return Turned::Reordered;
}

} // namespace wakesurf::importer
