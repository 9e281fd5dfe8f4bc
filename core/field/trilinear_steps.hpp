// Steps along a curve through stored data on a grid, cell by cell: each follows the Taylor series of the
// particle's path, a polynomial of the cell's own, and ends where that leaves the cell.
#pragma once

#include "core/base/components.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/kernel/series_batch.hpp"
#include "core/integrate/advance_curve.hpp"
#include "core/integrate/grazing_steps.hpp"
#include "core/integrate/path_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace wakesurf::core {

/// The coefficients of 1, x, y, xy, z, xz, yz, xyz; x, y, z run from 0 to 1 through the cell.
struct TrilinearPolynomial {
    std::array<Components, 8> c;

    TrilinearPolynomial() = default;

    TrilinearPolynomial(const float* velocity,
                        const std::array<std::size_t, 8>& node,
                        const Vec3& scale) {
        for (std::size_t i = 0; i < 8; ++i) {
            const float* v = velocity + 3 * node[i];
            c[i].xy = Components::Pair{v[0], v[1]} * Components::Pair{scale.x, scale.y};
            c[i].z = Components::Pair{v[2] * scale.z, 0.0};
        }
        for (const std::size_t bit : {1u, 2u, 4u})
            for (std::size_t i = 0; i < 8; ++i)
                if (i & bit)
                    c[i] = c[i] - c[i ^ bit];
    }

    /// Evaluates without the constant: m are the values of x, y, xy, z, xz, yz, xyz.
    Components rest(const double (&m)[7]) const {
        return ((c[1] * m[0] + c[2] * m[1]) + (c[3] * m[2] + c[4] * m[3])) +
               ((c[5] * m[4] + c[6] * m[5]) + c[7] * m[6]);
    }

    /// Returns the derivatives by x, y and z.
    std::array<Components, 3> slopes(const Vec3& u) const {
        return {(c[1] + c[3] * u.y) + (c[5] * u.z + c[7] * (u.y * u.z)),
                (c[2] + c[3] * u.x) + (c[6] * u.z + c[7] * (u.x * u.z)),
                (c[4] + c[5] * u.x) + (c[6] * u.y + c[7] * (u.x * u.y))};
    }
};

/// (grad v) w at a place of a cell, as a function of w.
class CellGradient {
  public:
    /// @param slopes  by the cell's coordinates, of velocity in these
    /// @param sign    -1 for slopes of the field upstream
    CellGradient(const std::array<Components, 3>& slopes,
                 const Vec3& size,
                 const Vec3& per_size,
                 double sign)
        : slopes_(slopes), size_(sign * size), per_size_(per_size), sign_(sign) {}

    Vec3 operator()(const Vec3& w) const {
        const Vec3 u = w * per_size_;
        return (slopes_[0] * u.x + slopes_[1] * u.y + slopes_[2] * u.z).vector() * size_;
    }

    double divergence() const {
        return sign_ * (slopes_[0].xy[0] + slopes_[1].xy[1] + slopes_[2].z[0]);
    }

  private:
    std::array<Components, 3> slopes_;
    Vec3 size_, per_size_;
    double sign_;
};

/// Moves over the cells of a sampler's grid. Positions within a cell are in units of the cell; time runs in
/// units of the field's, downstream or upstream.
template <class Grid>
class TrilinearCell {
  public:
    using Index = std::array<std::ptrdiff_t, 3>;

    /// @param sign    +1 downstream, -1 upstream
    /// @param frozen  the field stays as it is at the time series() is asked for
    TrilinearCell(const GridSampler<Grid>& field, double sign, bool frozen)
        : field_(field), sign_(sign) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            cells_[axis] = std::ptrdiff_t{dimensions(*field.grid)[axis]} - 1;
        rate_ = field.velocity1 && !frozen ? sign / field.interval : 0.0;
        measure({0, 0, 0});
    }

    Index index_of(const Vec3& p) const {
        Index index;
        for (std::size_t axis = 0; axis < 3; ++axis)
            index[axis] = static_cast<std::ptrdiff_t>(
                along(*field_.grid, axis, p[static_cast<int>(axis)]).cell);
        return index;
    }

    /// False beyond the border, and where a node has no velocity.
    bool inside(const Index& index) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (index[i] < 0 || index[i] >= cells_[i])
                return false;
        return !field_.gaps || !field_.gap(unsigned_of(index));
    }

    void enter(const Index& index) {
        const auto cell = unsigned_of(index);
        const std::size_t node = field_.first_node(cell);
        if (node == node_)
            return;
        node_ = node;
        cell_ = cell;
        if constexpr (!std::is_same_v<Grid, UniformGrid>)
            measure(cell);
        const auto stored = field_.stored_cell(cell, node);
        const auto corner = cell_nodes(stored.strides, 0);
        now_ = TrilinearPolynomial(field_.at_first(field_.velocity0, stored), corner, scale_);
        if (field_.velocity1) {
            change_ =
                TrilinearPolynomial(field_.at_first(field_.velocity1, stored), corner, scale_);
            for (std::size_t i = 0; i < 8; ++i)
                change_.c[i] = change_.c[i] - now_.c[i];
        }
        lo_ = cell_origin(*field_.grid, cell);
    }

    const Vec3& lo() const { return lo_; }

    const Vec3& size() const { return size_; }

    const Vec3& per_size() const { return per_size_; }

    /// Returns the shortest side, in units of length.
    double finest() const { return finest_; }

    /// Returns false if all of the cell is fluid.
    bool obstacle() const { return field_.cells->state(cell_, node_) != CellMask::Fluid; }

    /// Returns the path of a particle at `u` in the cell at field time `t`.
    PathSeries series(const Vec3& u, double t) const {
        return field_.velocity1 ? expand<true>(u, (t - field_.time0) / field_.interval)
                                : expand<false>(u, 0.0);
    }

    /// Writes what expanding the series of a particle at `u` at field time `t` takes, in a lane of a batch.
    void put(const Vec3& u, double t, SeriesBatch& batch, std::size_t lane) const {
        const auto write = [&](const TrilinearPolynomial& from, auto& to) {
            for (std::size_t i = 0; i < 8; ++i) {
                to[i][0][lane] = from.c[i].xy[0];
                to[i][1][lane] = from.c[i].xy[1];
                to[i][2][lane] = from.c[i].z[0];
            }
        };
        write(now_, batch.now);
        batch.unsteady = static_cast<bool>(field_.velocity1);
        if (batch.unsteady) {
            write(change_, batch.change);
            batch.part[lane] = (t - field_.time0) / field_.interval;
            batch.rate[lane] = rate_;
        }
        for (int axis = 0; axis < 3; ++axis) {
            batch.place[axis][lane] = u[axis];
            batch.size[axis][lane] = size_[axis];
            batch.low[axis][lane] = lo_[axis];
        }
    }

    /// Returns the gradient at `u` in the cell at field time `t`.
    CellGradient gradient(const Vec3& u, double t) const {
        std::array<Components, 3> slopes = now_.slopes(u);
        if (field_.velocity1) {
            const double part = (t - field_.time0) / field_.interval;
            const std::array<Components, 3> changes = change_.slopes(u);
            for (std::size_t axis = 0; axis < 3; ++axis)
                slopes[axis] = slopes[axis] + changes[axis] * part;
        }
        return {slopes, size_, per_size_, sign_};
    }

  private:
    template <bool Unsteady>
    PathSeries expand(const Vec3& u, double part) const {
        PathSeries path;
        double x[5], y[5], z[5], xy[5], xz[5], yz[5], xyz[5];
        x[0] = u.x;
        y[0] = u.y;
        z[0] = u.z;
        path.term[0] = {u.x, u.y, u.z};
        Components changed;
#pragma GCC unroll 5
        for (std::size_t order = 0; order < 5; ++order) {
            xy[order] = xz[order] = yz[order] = xyz[order] = 0.0;
            for (std::size_t j = 0; j <= order; ++j) {
                xy[order] += x[j] * y[order - j];
                xz[order] += x[j] * z[order - j];
                yz[order] += y[j] * z[order - j];
            }
            for (std::size_t j = 0; j <= order; ++j)
                xyz[order] += xy[j] * z[order - j];
            const double m[7] = {x[order],  y[order],  xy[order], z[order],
                                 xz[order], yz[order], xyz[order]};
            Components v = now_.rest(m);
            if (order == 0)
                v = v + now_.c[0];
            if constexpr (Unsteady) {
                Components change = change_.rest(m);
                if (order == 0)
                    change = change + change_.c[0];
                v = v + change * part + changed * rate_;
                changed = change;
            }
            const Components next = v * (1.0 / static_cast<double>(order + 1));
            path.term[order + 1] = {next.xy[0], next.xy[1], next.z[0]};
            if (order < 4) {
                x[order + 1] = next.xy[0];
                y[order + 1] = next.xy[1];
                z[order + 1] = next.z[0];
            }
        }
        return path;
    }

    static std::array<std::size_t, 3> unsigned_of(const Index& index) {
        return {static_cast<std::size_t>(index[0]), static_cast<std::size_t>(index[1]),
                static_cast<std::size_t>(index[2])};
    }

    void measure(const std::array<std::size_t, 3>& cell) {
        size_ = cell_size(*field_.grid, cell);
        per_size_ = 1.0 / size_;
        scale_ = sign_ / size_;
        finest_ = std::min({size_.x, size_.y, size_.z});
    }

    const GridSampler<Grid>& field_;
    Index cells_;
    double sign_;
    double rate_; ///< of the share of the second time-step; 0: frozen
    Vec3 size_, per_size_, scale_;
    double finest_;
    std::array<std::size_t, 3> cell_{};
    std::size_t node_ = ~std::size_t{0};
    Vec3 lo_{0.0};
    TrilinearPolynomial now_, change_;
};

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
        local_ = cell_.series(place(curve), time(curve));
        exit_ = leaves_cell(local_);
        const Vec3 velocity =
            Vec3(local_.term[1][0], local_.term[1][1], local_.term[1][2]) * cell_.size();
        return bound(curve, left, glm::length(velocity)) ? step_alone(curve, step)
                                                         : StepOutcome::Stagnation;
    }

    // attempt() in a lane of a batch, in three parts: between them the kernel expands the series and finds
    // the steps.

    void put(const Curve& curve, SeriesBatch& batch, std::size_t lane) {
        cell_.enter(index_);
        cell_.put(place(curve), time(curve), batch, lane);
        batch.arc[lane] = curve.last.arc;
    }

    /// Returns false at stagnation.
    bool bound(const Curve& curve, double left, SeriesBatch& batch, std::size_t lane) {
        for (std::size_t k = 0; k <= PathSeries::order; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                local_.term[k][axis] = batch.term[k][axis][lane];
        exit_ = {batch.exit_time[lane], static_cast<std::size_t>(batch.exit_axis[lane]),
                 static_cast<int>(batch.exit_step[lane])};
        const bool goes = bound(curve, left, batch.speed[lane]);
        batch.time[lane] = t_;
        batch.least[lane] = least_;
        batch.allowed[lane] = allowed_;
        return goes;
    }

    StepOutcome
    take(const Curve& curve, const SeriesBatch& batch, std::size_t lane, CurveStep& step) {
        if ((batch.shorter >> lane & 1u) != 0)
            return step_alone(curve, step);
        step = {};
        for (std::size_t k = 0; k < step.c.size(); ++k)
            for (int i = 0; i < 4; ++i)
                step.c[k][i] = batch.output[k][i][lane];
        step.error = static_cast<float>(batch.error[lane]);
        step.dt = sign_ * t_;
        return StepOutcome::Taken;
    }

    /// Returns (grad v) w at theta of the last step, as a function of w. REQUIRES: it has not arrived yet.
    CellGradient gradient(const CurveStep& step, double theta, double time) const {
        const double t = theta * std::abs(step.dt);
        return cell_.gradient({local_.at(0, t), local_.at(1, t), local_.at(2, t)}, time);
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
    double time(const Curve& curve) const {
        return options_.frozen ? curve.release : curve.release + curve.last.time;
    }

    Vec3 place(const Curve& curve) const {
        return (curve.last.position - cell_.lo()) * cell_.per_size();
    }

    /// Finds how long the step may be, and how exact it has to be. Returns false at stagnation.
    bool bound(const Curve& curve, double left, double speed) {
        const bool rests = !(speed > options_.stagnation_speed);
        if (rests && ends_at_rest(field_, curve.last.position, time(curve), speed, options_.frozen))
            return false;
        auto next = index_;
        next[exit_.axis] += exit_.step;
        if (!cell_.inside(next))
            sharpen(local_, exit_, 1e-12);
        // Bounds a particle that circles slowly in its cell.
        const double crossing = rests ? left : cell_.finest() / speed;
        t_ = std::max(exit_.time, grazing_.least(exit_.time / crossing) * crossing);
        t_ = t_ <= 1e3 * crossing ? t_ : 1e3 * crossing;
        t_ = std::min(t_, left);
        allowed_ = allowed_error(options_, rests, speed, left);
        least_ = GrazingSteps::shortest * crossing;
        return true;
    }

    StepOutcome step_alone(const Curve& curve, CurveStep& step) {
        const auto shortened =
            series_step(local_, cell_.lo(), cell_.size(), curve.last.arc, allowed_, t_, least_);
        if (!shortened)
            return StepOutcome::Stagnation;
        step = *shortened;
        step.dt = sign_ * t_;
        return StepOutcome::Taken;
    }

    const GridSampler<Grid>& field_;
    const TraceOptions& options_;
    double sign_;
    TrilinearCell<Grid> cell_;
    PathSeries local_; ///< of the last step, in the cell
    typename TrilinearCell<Grid>::Index index_{};
    CellExit exit_;                      ///< of the last step
    double t_ = 0.0;                     ///< its length
    double allowed_ = 0.0, least_ = 0.0; ///< of series_step()
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
