// Samples a field that repeats: a particle that leaves the box of the grid through a periodic side goes on
// from the opposite one. Positions outside are those of the particle's way, which goes on beyond the box;
// within, each is brought into it, so that what samples the grid knows nothing of this.
#pragma once

#include "core/base/node_shares.hpp"
#include "core/base/periodic_axes.hpp"
#include "core/field/interval.hpp"
#include "core/integrate/curve.hpp"
#include "core/integrate/particles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Counts periods along x, y and z from the box on.
using Periods = std::array<std::int8_t, 3>;

/// A place on the way of a particle: in the box, and so many periods away from it.
struct PeriodicPlace {
    Vec3 in_box{0.0};
    Periods periods{0, 0, 0};
};

/// Where a particle ended on sides of the box, and what has been tried to get on from there.
struct SideCrossing {
    PeriodicPlace from;
    unsigned sides = 0; ///< a bit for each axis
    int tried = 0;
};

/// The box of the grid as one period of the flow.
class PeriodicBox {
  public:
    PeriodicBox(const Box& box, const PeriodicAxes& axes) : box_(box), axes_(axes) {}

    /// Places beyond `periods_beyond` are left outside of the box.
    PeriodicPlace place_of(const Vec3& position) const;

    Vec3 shift(const Periods& periods) const;

    /// Returns the crossing of a particle that has ended at a place; nothing if that is on no periodic side.
    std::optional<SideCrossing> crossing_at(const PeriodicPlace& place) const;

    /// Says whether a particle that has ended again has not left the place of the crossing.
    bool still_there(const SideCrossing& crossing, const PeriodicPlace& place) const;

    /// Returns the next place to go on from: on the opposite sides of all axes first, as most cross, then of
    /// some, for a particle in an edge or in a corner that crosses only one of the sides there, and at last
    /// of none, for one that rounding has put beyond the side. Nothing where no more are left.
    std::optional<PeriodicPlace> across(SideCrossing& crossing) const;

  private:
    unsigned sides_at(const Vec3& in_box) const;

    bool low(const Vec3& in_box, int axis) const {
        return in_box[axis] < 0.5 * (box_.lo[axis] + box_.hi[axis]);
    }

    Box box_;
    PeriodicAxes axes_;
};

/// Offers IntervalFlow what `Sampling` does. Thread safety: concurrent calls are fine.
template <class Sampling>
class PeriodicSampling {
  public:
    static constexpr bool has_smooth = Sampling::has_smooth;
    static constexpr bool steps_in_batches = Sampling::steps_in_batches;

    PeriodicSampling(std::unique_ptr<const Sampling> in_box,
                     const Box& box,
                     const PeriodicAxes& axes)
        : in_box_(std::move(in_box)), box_(box, axes) {}

    PointStatus status(const Vec3& position) const {
        return in_box_->status(box_.place_of(position).in_box);
    }

    NodeShares shares(const Vec3& position) const {
        return in_box_->shares(box_.place_of(position).in_box);
    }

    bool obstacle() const { return in_box_->obstacle(); }

    bool may_have_wall(const Box& box) const requires requires(const Sampling& in_box) {
        in_box.may_have_wall(box);
    }

    {
        const auto [lo, hi] = both_in_box(box.lo, box.hi);
        return lo ? in_box_->may_have_wall({*lo, *hi}) : obstacle();
    }

    bool may_cross_wall(const Vec3& from, const Vec3& to) const requires
        requires(const Sampling& in_box) {
        in_box.may_cross_wall(from, to);
    }

    {
        const auto [a, b] = both_in_box(from, to);
        return a ? in_box_->may_cross_wall(*a, *b) : obstacle();
    }

    /// Returns places of the box where the field is the same.
    std::vector<Vec3> brought_in(std::span<const Vec3> positions) const {
        std::vector<Vec3> out(positions.size());
        std::transform(positions.begin(), positions.end(), out.begin(),
                       [&](const Vec3& position) { return box_.place_of(position).in_box; });
        return out;
    }

    template <class Use>
    void with_field(const Interval& interval, bool smoothly, const Use& use) const {
        in_box_->with_field(interval, smoothly, use);
    }

    bool sample_at(const Interval& interval,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   bool smoothly,
                   const std::stop_token& stop) const requires requires {
        &Sampling::sample_at;
    }

    {
        return in_box_->sample_at(interval, brought_in(positions), time, velocities, smoothly,
                                  stop);
    }

    bool advance(const Interval& interval,
                 const Particles& particles,
                 double to,
                 int sign,
                 const AdvanceOptions& options,
                 const std::stop_token& stop) const;

    bool trace(const Interval& interval,
               std::span<Curve> curves,
               const TraceOptions& options,
               double limit,
               const std::stop_token& stop) const;

  private:
    /// A particle that has come to a periodic side, by its index.
    struct AtSide {
        std::size_t index;
        SideCrossing crossing;
        /// Where it goes on, or stays.
        PeriodicPlace place;
        CurvePoint came{};     ///< when it came there
        std::size_t steps = 0; ///< that its curve had then
    };

    enum class Met { NoSide, Side, SameSide };

    /// Two places of one period, brought into the box; nothing of places of different ones.
    std::pair<std::optional<Vec3>, std::optional<Vec3>> both_in_box(const Vec3& a,
                                                                    const Vec3& b) const {
        const PeriodicPlace first = box_.place_of(a);
        const PeriodicPlace second = box_.place_of(b);
        if (first.periods != second.periods)
            return {};
        return {first.in_box, second.in_box};
    }

    /// Learns that a particle has ended at a place. SameSide: it did not get away from where it was before.
    Met meet(AtSide& at, const PeriodicPlace& ended) const {
        if (at.crossing.sides != 0 && box_.still_there(at.crossing, ended))
            return Met::SameSide;
        at.place = ended;
        const auto crossing = box_.crossing_at(ended);
        at.crossing = crossing.value_or(SideCrossing{});
        return crossing ? Met::Side : Met::NoSide;
    }

    /// Returns whether there is another way from the side, which `at.place` is the begin of. If not, that
    /// is where it came to the side.
    bool goes_on(AtSide& at) const {
        const auto next = box_.across(at.crossing);
        at.place = next.value_or(at.crossing.from);
        return next.has_value();
    }

    std::unique_ptr<const Sampling> in_box_;
    PeriodicBox box_;
};

template <class Sampling>
bool PeriodicSampling<Sampling>::advance(const Interval& interval,
                                         const Particles& particles,
                                         double to,
                                         int sign,
                                         const AdvanceOptions& options,
                                         const std::stop_token& stop) const {
    // Only those that are running are looked at, here and below.
    std::vector<Periods> periods(particles.count(), Periods{0, 0, 0});
    std::vector<std::size_t> running;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        if (particles.end[i] != CurveEnd::Running || sign * (to - particles.time[i]) <= 0.0)
            continue;
        running.push_back(i);
        const PeriodicPlace place = box_.place_of(particles.position[i]);
        particles.position[i] = place.in_box;
        periods[i] = place.periods;
    }
    std::vector<AtSide> at_side;
    bool whole = true;
    for (std::size_t round = 0;; ++round) {
        whole = in_box_->advance(interval, particles, to, sign, options, stop);
        if (!whole)
            break;
        if (round == 0)
            for (const std::size_t i : running)
                if (particles.end[i] == CurveEnd::Domain)
                    at_side.push_back({i, {}, {}, {}, 0});
        std::erase_if(at_side, [&](AtSide& at) {
            const std::size_t i = at.index;
            if (particles.end[i] != CurveEnd::Domain)
                return true;
            const Met met = meet(at, {particles.position[i], periods[i]});
            if (met == Met::Side)
                at.came.time = particles.time[i];
            else if (met == Met::SameSide)
                particles.time[i] = at.came.time;
            const bool on = met != Met::NoSide && goes_on(at);
            particles.position[i] = at.place.in_box;
            periods[i] = at.place.periods;
            if (!on)
                return true;
            if (!particles.cell.empty())
                particles.cell[i] = no_cell;
            particles.end[i] = round < options.most_steps ? CurveEnd::Running : CurveEnd::Budget;
            return round >= options.most_steps;
        });
        if (at_side.empty())
            break;
    }
    for (const std::size_t i : running)
        particles.position[i] += box_.shift(periods[i]);
    return whole;
}

template <class Sampling>
bool PeriodicSampling<Sampling>::trace(const Interval& interval,
                                       std::span<Curve> curves,
                                       const TraceOptions& options,
                                       double limit,
                                       const std::stop_token& stop) const {
    std::vector<Periods> periods(curves.size(), Periods{0, 0, 0});
    const StepWatch in_periods = [&](const Curve& curve, const CurveStep& step) {
        const auto i = static_cast<std::size_t>(&curve - curves.data());
        const Vec3 shift = box_.shift(periods[i]);
        const Vec3 last = curve.last.position;
        CurveStep moved = step;
        moved.c[0] += glm::dvec4(shift, 0.0);
        curves[i].last.position += shift;
        const bool on = (*options.watch)(curve, moved);
        curves[i].last.position = last;
        return on;
    };
    TraceOptions inner = options;
    if (options.watch != nullptr)
        inner.watch = &in_periods;
    std::vector<AtSide> running; // at first all of them, then those that cross a side
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].end != CurveEnd::Running)
            continue;
        running.push_back({i, {}, {}, {}, 0});
        const Curve& curve = curves[i];
        running.back().place =
            box_.place_of(curve.attempts == 0 ? curve.seed : curve.last.position);
    }
    std::vector<std::size_t> arrived; // kept from being traced again
    bool whole = true;
    while (whole && !running.empty()) {
        std::vector<std::size_t> steps;
        std::vector<Vec3> seeds; // needed in the box before the first step only
        for (const AtSide& at : running) {
            Curve& curve = curves[at.index];
            steps.push_back(curve.steps.size());
            seeds.push_back(curve.seed);
            periods[at.index] = at.place.periods;
            (curve.attempts == 0 ? curve.seed : curve.last.position) = at.place.in_box;
        }
        whole = in_box_->trace(interval, curves, inner, limit, stop);
        std::size_t next = 0;
        std::erase_if(running, [&](AtSide& at) {
            const std::size_t k = next++;
            Curve& curve = curves[at.index];
            const Vec3 shift = box_.shift(at.place.periods);
            PeriodicPlace ended{curve.last.position, at.place.periods};
            curve.seed = seeds[k];
            curve.last.position += shift;
            for (std::size_t i = steps[k]; i < curve.steps.size(); ++i)
                curve.steps[i].c[0] += glm::dvec4(shift, 0.0);
            if (!whole)
                return true;
            if (curve.end == CurveEnd::Running) {
                arrived.push_back(at.index);
                curve.end = CurveEnd::Time;
            }
            if (curve.end != CurveEnd::Domain)
                return true;
            const Met met = meet(at, ended);
            if (met == Met::Side) {
                if (curve.steps.size() > steps[k])
                    curve.cut_last_step();
                at.came = curve.last;
                at.steps = curve.steps.size();
            } else if (met == Met::SameSide) {
                curve.last = at.came;
                curve.steps.resize(at.steps);
                curve.stretches.resize(std::min(curve.stretches.size(), at.steps));
            }
            const bool on = met != Met::NoSide && goes_on(at);
            curve.last.position = at.place.in_box + box_.shift(at.place.periods);
            if (on)
                curve.end = CurveEnd::Running;
            return !on;
        });
    }
    for (const std::size_t i : arrived)
        curves[i].end = CurveEnd::Running;
    return whole;
}

} // namespace wakesurf::core
