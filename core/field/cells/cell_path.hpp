// A particle's path within one cell as a Taylor series. Position and velocity are polynomials of the local
// coordinates, so the terms of x(u(t)) and v(u(t)) follow from those of u(t), and from x' = v follows the
// next term of u: a linear equation with the Jacobian at the start, whatever the order. Source: Hairer,
// Norsett, Wanner, Solving ODEs I, I.8.
#pragma once

#include "core/field/cells/cell_geometry.hpp"
#include "core/integrate/path_series.hpp"

#include <limits>

namespace wakesurf::core {

/// Times run from 0, downstream or upstream.
struct CellPath {
    PathSeries space;
    PathSeries local;
};

/// The velocity within a cell, linear in time.
struct CellVelocity {
    const CellPolynomial* now;
    const CellPolynomial* change; ///< over the interval; null: steady
    double part;                  ///< of the interval that is over at the start
    double rate;                  ///< parts of the interval a unit of the path's time
};

/// Computes the path from `p`, which is at `u` in the cell. @param sign  +1 downstream, -1 upstream
inline CellPath cell_path(CellGeometry& geometry,
                          const CellVelocity& velocity,
                          const Vec3& p,
                          const Vec3& u,
                          double sign) {
    constexpr std::size_t order = PathSeries::order;
    using Series = std::array<double, order + 1>;
    const bool pyramid = geometry.pyramid();
    const auto& c = geometry.polynomial().c;
    // At the apex the pyramid's fourth monomial is as small as its height above the apex.
    const double narrowing = pyramid && 1.0 - u.z > 1e-6 ? 1.0 / (1.0 - u.z) : 0.0;
    Series x{u.x}, y{u.y}, z{u.z};
    Series xy{u.x * u.y}, xz{u.x * u.z}, yz{u.y * u.z}, xyz{xy[0] * u.z}, e{xy[0] * narrowing};
    CellPath path;
    path.space.term[0] = {p.x, p.y, p.z};
    path.local.term[0] = {u.x, u.y, u.z};
    Components changed;
    for (std::size_t k = 0; k < order; ++k) {
        const double m[7] = {x[k], y[k], pyramid ? e[k] : xy[k], z[k], xz[k], yz[k], xyz[k]};
        Components v = velocity.now->rest(m);
        if (k == 0)
            v = v + velocity.now->c[0];
        if (velocity.change) {
            Components change = velocity.change->rest(m);
            if (k == 0)
                change = change + velocity.change->c[0];
            v = v + change * velocity.part + changed * velocity.rate;
            changed = change;
        }
        const Components next = v * (sign / static_cast<double>(k + 1));
        path.space.term[k + 1] = {next.xy[0], next.xy[1], next.z[0]};

        // The contribution of the known terms to the next one of each monomial.
        double xy_known = 0.0, xz_known = 0.0, yz_known = 0.0, xyz_known = 0.0, e_known = 0.0;
        for (std::size_t i = 1; i <= k; ++i) {
            xy_known += x[i] * y[k + 1 - i];
            xz_known += x[i] * z[k + 1 - i];
            yz_known += y[i] * z[k + 1 - i];
            xyz_known += xy[i] * z[k + 1 - i];
            e_known += z[i] * e[k + 1 - i];
        }
        xyz_known += xy_known * z[0];
        e_known = (e_known + xy_known) * narrowing;
        const Components known =
            pyramid ? c[3] * e_known
                    : (c[3] * xy_known + c[5] * xz_known) + (c[6] * yz_known + c[7] * xyz_known);
        const Vec3 next_u = geometry.along(u, (next - known).vector());
        path.local.term[k + 1] = {next_u.x, next_u.y, next_u.z};
        x[k + 1] = next_u.x;
        y[k + 1] = next_u.y;
        z[k + 1] = next_u.z;
        xy[k + 1] = xy_known + x[0] * y[k + 1] + x[k + 1] * y[0];
        xz[k + 1] = xz_known + x[0] * z[k + 1] + x[k + 1] * z[0];
        yz[k + 1] = yz_known + y[0] * z[k + 1] + y[k + 1] * z[0];
        xyz[k + 1] = xyz_known + xy[0] * z[k + 1] + (xy[k + 1] - xy_known) * z[0];
        e[k + 1] = e_known + (xy[k + 1] - xy_known + z[k + 1] * e[0]) * narrowing;
    }
    return path;
}

/// Returns the time at which a path is a little beyond a face of its cell, far enough to be found in the next
/// one; infinite if the series' first three terms never reach it.
inline double leaves_cell(CellShape shape, const PathSeries& local) {
    constexpr double beyond =
        1e-7; // of a cell: what the field's kink there turns the path by is its square
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr std::size_t order = PathSeries::order;
    std::array<std::array<double, 6>, order + 1> g; // how far beyond each face, less what is enough
    const auto none = beyond_faces(shape, Vec3(0.0));
    for (std::size_t k = 0; k <= order; ++k) {
        g[k] = beyond_faces(shape, {local.term[k][0], local.term[k][1], local.term[k][2]});
        for (std::size_t f = 0; f < 6; ++f)
            g[k][f] -= k == 0 ? beyond : none[f];
    }
    const auto sharpen = [&](std::size_t f, double t) {
        for (int i = 0; i < 8; ++i) {
            double at = g[order][f], slope = 0.0;
            for (std::size_t k = order; k-- > 0;) {
                slope = slope * t + at;
                at = at * t + g[k][f];
            }
            if (!(slope > 0.0))
                return t;
            const double change = at / slope;
            t = std::max(t - change, 0.0);
            if (std::abs(at) <= 0.1 * beyond)
                return t;
        }
        return t;
    };
    std::size_t face = 0;
    double first = infinite;
    for (std::size_t f = 0; f < 6; ++f) {
        const double ahead = std::max(-g[0][f], 0.0);
        const double square = g[1][f] * g[1][f] + 4.0 * g[2][f] * ahead;
        if (!(square >= 0.0) || !(g[1][f] > 0.0 || g[2][f] > 0.0) || g[0][f] < -1e200)
            continue;
        const double root = std::sqrt(square);
        const double t =
            g[1][f] > 0.0 ? 2.0 * ahead / (g[1][f] + root) : (root - g[1][f]) / (2.0 * g[2][f]);
        if (t < first) {
            first = t;
            face = f;
        }
    }
    if (first == infinite)
        return first;
    first = sharpen(face, first);
    const auto all_at = [&](double t) {
        std::array<double, 6> at = g[order];
        for (std::size_t k = order; k-- > 0;)
            for (std::size_t f = 0; f < 6; ++f)
                at[f] = at[f] * t + g[k][f];
        return at;
    };
    auto at = all_at(first);
    for (std::size_t f = 0; f < 6; ++f)
        if (f != face && at[f] > 2.0 * beyond) {
            first = std::min(first, sharpen(f, first));
            at = all_at(first);
        }
    return first;
}

} // namespace wakesurf::core
