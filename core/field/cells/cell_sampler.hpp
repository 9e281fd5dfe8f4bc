// The stored field of a cell mesh between its nodes: VTK's shape functions in space, linear in time. A pair
// of time-steps, or one for a frozen field. Mirrors what vtkProbeFilter returns. In a tetrahedron the stored
// velocity is linear, and a steady path has a closed form by the exponential of its matrix: Scheuermann,
// Bobach, Hagen, Mahrous, Hamann, Joy, Kollmann, A Tetrahedra-Based Stream Surface Algorithm, 2001.
#pragma once

#include "core/base/vec3.hpp"
#include "core/dataset/cell_mesh.hpp"
#include "core/field/cells/cell_cursor.hpp"
#include "core/field/cells/cell_geometry.hpp"
#include "core/field/cells/cell_path.hpp"
#include "core/integrate/at_rest.hpp"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace wakesurf::core {

/// Returns how far a particle of velocity `v` has gone after a time t >= 0, where velocity changes by `slope`
/// times the way: the integral of exp(slope t) v, to rounding. It sums the exponential's series in pieces of
/// the time within which it has no cancellation.
inline Vec3 linear_way(const glm::dmat3& slope, const Vec3& v, double t) {
    double norm = 0.0;
    for (int column = 0; column < 3; ++column) {
        const Vec3 entries = glm::abs(slope[column]);
        norm = std::max(norm, entries.x + entries.y + entries.z);
    }
    const double pieces =
        std::clamp(std::ceil(norm * t), 1.0, 1e4); // 1e4: of e^10000 nothing is left in a cell
    const double h = t / pieces;
    Vec3 way(0.0);
    for (double piece = 0.0; piece < pieces; ++piece) {
        Vec3 term = (v + slope * way) * h;
        Vec3 sum = term;
        for (double k = 2.0; k < 30.0 && glm::dot(term, term) > 1e-34 * glm::dot(sum, sum); ++k) {
            term = slope * term * (h / k);
            sum += term;
        }
        way += sum;
    }
    return way;
}

/// Turns places about the axis of an axisymmetric mesh into its half plane, and vectors back. It keeps the
/// turn of the last place. Without an axis it changes nothing.
class Meridian {
  public:
    explicit Meridian(const std::optional<SymmetryAxis>& axis) : axis_(axis) {
        if (axis_)
            around_ = glm::cross(axis_->direction, axis_->radial);
    }

    explicit operator bool() const { return axis_.has_value(); }

    /// Turns a place into the half plane, and what follows by the same angle.
    Vec3 enter(const Vec3& p) {
        if (!axis_)
            return p;
        const Vec3 from = p - axis_->origin;
        const double along = glm::dot(from, axis_->direction);
        const double x = glm::dot(from, axis_->radial);
        const double y = glm::dot(from, around_);
        const double radius = std::hypot(x, y);
        cos_ = radius > 0.0 ? x / radius : 1.0;
        sin_ = radius > 0.0 ? y / radius : 0.0;
        return axis_->origin + along * axis_->direction + radius * axis_->radial;
    }

    /// Turns a vector back.
    Vec3 back(const Vec3& v) const { return turned(v, sin_); }

    /// Turns a vector as the place was.
    Vec3 into(const Vec3& v) const { return turned(v, -sin_); }

  private:
    Vec3 turned(const Vec3& v, double sine) const {
        if (!axis_)
            return v;
        const double x = glm::dot(v, axis_->radial);
        const double y = glm::dot(v, around_);
        return v + (cos_ * x - sine * y - x) * axis_->radial + (sine * x + cos_ * y - y) * around_;
    }

    std::optional<SymmetryAxis> axis_;
    Vec3 around_{0.0};
    double cos_ = 1.0;
    double sin_ = 0.0;
};

class CellSamplerCursor;
template <class Cursor, std::size_t Order>
class CellStepsOf;
using CellSteps = CellStepsOf<CellSamplerCursor, PathSeries::order>;
using SharedCellSteps = CellStepsOf<const CellSamplerCursor&, PathSeries::order>;
using CellParticleSteps = CellStepsOf<const CellSamplerCursor&, CellPath::most>;
struct TraceOptions;

/// Keeps no state: every call finds its cell again. Particles take a cursor. Thread safety: concurrent calls
/// are fine.
struct CellSampler {
    const CellDomain* domain;
    const float* velocity0;
    const float* velocity1; ///< null: frozen at the first
    double time0 = 0.0;
    double interval = 1.0;
    bool gaps = false; ///< velocities that are not finite occur: outside the domain there

    /// Returns false for a cell with gaps, of which nothing is used.
    bool usable(std::uint32_t cell) const {
        if (!gaps)
            return true;
        const MeshCell& each = domain->mesh.cells[cell];
        for (std::size_t i = 0; i < node_count(each.shape); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t at = 3 * std::size_t{each.node[i]} + axis;
                if (!std::isfinite(velocity0[at]) || (velocity1 && !std::isfinite(velocity1[at])))
                    return false;
            }
        return true;
    }

    /// Returns a sampler for one particle, which remembers its cell.
    CellSamplerCursor cursor() const;

    /// Returns the steps of one curve.
    CellSteps series_steps(const TraceOptions& options, double sign) const;

    /// Outside the domain that of the nearest place in a near cell; zero where there is none.
    Vec3 velocity(const Vec3& p, double t) const;

    /// Returns (grad v) w, the exact derivative within the cell.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const;

    PointStatus status(const Vec3& p) const;

    /// Implements FieldOfTimeSteps.
    bool stands_still() const { return velocity1 == nullptr; }

    bool at_wall(const Vec3& p) const;

    double cell_speed(const Vec3& p, double t) const;
};

/// The field as one particle asks for it, one thread at a time: const only in that it answers the same.
class CellSamplerCursor {
  public:
    explicit CellSamplerCursor(const CellSampler& field)
        : field_(field), place_(*field.domain), meridian_(field.domain->mesh.axis) {}

    /// Begins with another particle: see CellCursor.
    void restart(std::uint32_t guess = CellCursor::nowhere) const { place_.restart(guess); }

    /// Returns the steps of the curve that has the cursor.
    SharedCellSteps series_steps(const TraceOptions& options, double sign) const;

    /// Returns the steps of a particle of whose way nothing is kept: only their ends are as exact as the options ask.
    CellParticleSteps particle_steps(const TraceOptions& options, double sign) const;

    Vec3 velocity(const Vec3& p, double t) const {
        if (!go_to(p, false))
            return field_.gaps ? meridian_.back(beside_gap(meridian_.enter(p), t)) : Vec3(0.0);
        const bool pyramid = place_.geometry().pyramid();
        const Fit& fit = fit_[here_];
        const Components v = fit.now.at(pyramid, place_.local());
        if (!field_.velocity1)
            return meridian_.back(v.vector());
        const double part = (t - field_.time0) / field_.interval;
        return meridian_.back((v + fit.change.at(pyramid, place_.local()) * part).vector());
    }

    /// Returns the velocities at the times of both time-steps.
    std::array<Vec3, 2> ends(const Vec3& p) const {
        if (!go_to(p, false) || !field_.velocity1) {
            const Vec3 v = velocity(p, field_.time0);
            return {v, velocity(p, field_.time0 + field_.interval)};
        }
        const bool pyramid = place_.geometry().pyramid();
        const Fit& fit = fit_[here_];
        const Components v = fit.now.at(pyramid, place_.local());
        const Components then = v + fit.change.at(pyramid, place_.local());
        return {meridian_.back(v.vector()), meridian_.back(then.vector())};
    }

    /// Returns 1 away from walls, falling to 0 in the cells beside one, 0 where there is no velocity.
    double open_share(const Vec3& p) const {
        const CellDomain& domain = *field_.domain;
        const PointStatus there = place_.locate(
            meridian_.enter(p), false, [&](std::uint32_t cell) { return field_.usable(cell); });
        return there == PointStatus::Inside
                   ? 1.0 - domain.walls.share(domain.mesh, place_.cell(), place_.local())
                   : 0.0;
    }

    bool bounded() const { return true; }

    /// Returns (grad v) w at local coordinates of the present cell, as a function of w. REQUIRES: a velocity
    /// or a path has been asked for; the function is used before anything else is.
    auto gradient_here(const Vec3& local, double t) const {
        const bool pyramid = place_.geometry().pyramid();
        const Fit& fit = fit_[here_];
        auto slope = fit.now.slopes(pyramid, local);
        if (field_.velocity1) {
            const auto change = fit.change.slopes(pyramid, local);
            const double part = (t - field_.time0) / field_.interval;
            for (std::size_t i = 0; i < 3; ++i)
                slope[i] = slope[i] + change[i] * part;
        }
        return [this, local, slope](const Vec3& w) {
            const Vec3 u = place_.geometry().along(local, meridian_.into(w));
            return meridian_.back((slope[0] * u.x + slope[1] * u.y + slope[2] * u.z).vector());
        };
    }

    /// Returns (grad v) w as a function of w, which is used before anything else is.
    auto gradient(const Vec3& p, double t) const {
        const bool known = go_to(p, false);
        return [known, here = gradient_here(place_.local(), t)](const Vec3& w) {
            return known ? here(w) : Vec3(0.0);
        };
    }

    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const { return gradient(p, t)(w); }

    /// The path of a particle that is at `p`, inside, at field time `t`. It is used before anything else is.
    /// @param sign  +1 downstream, -1 upstream
    CellPath path(const Vec3& p, double t, double sign, bool frozen) const {
        go_to(p, true);
        const Fit& fit = fit_[here_];
        CellVelocity velocity{&fit.now, nullptr, 0.0, 0.0};
        if (field_.velocity1)
            velocity = {&fit.now, &fit.change, (t - field_.time0) / field_.interval,
                        frozen ? 0.0 : sign / field_.interval};
        return {place_.geometry(), velocity, place_.local(), sign};
    }

    /// Returns the series of a path from `p` up to t^To. REQUIRES: the terms up to t^From have been asked for.
    template <std::size_t From, std::size_t To>
    CellSeries<To> series(CellPath& path, const Vec3& p) const {
        CellSeries<To> found = path.series<From, To>();
        if (meridian_)
            for (auto& term : found.space.term) {
                const Vec3 turned = meridian_.back({term[0], term[1], term[2]});
                term = {turned.x, turned.y, turned.z};
            }
        found.space.term[0] = {p.x, p.y, p.z};
        return found;
    }

    /// Returns how far the particle at `p`, inside, goes in a time t >= 0, if it stays in its cell and the
    /// field is linear there and steady, by the closed form; otherwise nothing.
    std::optional<Vec3>
    linear_way(const Vec3& p, double at, double sign, bool frozen, double t) const {
        if ((field_.velocity1 && !frozen) || !go_to(p, true) ||
            place_.geometry().shape() != CellShape::Tetrahedron)
            return std::nullopt;
        glm::dmat3 slope;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 unit(0.0);
            unit[axis] = sign;
            slope[axis] = derivative(p, at, unit);
        }
        return core::linear_way(slope, sign * velocity(p, at), t);
    }

    /// Returns the status of the particle at `p`, which may continue from there.
    PointStatus status(const Vec3& p) const {
        return place_.locate(meridian_.enter(p), true,
                             [&](std::uint32_t cell) { return field_.usable(cell); });
    }

    /// Returns the place of a particle that came to `p`, inside: on the side of the fluid if it slides
    /// along that and came beyond it by rounding.
    Vec3 settled(const Vec3& p) const {
        const Vec3 in_mesh = meridian_.enter(p);
        status(p);
        const Vec3 off = place_.on_side() - in_mesh;
        return off == Vec3(0.0) ? p : p + meridian_.back(off);
    }

    bool stands_still() const { return field_.stands_still(); }

    /// Implements FieldWithWalls::at_wall, also at the edge or the corner of a wall, in a cell that only
    /// touches it there.
    bool at_wall(const Vec3& p) const {
        const CellDomain& domain = *field_.domain;
        return go_to(p, false) &&
               domain.walls.share(domain.mesh, place_.cell(), place_.local()) >= 1.0 - near_wall;
    }

    /// Implements FieldOfCells.
    double cell_speed(const Vec3& p, double t) const {
        if (!go_to(p, false))
            return 0.0;
        const MeshCell& cell = field_.domain->mesh.cells[place_.cell()];
        double fastest = 0.0;
        for (std::size_t i = 0; i < node_count(cell.shape); ++i)
            fastest = std::max(fastest, glm::length(at_node(cell.node[i], t)));
        return fastest;
    }

    const CellCursor& place() const { return place_; }

  private:
    /// The velocity of a cell.
    struct Fit {
        std::uint32_t cell = CellCursor::nowhere;
        CellPolynomial now;
        CellPolynomial change;
    };

    Vec3 at_node(std::size_t node, double t) const {
        const auto at = [&](const float* velocity) {
            const float* v = velocity + 3 * node;
            return Vec3(v[0], v[1], v[2]);
        };
        const Vec3 v = at(field_.velocity0);
        return field_.velocity1
                   ? v + (t - field_.time0) / field_.interval * (at(field_.velocity1) - v)
                   : v;
    }

    /// Returns the velocity in or near a cell with a gap: the mean of its nodes that have one, by their
    /// shares. It meets the field at faces without a gap.
    Vec3 beside_gap(const Vec3& p, double t) const {
        const CellDomain& domain = *field_.domain;
        CellGeometry geometry;
        auto place = domain.locator.find(p, geometry);
        if (const auto near = place ? std::nullopt : domain.locator.near(p)) {
            geometry.enter(domain.mesh, *near);
            if (geometry.flat())
                return Vec3(0.0);
            place = CellPlace{*near, cell_centre(geometry.shape())};
            geometry.invert(p, place->local);
            place->local = clamp_to_cell(geometry.shape(), place->local);
        }
        Vec3 total(0.0);
        double weights = 0.0;
        const NodeShares shares =
            place ? shares_in_cell(domain.mesh.cells[place->cell], geometry, place->local)
                  : NodeShares{};
        for (std::size_t i = 0; i < shares.count; ++i) {
            const Vec3 v = at_node(shares.node[i], t);
            if (!finite(v))
                continue;
            const double weight = std::max(shares.share[i], 0.0) + 1e-9;
            total += weight * v;
            weights += weight;
        }
        return weights > 0.0 ? total / weights : Vec3(0.0);
    }

    /// Returns false where there is no velocity at all.
    bool go_to(const Vec3& p, bool stays) const {
        place_.locate(meridian_.enter(p), stays,
                      [&](std::uint32_t cell) { return field_.usable(cell); });
        if (place_.cell() == CellCursor::nowhere)
            return false;
        if (place_.cell() == fit_[here_].cell)
            return true;
        here_ = 1 - here_;
        if (place_.cell() == fit_[here_].cell)
            return true;
        Fit& fit = fit_[here_];
        fit.cell = place_.cell();
        const MeshCell& cell = field_.domain->mesh.cells[fit.cell];
        const auto node = [&](const float* velocity) {
            return [&cell, velocity](std::size_t i) {
                const float* v = velocity + 3 * std::size_t{cell.node[i]};
                Components value;
                value.xy = Components::Pair{v[0], v[1]};
                value.z = Components::Pair{v[2], 0.0};
                return value;
            };
        };
        fit.now.fit(cell.shape, node(field_.velocity0));
        if (field_.velocity1) {
            fit.change.fit(cell.shape, node(field_.velocity1));
            for (std::size_t i = 0; i < 8; ++i)
                fit.change.c[i] = fit.change.c[i] - fit.now.c[i];
        }
        return true;
    }

    CellSampler field_;
    mutable CellCursor place_;
    mutable Meridian meridian_;
    mutable std::array<Fit, 2> fit_; ///< of the last two cells: particles near a face go to and fro
    mutable std::size_t here_ = 0;   ///< that of the present cell
};

inline CellSamplerCursor CellSampler::cursor() const {
    return CellSamplerCursor(*this);
}

inline Vec3 CellSampler::velocity(const Vec3& p, double t) const {
    return cursor().velocity(p, t);
}

inline Vec3 CellSampler::derivative(const Vec3& p, double t, const Vec3& w) const {
    return cursor().derivative(p, t, w);
}

inline PointStatus CellSampler::status(const Vec3& p) const {
    return cursor().status(p);
}

inline bool CellSampler::at_wall(const Vec3& p) const {
    return cursor().at_wall(p);
}

inline double CellSampler::cell_speed(const Vec3& p, double t) const {
    return cursor().cell_speed(p, t);
}

} // namespace wakesurf::core
