// Steps along a curve through a mesh of cells, cell by cell: each follows the Taylor series of the particle's
// path (cell_path.hpp) and ends a little beyond the face through which that leaves the cell. In tetrahedra of
// a steady field the ends are exact (linear_way in cell_sampler.hpp).
#pragma once

#include "core/field/cells/cell_sampler.hpp"
#include "core/integrate/advance_curve.hpp"
#include "core/integrate/grazing_steps.hpp"
#include "core/integrate/runge_kutta.hpp"

#include <algorithm>

namespace wakesurf::core {

/// Makes Dormand-Prince steps of the same tolerance, but as long as the cells; a CurveSteps. It keeps a
/// reference to the options.
/// @tparam Cursor  a cursor, or a reference to one that serves particle after particle
/// @tparam Order  5: dense output is as exact as a step's end. 8: only the ends are exact, and five terms are used
///                where they do for the step
template <class Cursor, std::size_t Order>
class CellStepsOf {
  public:
    /// Tangents are carried in so many parts of a step: one of eight terms may turn them by a radian.
    static constexpr int tangent_steps = Order > PathSeries::order ? 2 : 1;

    /// @param sign  +1 downstream, -1 upstream
    CellStepsOf(Cursor cursor, const TraceOptions& options, double sign)
        : field_(static_cast<Cursor>(cursor)), options_(options), sign_(sign) {}

    const CellSamplerCursor& field() const { return field_; }

    /// Other time-steps may have gaps where these had none.
    PointStatus begin(Curve& curve) {
        const PointStatus status = field_.status(curve.last.position);
        if (status == PointStatus::Inside)
            curve.last.position = field_.settled(curve.last.position);
        return status;
    }

    StepOutcome attempt(const Curve& curve, double left, CurveStep& step) {
        const double time = options_.frozen ? curve.release : curve.release + curve.last.time;
        CellPath path = field_.path(curve.last.position, time, sign_, options_.frozen);
        const auto [space, local] = field_.template series<0, 5>(path, curve.last.position);
        const double speed = glm::length(space.sized(1, Vec3(1.0)));
        const bool rests = !(speed > options_.stagnation_speed);
        if (rests && ends_at_rest(field_, curve.last.position, time, speed, options_.frozen))
            return StepOutcome::Stagnation;
        const Vec3 pace = glm::abs(local.sized(1, Vec3(1.0)));
        const double crossing = rests ? left : 1.0 / std::max(std::max(pace.x, pace.y), pace.z);
        MeshCellExit exit(field_.place().geometry().shape(), local);
        const double most = std::min(1e3 * crossing, left); // it may circle in its cell for ever
        if constexpr (Order == PathSeries::order)
            exit.sharpen(local, std::min(exit.time, most));
        const double least = grazing_.least(exit.time / crossing) * crossing;
        const double shortest = GrazingSteps::shortest * crossing;
        const double allowed = allowed_error(options_, rests, speed, left);
        const auto until_exit = [&] { return std::min(std::max(exit.time, least), most); };
        double t = until_exit();
        if constexpr (Order == PathSeries::order) {
            const auto shortened =
                series_step(space, Vec3(0.0), Vec3(1.0), curve.last.arc, allowed, t, shortest);
            if (!shortened)
                return StepOutcome::Stagnation;
            step = *shortened;
            local_ = local;
        } else {
            // Where something else ends the step, the time of the exit need not be known.
            const auto sharpen = [&](const auto& series) {
                for (int i = 0; i < 4 && !exit.is_after(series, t); ++i) {
                    const bool ends_step = t >= until_exit();
                    exit.sharpen(series, t);
                    const double now = until_exit();
                    if (now <= t || !ends_step) {
                        t = std::min(t, now);
                        return;
                    }
                    t = now; // later than expected: what lies between has not been looked at
                }
            };
            const auto is_enough = [&, &five = space] {
                return t <= shortest || end_error(five, Vec3(1.0), t) <= allowed * t;
            };
            bool enough = is_enough();
            if (enough) {
                sharpen(local);
                enough = is_enough();
            }
            if (enough) {
                go(space, local, t, step);
            } else {
                const auto more = field_.template series<5, Order>(path, curve.last.position);
                shorten_to(allowed, more.space, t, shortest);
                sharpen(more.local);
                shorten_to(allowed, more.space, t, shortest);
                go(more.space, more.local, t, step);
            }
        }
        step.dt = sign_ * t;
        // In a tetrahedron of a steady field the step ends where the closed form says; the series says where
        // it passes.
        if (const auto way =
                field_.linear_way(curve.last.position, time, sign_, options_.frozen, t))
            step.c[1] = glm::dvec4(*way, step.c[1].w);
        return StepOutcome::Taken;
    }

    /// Returns (grad v) w at theta of the last step, as a function of w. REQUIRES: it has not been evaluated
    /// since.
    auto gradient(const CurveStep& step, double theta, double time) const {
        const double t = theta * std::abs(step.dt);
        return field_.gradient_here({local_.at(0, t), local_.at(1, t), local_.at(2, t)}, time);
    }

    double inside_until(const CurveStep& step, PointStatus& met) const {
        return field_.status(Vec3(step.at(1.0))) == PointStatus::Inside
                   ? 1.0
                   : core::inside_until(field_, step, options_.longest_step, met);
    }

    /// Returns true: inside_until tested the end. A particle that slides along a side stays on it.
    bool arrive(Curve& curve) {
        curve.last.position = field_.settled(curve.last.position);
        return true;
    }

  private:
    /// Takes the step that ends where the series is after time `t`, by a cubic: what leaves the domain does so near the
    /// step's end, which is a little beyond a face.
    template <std::size_t Terms>
    void go(const PathSeriesOf<Terms>& space,
            const PathSeriesOf<Terms>& local,
            double t,
            CurveStep& step) {
        const auto way = [](double x, double y, double z) {
            return glm::dvec4(x, y, z, glm::length(Vec3(x, y, z)));
        };
        const auto slope = [&](double at) {
            return way(space.slope(0, at), space.slope(1, at), space.slope(2, at));
        };
        const glm::dvec4 start(space.at(0, 0.0), space.at(1, 0.0), space.at(2, 0.0), 0.0);
        step.dt = t;
        hermite_output(
            step, start,
            way(space.at(0, t) - start.x, space.at(1, t) - start.y, space.at(2, t) - start.z),
            slope(0.0), slope(t));
        local_ = {};
        std::copy(local.term.begin(), local.term.end(), local_.term.begin());
    }

    static void
    shorten_to(double allowed, const PathSeriesOf<Order>& space, double& t, double least) {
        for (int i = 0; i < 20 && t > least; ++i) {
            const double error = end_error(space, Vec3(1.0), t) / t;
            if (error <= allowed)
                return;
            t = std::max(t * std::clamp(0.9 * std::pow(allowed / error, 1.0 / Order), 0.1, 0.95),
                         least);
        }
    }

    Cursor field_;
    const TraceOptions& options_;
    double sign_;
    PathSeriesOf<Order> local_; ///< of the last step
    GrazingSteps grazing_;
};

inline CellSteps CellSampler::series_steps(const TraceOptions& options, double sign) const {
    return {cursor(), options, sign};
}

inline SharedCellSteps CellSamplerCursor::series_steps(const TraceOptions& options,
                                                       double sign) const {
    return {*this, options, sign};
}

inline CellParticleSteps CellSamplerCursor::particle_steps(const TraceOptions& options,
                                                           double sign) const {
    return {*this, options, sign};
}

} // namespace wakesurf::core
