// Where in a cell a point is, by its local coordinates: inside or not, beyond which face, and the nearest
// point inside.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Points this far beyond a face, in units of the cell, still are inside: rounding opens no gaps between
/// cells.
inline constexpr double face_tolerance = 1e-9;

inline Vec3 cell_centre(CellShape shape) {
    constexpr double third = 1.0 / 3.0;
    switch (shape) {
    case CellShape::Tetrahedron:
        return Vec3(0.25);
    case CellShape::Pyramid:
        return {0.4, 0.4, 0.2};
    case CellShape::Wedge:
        return {third, third, 0.5};
    case CellShape::Hexahedron:
        break;
    }
    return Vec3(0.5);
}

/// Returns the local coordinates of a cell's node.
inline Vec3 node_local(CellShape shape, std::size_t i) {
    constexpr Vec3 low[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    switch (shape) {
    case CellShape::Tetrahedron:
    case CellShape::Wedge: {
        const bool wedge = shape == CellShape::Wedge;
        const std::size_t k = wedge ? i % 3 : i;
        return {k == 1, k == 2, wedge ? i >= 3 : k == 3};
    }
    case CellShape::Pyramid:
        return i == 4 ? Vec3(0, 0, 1) : low[i];
    case CellShape::Hexahedron:
        break;
    }
    return low[i % 4] + Vec3(0, 0, i / 4);
}

/// Returns how far a point lies beyond each face, negative inside, in the order of MeshCell::beyond. Entries
/// past the shape's own are below every other.
/// @param one  0: `u` is a difference of points, and so is the result, without the rounding of a place's size
inline std::array<double, 6> beyond_faces(CellShape shape, const Vec3& u, double one = 1.0) {
    const double none = -1e300 * one;
    switch (shape) {
    case CellShape::Tetrahedron:
        return {-u.y, u.x + u.y + u.z - one, -u.x, -u.z, none, none};
    case CellShape::Pyramid:
        return {-u.z, -u.y, u.x + u.z - one, u.y + u.z - one, -u.x, none};
    case CellShape::Wedge:
        return {-u.z, u.z - one, -u.y, u.x + u.y - one, -u.x, none};
    case CellShape::Hexahedron:
        break;
    }
    return {-u.x, u.x - one, -u.y, u.y - one, -u.z, u.z - one};
}

/// The face a point is farthest beyond; of equals the first.
inline std::size_t most_violated(CellShape shape, const Vec3& u) {
    const auto beyond = beyond_faces(shape, u);
    return static_cast<std::size_t>(std::max_element(beyond.begin(), beyond.end()) -
                                    beyond.begin());
}

/// Returns false for NaN.
inline bool inside_cell(CellShape shape, const Vec3& u) {
    constexpr double e = face_tolerance;
    const double low = std::min(std::min(u.x, u.y), u.z);
    switch (shape) {
    case CellShape::Tetrahedron:
        return low >= -e && u.x + u.y + u.z <= 1.0 + e;
    case CellShape::Pyramid:
        return low >= -e && std::max(u.x, u.y) + u.z <= 1.0 + e;
    case CellShape::Wedge:
        return low >= -e && u.x + u.y <= 1.0 + e && u.z <= 1.0 + e;
    case CellShape::Hexahedron:
        break;
    }
    return low >= -e && std::max(std::max(u.x, u.y), u.z) <= 1.0 + e;
}

/// True for a point that is in this cell alone of all that share faces: farther from each face than any
/// tolerance. False for NaN.
inline bool well_inside_cell(CellShape shape, const Vec3& u) {
    const auto beyond = beyond_faces(shape, u);
    return finite(u) && *std::max_element(beyond.begin(), beyond.end()) < -1e3 * face_tolerance;
}

/// A point of the cell near `u`; `u` itself where it is inside. What is not a number counts as 0.
inline Vec3 clamp_to_cell(CellShape shape, Vec3 u) {
    for (int axis = 0; axis < 3; ++axis)
        u[axis] = std::min(std::max(0.0, u[axis]), 1.0);
    if (shape == CellShape::Tetrahedron)
        u /= std::max(1.0, u.x + u.y + u.z);
    if (shape == CellShape::Wedge) {
        const double sum = std::max(1.0, u.x + u.y);
        u.x /= sum;
        u.y /= sum;
    }
    if (shape == CellShape::Pyramid) {
        u.x = std::min(u.x, 1.0 - u.z);
        u.y = std::min(u.y, 1.0 - u.z);
    }
    return u;
}

} // namespace wakesurf::core
