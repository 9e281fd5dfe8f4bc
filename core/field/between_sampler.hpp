// The field between stored times other than linearly: by cubics from four of them. `Cubic` takes all four at the
// place itself. `Flow` takes them along a straight way through it: what changes at a place is mostly carried past
// it, by the fluid or more slowly, as vortices and waves are, and where it is carried it changes less. In space the
// time-steps stay what their own sampler makes of them.
#pragma once

#include "core/base/box.hpp"
#include "core/base/dual.hpp"
#include "core/base/point_status.hpp"
#include "core/field/between_times.hpp"
#include "core/field/cubic_time_shares.hpp"
#include "core/field/interval.hpp"
#include "core/integrate/cursor_of.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace wakesurf::core {

/// A plain function of place and time, continuous in both but where the domain ends otherwise than at a wall or
/// at its box. Stored times have the values that are stored.
/// @tparam View  samples time-steps: of two linearly, of one alone
template <class View>
class BetweenSampler {
  public:
    /// One of the four; the outer two may be missing.
    struct Step {
        View view; ///< of this time-step alone
        double time = 0.0;
        bool there = true;
    };

    /// @param linear  between the middle two
    /// @param box     round the domain: no way leads out of it
    BetweenSampler(const View& linear,
                   const std::array<Step, 4>& steps,
                   const Box& box,
                   Between between)
        : linear_(linear), step_(steps), aside_{steps[1].view, steps[2].view}, box_(box),
          between_(between) {}

    const View& linear() const { return linear_; }

    Vec3 velocity(const Vec3& p, double t) const {
        if constexpr (FieldWithCursor<View>)
            return cursor().velocity(p, t);
        else
            return value(p, t);
    }

    /// Returns (grad v) w. Where it falls back to linear beside a wall, as if it did so everywhere to the same part.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        if constexpr (FieldWithCursor<View>)
            return cursor().derivative(p, t, w);
        else
            return gradient(p, t)(w);
    }

    /// Returns (grad v) w as a function of w.
    auto gradient(const Vec3& p, double t) const {
        return [at = value(DualVec3::place(p), t)](const Vec3& w) { return at.along(w); };
    }

    PointStatus status(const Vec3& p) const { return linear_.status(p); }

    bool stands_still() const { return false; }

    bool at_wall(const Vec3& p) const { return linear_.at_wall(p); }

    double cell_speed(const Vec3& p, double t) const { return linear_.cell_speed(p, t); }

    // Implements PagedField.
    bool missed() const requires PagedField<View> {
        return linear_.missed() || std::any_of(step_.begin(), step_.end(),
                                               [](const Step& step) { return step.view.missed(); });
    }

    bool take_missed() const requires PagedField<View> {
        bool any = linear_.take_missed();
        each_view([&](const View& view) { any = view.take_missed() || any; });
        return any;
    }

    auto missing() const requires PagedField<View> { return linear_.missing(); }

    // Implements FieldWithCursor.
    auto cursor() const requires FieldWithCursor<View> {
        using Cursor = decltype(linear_.cursor());
        const auto of = [&](std::size_t i) {
            return typename BetweenSampler<Cursor>::Step{step_[i].view.cursor(), step_[i].time,
                                                         step_[i].there};
        };
        return BetweenSampler<Cursor>(linear_.cursor(), {of(0), of(1), of(2), of(3)}, box_,
                                      between_);
    }

    /// Begins with another particle.
    void restart() const requires requires(const View& view) { view.restart(); }

    {
        linear_.restart();
        each_view([](const View& view) { view.restart(); });
    }

    void restart(std::uint32_t guess) const requires requires(const View& view) {
        view.restart(std::uint32_t{0});
    }

    {
        linear_.restart(guess);
        each_view([&](const View& view) { view.restart(guess); });
    }

    const auto& place() const requires requires(const View& view) { view.place(); }

    { return linear_.place(); }

  private:
    /// @tparam Place  Vec3; DualVec3: the gradient as well
    template <class Place>
    Place value(const Place& x, double t) const {
        const auto share =
            cubic_time_shares({step_[0].time, step_[1].time, step_[2].time, step_[3].time},
                              step_[0].there, step_[3].there, t);
        const auto [first, second] = ends(x);
        const double part = (t - step_[1].time) / (step_[2].time - step_[1].time);
        const Place linear = (1.0 - part) * first + part * second;
        const double here = bounded() ? linear_.open_share(real_part(x)) : 1.0;
        double open = 1.0;
        Place sum = 0.0 * first;
        if (between_ == Between::Cubic) {
            sum = share[1] * first + share[2] * second;
            for (const std::size_t i : {std::size_t{0}, std::size_t{3}})
                if (share[i] != 0.0) {
                    open *= openness(step_[i].view, x, here);
                    sum = sum + share[i] * sample(step_[i].view, x);
                }
        } else {
            const Place way = carrying(x, t, first, second, linear, here);
            for (std::size_t i = 0; i < step_.size(); ++i)
                if (share[i] != 0.0) {
                    const Place there = x + (step_[i].time - t) * way;
                    open *= openness(step_[i].view, there, here);
                    sum = sum + share[i] * sample(step_[i].view, there);
                }
        }
        return open == 1.0 ? sum : open * sum + (1.0 - open) * linear;
    }

    /// Returns the velocity of the way: a part of the fluid's, that with which a field that is linear along it
    /// changes least from the one time-step to the other, less where it explains the change badly: the part times
    /// the squared cosine between the change and what of it goes away along the fluid's way.
    template <class Place>
    Place carrying(const Place& x,
                   double t,
                   const Place& first,
                   const Place& second,
                   const Place& fluid,
                   double here) const {
        const Place way = kept_in_box(x, t, fluid);
        const Place before = x + (step_[1].time - t) * way;
        const Place after = x + (step_[2].time - t) * way;
        const double open = openness(aside_[0], before, here) * openness(aside_[1], after, here);
        const Place change = second - first;
        const Place gone = change - (sample(aside_[1], after) - sample(aside_[0], before));
        const auto fits = dot(change, gone);
        const auto all = dot(change, change);
        if (!(real_part(fits) > 1e-150)) // far below what squares of stored numbers are
            return 0.0 * fluid;
        constexpr double nothing = 1e-12; // of the change
        const auto part = fits / (dot(gone, gone) + nothing * all);
        const auto good = part * fits / all;
        return open * (real_part(part) < 1.0 ? part * good : good) * way;
    }

    /// Returns the fluid's velocity, less along each axis along which the way from the earliest time-step to the
    /// latest would leave the box. A way along a side stays as it is.
    template <class Place>
    Place kept_in_box(const Place& x, double t, Place fluid) const {
        const double early = (step_[0].there ? step_[0] : step_[1]).time - t;
        const double late = (step_[3].there ? step_[3] : step_[2]).time - t;
        for (int axis = 0; axis < 3; ++axis)
            for (const double time : {early, late}) {
                const auto to = component(x, axis) + time * component(fluid, axis);
                const double side = std::clamp(real_part(to), box_.lo[axis], box_.hi[axis]);
                if (side != real_part(to) && time != 0.0) // not a number: neither
                    set_component(fluid, axis,
                                  (1.0 / time) * (number(x, side) - component(x, axis)));
            }
        return fluid;
    }

    static double number(const Vec3&, double a) { return a; }

    static Dual number(const DualVec3&, double a) { return {a, Vec3(0.0)}; }

    bool bounded() const {
        return linear_.bounded() || step_[0].view.bounded() || step_[3].view.bounded();
    }

    /// Returns 1 where a step's value at a place counts as much as that at the place asked for, 0 where there is
    /// none: it falls towards a wall with the distance from it. The view is then at that place.
    template <class Place>
    double openness(const View& view, const Place& place, double here) const {
        if (!bounded())
            return 1.0;
        if constexpr (requires { view.restart(); })
            if (view.status(real_part(place)) != PointStatus::Inside) {
                view.restart(); // on the way there from the last place may have been a wall
                view.status(real_part(place));
            }
        const double there = view.open_share(real_part(place));
        return there < here ? there / here : here > 0.0 ? 1.0 : 0.0;
    }

    static Vec3 sample(const View& view, const Vec3& p) { return view.velocity(p, 0.0); }

    static DualVec3 sample(const View& view, const DualVec3& p) { return sample(view, p, 0.0); }

    static DualVec3 sample(const View& view, const DualVec3& p, double t) {
        const Vec3 v = view.velocity(p.value, t);
        const auto gradient = view.gradient(p.value, t);
        return {v, {gradient(p.slope[0]), gradient(p.slope[1]), gradient(p.slope[2])}};
    }

    std::array<Vec3, 2> ends(const Vec3& p) const { return linear_.ends(p); }

    std::array<DualVec3, 2> ends(const DualVec3& p) const {
        return {sample(linear_, p, step_[1].time), sample(linear_, p, step_[2].time)};
    }

    template <class Use>
    void each_view(const Use& use) const {
        for (const Step& step : step_)
            use(step.view);
        for (const View& view : aside_)
            use(view);
    }

    View linear_;
    std::array<Step, 4> step_;
    std::array<View, 2>
        aside_; ///< of the middle two, at other places than those: a cursor goes short ways
    Box box_;
    Between between_;
};

/// Returns the sampler of an interval. REQUIRES: it is not linear.
/// @param sampler_of  sampler_of(interval) samples that linearly, or the one time-step that it consists of
template <class SamplerOf>
auto between_sampler(const Interval& interval, const Box& box, const SamplerOf& sampler_of) {
    using Sampler = BetweenSampler<decltype(sampler_of(interval))>;
    const auto step = [&](const std::shared_ptr<const TimeStep>& which,
                          const std::shared_ptr<const TimeStep>& instead) {
        const auto& at = which ? which : instead;
        return typename Sampler::Step{
            sampler_of(Interval{nullptr, at, nullptr, nullptr, interval.missing}), at->time,
            which != nullptr};
    };
    return Sampler(sampler_of(interval),
                   {step(interval.before, interval.first), step(interval.first, nullptr),
                    step(interval.second, nullptr), step(interval.after, interval.second)},
                   box, interval.between);
}

} // namespace wakesurf::core
