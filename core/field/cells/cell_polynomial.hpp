// Describes what varies over a cell as VTK's shape functions have it: position and velocity are polynomials
// of the same few monomials of the cell's local coordinates (u, v, w), whatever its shape. They are VTK's
// parametric coordinates (r, s, t) except in a pyramid, where u = r (1 - t) and v = s (1 - t): there position
// is smooth up to and at the apex.
#pragma once

#include "core/base/components.hpp"
#include "core/dataset/cell_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Returns a pyramid's r and s, limited to a little more than they are inside, and finite at the apex.
struct PyramidRatios {
    double r, s;

    explicit PyramidRatios(const Vec3& at) {
        const double scale = 1.0 / std::max(1.0 - at.z, 1e-12);
        r = std::min(std::max(-1.0, at.x * scale), 2.0);
        s = std::min(std::max(-1.0, at.y * scale), 2.0);
    }
};

/// Coefficients of 1, u, v, uv, w, uw, vw, uvw; in a pyramid the fourth is that of uv / (1 - w).
struct CellPolynomial {
    std::array<Components, 8> c;

    /// @param value  of the cell's node 0, 1, ...: a Components
    template <class Value>
    void fit(CellShape shape, const Value& value) {
        switch (shape) {
        case CellShape::Hexahedron: {
            constexpr std::size_t order[8] = {0, 1, 3, 2, 4, 5, 7, 6}; // node by the bits w v u
            for (std::size_t i = 0; i < 8; ++i)
                c[i] = value(order[i]);
            for (const std::size_t bit : {1u, 2u, 4u})
                for (std::size_t i = 0; i < 8; ++i)
                    if (i & bit)
                        c[i] = c[i] - c[i ^ bit];
            return;
        }
        case CellShape::Tetrahedron:
            c[0] = value(0);
            c[1] = value(1) - c[0];
            c[2] = value(2) - c[0];
            c[4] = value(3) - c[0];
            c[3] = c[5] = c[6] = c[7] = {};
            return;
        case CellShape::Wedge: {
            const Components top = value(3);
            c[0] = value(0);
            c[1] = value(1) - c[0];
            c[2] = value(2) - c[0];
            c[4] = top - c[0];
            c[5] = (value(4) - top) - c[1];
            c[6] = (value(5) - top) - c[2];
            c[3] = c[7] = {};
            return;
        }
        case CellShape::Pyramid:
            c[0] = value(0);
            c[1] = value(1) - c[0];
            c[2] = value(3) - c[0];
            c[3] = (value(2) - value(1)) - c[2];
            c[4] = value(4) - c[0];
            c[5] = c[6] = c[7] = {};
        }
    }

    Components at(bool pyramid, const Vec3& u) const {
        if (pyramid)
            return ((c[0] + c[1] * u.x) + c[2] * u.y) +
                   (c[4] * u.z + c[3] * (PyramidRatios(u).r * u.y));
        const Components along_u = (c[1] + c[3] * u.y) + (c[5] + c[7] * u.y) * u.z;
        const Components along_v = c[2] + c[6] * u.z;
        return (c[0] + c[4] * u.z) + (along_u * u.x + along_v * u.y);
    }

    /// Evaluates without the constant; m are the values of the other monomials.
    Components rest(const double (&m)[7]) const {
        return ((c[1] * m[0] + c[2] * m[1]) + (c[3] * m[2] + c[4] * m[3])) +
               ((c[5] * m[4] + c[6] * m[5]) + c[7] * m[6]);
    }

    /// Returns the change along each local coordinate.
    std::array<Components, 3> slopes(bool pyramid, const Vec3& u) const {
        if (pyramid) {
            const PyramidRatios ratio(u);
            return {c[1] + c[3] * ratio.s, c[2] + c[3] * ratio.r,
                    c[4] + c[3] * (ratio.r * ratio.s)};
        }
        const Components both = c[6] + c[7] * u.x;
        return {(c[1] + c[3] * u.y) + (c[5] + c[7] * u.y) * u.z, (c[2] + c[3] * u.x) + both * u.z,
                (c[4] + c[5] * u.x) + both * u.y};
    }
};

} // namespace wakesurf::core
