// Steps along a curve through a mesh of cells, cell by cell: each follows the Taylor series of the particle's
// path (cell_path.hpp) and ends a little beyond the face through which that leaves the cell. In tetrahedra of
// a steady field the ends are exact (linear_way in cell_sampler.hpp).
#pragma once

#include "core/field/cells/cell_sampler.hpp"
#include "core/integrate/advance_curve.hpp"
#include "core/integrate/grazing_steps.hpp"

#include <algorithm>

namespace wakesurf::core {

/// Makes Dormand-Prince steps of the same tolerance, but as long as the cells; a CurveSteps. It keeps a
/// reference to the options.
/// @tparam Cursor  a cursor, or a reference to one that serves particle after particle
template <class Cursor>
class CellStepsOf {
  public:
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
        const auto [space, local] = field_.path(curve.last.position, time, sign_, options_.frozen);
        const auto vector = [](const std::array<double, 3>& term) {
            return Vec3(term[0], term[1], term[2]);
        };
        const double speed = glm::length(vector(space.term[1]));
        const bool rests = !(speed > options_.stagnation_speed);
        if (rests && ends_at_rest(field_, curve.last.position, time, speed, options_.frozen))
            return StepOutcome::Stagnation;
        const Vec3 pace = glm::abs(vector(local.term[1]));
        const double crossing = rests ? left : 1.0 / std::max(std::max(pace.x, pace.y), pace.z);
        const double exit = leaves_cell(field_.place().geometry().shape(), local);
        const double least = grazing_.least(exit / crossing) * crossing;
        // A particle that circles in its cell does not do so for ever.
        double t = std::min(std::min(std::max(exit, least), 1e3 * crossing), left);
        const auto shortened = series_step(space, Vec3(0.0), Vec3(1.0), curve.last.arc,
                                           allowed_error(options_, rests, speed, left), t,
                                           GrazingSteps::shortest * crossing);
        if (!shortened)
            return StepOutcome::Stagnation;
        step = *shortened;
        step.dt = sign_ * t;
        local_ = local;
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
    Cursor field_;
    const TraceOptions& options_;
    double sign_;
    PathSeries local_; ///< of the last step
    GrazingSteps grazing_;
};

inline CellSteps CellSampler::series_steps(const TraceOptions& options, double sign) const {
    return {cursor(), options, sign};
}

inline SharedCellSteps CellSamplerCursor::series_steps(const TraceOptions& options,
                                                       double sign) const {
    return {*this, options, sign};
}

} // namespace wakesurf::core
