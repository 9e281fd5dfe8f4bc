// A particle's path within one cell as a Taylor series. Position and velocity are polynomials of the local
// coordinates, so the terms of x(u(t)) and v(u(t)) follow from those of u(t), and from x' = v follows the
// next term of u: a linear equation with the Jacobian at the start, whatever the order. Source: Hairer,
// Norsett, Wanner, Solving ODEs I, I.8.
#pragma once

#include "core/field/cells/cell_geometry.hpp"
#include "core/integrate/path_series.hpp"

#include <limits>

namespace wakesurf::core {

/// The series of a path in space and in the coordinates of its cell. Times run from 0, downstream or upstream.
template <std::size_t Order>
struct CellSeries {
    PathSeriesOf<Order> space;
    PathSeriesOf<Order> local;
};

/// The velocity within a cell, linear in time.
struct CellVelocity {
    const CellPolynomial* now;
    const CellPolynomial* change; ///< over the interval; null: steady
    double part;                  ///< of the interval that is over at the start
    double rate;                  ///< parts of the interval a unit of the path's time
};

/// A path of which terms are found as they are needed.
class CellPath {
  public:
    static constexpr std::size_t most = 8;

    /// The path from a place in a cell. @param sign  +1 downstream, -1 upstream
    CellPath(CellGeometry& geometry, const CellVelocity& velocity, const Vec3& u, double sign)
        : geometry_(geometry), velocity_(velocity), start_(u), sign_(sign),
          // At the apex the pyramid's fourth monomial is as small as its height above the apex.
          narrowing_(geometry.pyramid() && 1.0 - u.z > 1e-6 ? 1.0 / (1.0 - u.z) : 0.0), x_{u.x},
          y_{u.y}, z_{u.z}, xy_{u.x * u.y}, xz_{u.x * u.z}, yz_{u.y * u.z}, xyz_{xy_[0] * u.z},
          e_{xy_[0] * narrowing_} {}

    /// Returns the terms up to t^To. The first one in space is left to the caller. REQUIRES: those up to t^From
    /// are known, and the geometry is still that of the cell.
    template <std::size_t From, std::size_t To>
    CellSeries<To> series() {
        static_assert(To <= most);
        for (std::size_t k = From; k < To; ++k)
            find(k + 1);
        CellSeries<To> found;
        for (std::size_t k = 0; k <= To; ++k) {
            found.space.term[k] = space_[k];
            found.local.term[k] = {x_[k], y_[k], z_[k]};
        }
        return found;
    }

  private:
    using Series = std::array<double, most + 1>;

    /// Finds term n. REQUIRES: those before are known.
    void find(std::size_t n) {
        const std::size_t k = n - 1;
        const bool pyramid = geometry_.pyramid();
        const auto& c = geometry_.polynomial().c;
        const double m[7] = {x_[k],  y_[k],  pyramid ? e_[k] : xy_[k], z_[k], xz_[k],
                             yz_[k], xyz_[k]};
        Components v = velocity_.now->rest(m);
        if (k == 0)
            v = v + velocity_.now->c[0];
        if (velocity_.change) {
            Components change = velocity_.change->rest(m);
            if (k == 0)
                change = change + velocity_.change->c[0];
            v = v + change * velocity_.part + changed_ * velocity_.rate;
            changed_ = change;
        }
        const Components next = v * (sign_ / static_cast<double>(n));
        space_[n] = {next.xy[0], next.xy[1], next.z[0]};

        // The contribution of the known terms to the next one of each monomial.
        double xy_known = 0.0, xz_known = 0.0, yz_known = 0.0, xyz_known = 0.0, e_known = 0.0;
        for (std::size_t i = 1; i <= k; ++i) {
            xy_known += x_[i] * y_[n - i];
            xz_known += x_[i] * z_[n - i];
            yz_known += y_[i] * z_[n - i];
            xyz_known += xy_[i] * z_[n - i];
            e_known += z_[i] * e_[n - i];
        }
        xyz_known += xy_known * z_[0];
        e_known = (e_known + xy_known) * narrowing_;
        const Components known =
            pyramid ? c[3] * e_known
                    : (c[3] * xy_known + c[5] * xz_known) + (c[6] * yz_known + c[7] * xyz_known);
        const Vec3 next_u = geometry_.along(start_, (next - known).vector());
        x_[n] = next_u.x;
        y_[n] = next_u.y;
        z_[n] = next_u.z;
        xy_[n] = xy_known + x_[0] * y_[n] + x_[n] * y_[0];
        xz_[n] = xz_known + x_[0] * z_[n] + x_[n] * z_[0];
        yz_[n] = yz_known + y_[0] * z_[n] + y_[n] * z_[0];
        xyz_[n] = xyz_known + xy_[0] * z_[n] + (xy_[n] - xy_known) * z_[0];
        e_[n] = e_known + (xy_[n] - xy_known + z_[n] * e_[0]) * narrowing_;
    }

    CellGeometry& geometry_;
    CellVelocity velocity_;
    Vec3 start_;
    double sign_;
    double narrowing_;
    Components changed_; ///< by the term before, of the change in time
    std::array<std::array<double, 3>, most + 1> space_{};
    /// The local coordinates, and the monomials of them that velocity and position are made of.
    Series x_, y_, z_, xy_, xz_, yz_, xyz_, e_;
};

/// Where a path leaves its cell: a little beyond a face, far enough to be found in the next cell.
class MeshCellExit {
  public:
    /// About where it does, by the first three terms; time is infinite if they never reach a face.
    template <std::size_t Order>
    MeshCellExit(CellShape shape, const PathSeriesOf<Order>& local) : shape_(shape) {
        const auto start = beyond(local, 0), first = beyond(local, 1), second = beyond(local, 2);
        for (std::size_t f = 0; f < 6; ++f) {
            const double ahead = std::max(-start[f], 0.0);
            const double square = first[f] * first[f] + 4.0 * second[f] * ahead;
            if (!(square >= 0.0) || !(first[f] > 0.0 || second[f] > 0.0) || start[f] < -1e200)
                continue;
            const double root = std::sqrt(square);
            const double t = first[f] > 0.0 ? 2.0 * ahead / (first[f] + root)
                                            : (root - first[f]) / (2.0 * second[f]);
            if (t < time) {
                time = t;
                face_ = f;
            }
        }
    }

    /// Finds the time by all terms: the first at which the path is found beyond a face, of those before which it is
    /// looked for. @param expected  it is looked for at this time and at half of it
    template <std::size_t Order>
    void sharpen(const PathSeriesOf<Order>& local, double expected) {
        std::array<std::array<double, 6>, Order + 1> g;
        for (std::size_t k = 0; k <= Order; ++k)
            g[k] = beyond(local, k);
        // Newton's method, by halves where it leads out of what is known.
        const auto reaches = [&g](std::size_t f, double t) {
            double inside = 0.0, outside = never;
            for (int i = 0; i < 20; ++i) {
                double at = g[Order][f], slope = 0.0;
                for (std::size_t k = Order; k-- > 0;) {
                    slope = slope * t + at;
                    at = at * t + g[k][f];
                }
                (at > 0.0 ? outside : inside) = t;
                const double next = t - at / slope;
                if (slope > 0.0 && next >= inside && next <= outside)
                    t = next;
                else if (outside != never)
                    t = 0.5 * (inside + outside);
                else
                    return t;
                if (std::abs(at) <= 0.1 * enough)
                    return t;
            }
            return t;
        };
        if (time != never)
            time = reaches(face_, time);
        // It may have left through another face by then, also for a while.
        for (const double last : {never, expected, 0.5 * expected}) {
            const double there = std::min(time, last);
            if (there == never)
                continue;
            for (std::size_t f = 0; f < 6; ++f) {
                double at = g[Order][f];
                for (std::size_t k = Order; k-- > 0;)
                    at = at * there + g[k][f];
                if (at > 2.0 * enough)
                    time = std::min(time, reaches(f, there));
            }
        }
    }

    /// Returns true where the path has not left its cell at a time and at half of it.
    template <std::size_t Order>
    bool is_after(const PathSeriesOf<Order>& local, double t) const {
        const auto inside_at = [&](double when) {
            return inside_cell(shape_, {local.at(0, when), local.at(1, when), local.at(2, when)});
        };
        return t < time && inside_at(t) && inside_at(0.5 * t);
    }

    static constexpr double never = std::numeric_limits<double>::infinity();
    double time = never;

  private:
    /// Part of a cell. A path that goes so far on with the velocity of the cell it has left is off by about the square
    /// of this.
    static constexpr double enough = 1e-7;

    /// Returns how far beyond each face the path is by term k; the first one less what is enough.
    template <std::size_t Order>
    std::array<double, 6> beyond(const PathSeriesOf<Order>& local, std::size_t k) const {
        auto g = beyond_faces(shape_, local.sized(k, Vec3(1.0)), k == 0 ? 1.0 : 0.0);
        for (double& each : g)
            each -= k == 0 ? enough : 0.0;
        return g;
    }

    CellShape shape_;
    std::size_t face_ = 0;
};

} // namespace wakesurf::core
