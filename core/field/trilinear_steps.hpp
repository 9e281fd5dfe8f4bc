// Steps along a curve through stored data on a grid, cell by cell: each follows the Taylor series of the
// particle's path and ends where that leaves the cell.
#pragma once

#include "core/field/trilinear_cell.hpp"
#include "core/integrate/advance_curve.hpp"
#include "core/integrate/grazing_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

/// The time and face by which a particle leaves its cell.
struct CellExit {
    double time = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    int step = 0; ///< of the cell's index; 0: not at all
};

/// Estimates the exit by the path's first three terms, from the cell's inside.
inline CellExit roughly_leaves(const PathSeries& path, std::size_t axis) {
    const double direction = path.term[1][axis] < 0.0 ? -1.0 : 1.0;
    const double behind =
        std::max(direction > 0.0 ? path.term[0][axis] : 1.0 - path.term[0][axis], 0.0);
    const double ahead = std::max(1.0 - behind, 0.0);
    const double v = std::abs(path.term[1][axis]);
    const double a = direction * path.term[2][axis];
    const int step = direction > 0.0 ? +1 : -1;
    if (const double square = v * v + 4.0 * a * ahead; square >= 0.0) {
        const double sum = v + std::sqrt(square);
        if (sum > 0.0)
            return {2.0 * ahead / sum, axis, step};
        if (!(a < 0.0)) // at rest on the face ahead, or for as long as is known
            return a > 0.0 ? CellExit{0.0, axis, step} : CellExit{};
    }
    return {(v + std::sqrt(v * v - 4.0 * a * behind)) / (-2.0 * a), axis, -step}; // turns back
}

/// Sharpens a rough exit by Newton's iteration. A particle that is d cells past the face when the next cell
/// takes over is off by some d * d of what the field's kink there turns it by, so 1e-5 is near enough except
/// at the domain's border.
inline void sharpen(const PathSeries& path, CellExit& exit, double near_enough = 5e-3) {
    const double face = exit.step > 0 ? 1.0 : 0.0;
    for (int i = 0; i < 5; ++i) {
        const double slope = path.slope(exit.axis, exit.time);
        if (slope * exit.step <= 0.0)
            return;
        const double change = (path.at(exit.axis, exit.time) - face) / slope;
        exit.time = std::max(exit.time - change, 0.0);
        if (std::abs(change) <= near_enough * exit.time)
            return;
    }
}

inline CellExit leaves_cell(const PathSeries& path) {
    CellExit first;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const CellExit exit = roughly_leaves(path, axis); exit.time < first.time)
            first = exit;
    if (first.step == 0)
        return first;
    sharpen(path, first);
    constexpr double beyond = 1e-5; // of a cell
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double u = path.at(axis, first.time);
        if (axis == first.axis || (u <= 1.0 + beyond && u >= -beyond))
            continue;
        CellExit earlier{first.time, axis, u > 1.0 ? +1 : -1};
        sharpen(path, earlier);
        if (earlier.time < first.time)
            first = earlier;
    }
    return first;
}

/// Makes Dormand-Prince steps of the same tolerance, but as long as the cells; a CurveSteps. It keeps
/// references to the field and the options.
template <class Grid>
class TrilinearSteps {
  public:
    /// @param sign  +1 downstream, -1 upstream
    TrilinearSteps(const GridSampler<Grid>& field, const TraceOptions& options, double sign)
        : field_(field), options_(options), sign_(sign), cell_(field, sign, options.frozen) {}

    const GridSampler<Grid>& field() const { return field_; }

    struct Waypoint {
        typename TrilinearCell<Grid>::Index index;
        GrazingSteps grazing;
    };

    Waypoint waypoint() const { return {index_, grazing_}; }

    PointStatus resume(const Waypoint& from) {
        index_ = from.index;
        grazing_ = from.grazing;
        return cell_.inside(index_) ? PointStatus::Inside : PointStatus::OutsideDomain;
    }

    PointStatus begin(const Curve& curve) {
        index_ = cell_.index_of(curve.last.position);
        return curve.attempts == 0 ? field_.status(curve.seed) : PointStatus::Inside;
    }

    StepOutcome attempt(const Curve& curve, double left, CurveStep& step) {
        cell_.enter(index_);
        const double time = options_.frozen ? curve.release : curve.release + curve.last.time;
        const PathSeries path =
            cell_.series((curve.last.position - cell_.lo()) * cell_.per_size(), time);
        const Vec3 velocity =
            Vec3(path.term[1][0], path.term[1][1], path.term[1][2]) * cell_.size();
        const double speed = glm::length(velocity);
        const bool rests = !(speed > options_.stagnation_speed);
        if (rests && ends_at_rest(field_, curve.last.position, time, speed, options_.frozen))
            return StepOutcome::Stagnation;
        exit_ = leaves_cell(path);
        auto next = index_;
        next[exit_.axis] += exit_.step;
        if (!cell_.inside(next))
            sharpen(path, exit_, 1e-12);
        // Bounds a particle that circles slowly in its cell.
        const double crossing = rests ? left : cell_.finest() / speed;
        t_ = std::max(exit_.time, grazing_.least(exit_.time / crossing) * crossing);
        t_ = t_ <= 1e3 * crossing ? t_ : 1e3 * crossing;
        t_ = std::min(t_, left);
        const auto shortened = series_step(path, cell_.lo(), cell_.size(), curve.last.arc,
                                           allowed_error(options_, rests, speed, left), t_,
                                           GrazingSteps::shortest * crossing);
        if (!shortened)
            return StepOutcome::Stagnation;
        step = *shortened;
        step.dt = sign_ * t_;
        return StepOutcome::Taken;
    }

    /// Returns (grad v) w at theta of a step, as a function of w.
    auto gradient(const CurveStep& step, double theta, double time) const {
        return field_.gradient(Vec3(step.at(theta)), time);
    }

    double inside_until(const CurveStep& step, PointStatus& met) const {
        return cell_.obstacle() ? core::inside_until(field_, step, options_.longest_step, met)
                                : 1.0;
    }

    bool arrive(const Curve& curve) {
        if (t_ >= exit_.time && exit_.step != 0)
            index_[exit_.axis] += exit_.step;
        for (std::size_t axis = 0; axis < 3; ++axis) { // beyond by what sharpen() let pass
            const int i = static_cast<int>(axis);
            const double u = (curve.last.position[i] - cell_.lo()[i]) * cell_.per_size()[i];
            if (axis != exit_.axis || t_ < exit_.time)
                index_[axis] += u > 1.0 ? 1 : u < 0.0 ? -1 : 0;
        }
        return cell_.inside(index_);
    }

  private:
    const GridSampler<Grid>& field_;
    const TraceOptions& options_;
    double sign_;
    TrilinearCell<Grid> cell_;
    typename TrilinearCell<Grid>::Index index_{};
    CellExit exit_;  ///< of the last step
    double t_ = 0.0; ///< its length
    GrazingSteps grazing_;
};

/// A sampler whose curves are traced cell by cell.
template <class Grid>
struct CellwiseSampler : GridSampler<Grid> {
    TrilinearSteps<Grid> series_steps(const TraceOptions& options, double sign) const {
        return {*this, options, sign};
    }
};

} // namespace wakesurf::core
