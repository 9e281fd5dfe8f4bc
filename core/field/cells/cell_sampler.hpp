// The stored field of a cell mesh between its nodes: VTK's shape functions in space, linear in time. A pair of
// time-steps, or one for a frozen field. Mirrors what vtkProbeFilter returns.
#pragma once

#include "core/field/cells/cell_cursor.hpp"
#include "core/field/cells/cell_path.hpp"
#include "core/integrate/at_rest.hpp"

#include <array>
#include <cmath>
#include <span>

namespace wakesurf::core {

class CellSamplerCursor;
class CellSteps;
struct TraceOptions;

/// Stateless: every call finds its cell again. Particles take a cursor. Thread safety: concurrent calls are fine.
struct CellSampler {
    const CellDomain* domain;
    const float* velocity0;
    const float* velocity1; ///< null: frozen at the first
    double time0 = 0.0;
    double interval = 1.0;
    bool gaps = false; ///< velocities that are not finite occur: outside the domain there

    /// Of a cell with gaps nothing is used.
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

    /// The same, for one particle: remembers its cell.
    CellSamplerCursor cursor() const;

    /// Of one curve. @param sign  +1 downstream, -1 upstream
    CellSteps series_steps(const TraceOptions& options, double sign) const;

    /// Outside the domain that of the nearest place in a near cell; zero where there is none.
    Vec3 velocity(const Vec3& p, double t) const;

    /// (grad v) w: the exact derivative within the cell.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const;

    /// Of one or two vectors `w`.
    std::array<Vec3, 2> derivatives(const Vec3& p, double t, std::span<const Vec3> w) const;

    PointStatus status(const Vec3& p) const;

    bool at_wall(const Vec3& p) const;
};

/// The field as one particle asks for it, one thread at a time: const only in that it answers the same.
class CellSamplerCursor {
  public:
    explicit CellSamplerCursor(const CellSampler& field) : field_(field), place_(*field.domain) {}

    Vec3 velocity(const Vec3& p, double t) const {
        if (!go_to(p, false))
            return Vec3(0.0);
        const bool pyramid = place_.geometry().pyramid();
        const Components v = now_.at(pyramid, place_.local());
        if (!field_.velocity1)
            return v.vector();
        const double part = (t - field_.time0) / field_.interval;
        return (v + change_.at(pyramid, place_.local()) * part).vector();
    }

    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        return derivatives(p, t, {&w, 1})[0];
    }

    std::array<Vec3, 2> derivatives(const Vec3& p, double t, std::span<const Vec3> w) const {
        std::array<Vec3, 2> result{};
        if (!go_to(p, false))
            return result;
        const bool pyramid = place_.geometry().pyramid();
        auto slope = now_.slopes(pyramid, place_.local());
        if (field_.velocity1) {
            const auto change = change_.slopes(pyramid, place_.local());
            const double part = (t - field_.time0) / field_.interval;
            for (std::size_t i = 0; i < 3; ++i)
                slope[i] = slope[i] + change[i] * part;
        }
        for (std::size_t i = 0; i < w.size(); ++i) {
            const Vec3 u = place_.geometry().along(place_.local(), w[i]);
            result[i] = (slope[0] * u.x + slope[1] * u.y + slope[2] * u.z).vector();
        }
        return result;
    }

    /// The path of a particle that is at `p`, inside, at field time `t`. @param sign  +1 downstream, -1 upstream
    CellPath path(const Vec3& p, double t, double sign, bool frozen) const {
        go_to(p, true);
        CellVelocity velocity{&now_, nullptr, 0.0, 0.0};
        if (field_.velocity1)
            velocity = {&now_, &change_, (t - field_.time0) / field_.interval,
                        frozen ? 0.0 : sign / field_.interval};
        return cell_path(place_.geometry(), velocity, p, place_.local(), sign);
    }

    /// Says that the particle is at `p` now, and may go on from there.
    PointStatus status(const Vec3& p) const {
        return place_.locate(p, true, [&](std::uint32_t cell) { return field_.usable(cell); });
    }

    /// See FieldWithWalls. Also at the edge or the corner of a wall, in a cell that only touches it there.
    bool at_wall(const Vec3& p) const {
        const CellDomain& domain = *field_.domain;
        return go_to(p, false) &&
               domain.walls.share(domain.mesh, place_.cell(), place_.local()) >= 1.0 - near_wall;
    }

    const CellCursor& place() const { return place_; }

  private:
    /// Returns false where there is no velocity at all.
    bool go_to(const Vec3& p, bool stays) const {
        place_.locate(p, stays, [&](std::uint32_t cell) { return field_.usable(cell); });
        if (place_.cell() == fitted_)
            return fitted_ != CellCursor::nowhere;
        fitted_ = place_.cell();
        const MeshCell& cell = field_.domain->mesh.cells[fitted_];
        const auto node = [&](const float* velocity) {
            return [&cell, velocity](std::size_t i) {
                const float* v = velocity + 3 * std::size_t{cell.node[i]};
                Components value;
                value.xy = Components::Pair{v[0], v[1]};
                value.z = Components::Pair{v[2], 0.0};
                return value;
            };
        };
        now_.fit(cell.shape, node(field_.velocity0));
        if (field_.velocity1) {
            change_.fit(cell.shape, node(field_.velocity1));
            for (std::size_t i = 0; i < 8; ++i)
                change_.c[i] = change_.c[i] - now_.c[i];
        }
        return true;
    }

    CellSampler field_;
    mutable CellCursor place_;
    mutable std::uint32_t fitted_ = CellCursor::nowhere; ///< the cell of the polynomials
    mutable CellPolynomial now_;
    mutable CellPolynomial change_;
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

inline std::array<Vec3, 2>
CellSampler::derivatives(const Vec3& p, double t, std::span<const Vec3> w) const {
    return cursor().derivatives(p, t, w);
}

inline PointStatus CellSampler::status(const Vec3& p) const {
    return cursor().status(p);
}

inline bool CellSampler::at_wall(const Vec3& p) const {
    return cursor().at_wall(p);
}

} // namespace wakesurf::core
