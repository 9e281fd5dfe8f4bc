#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/surface_history.hpp"
#include "tests/support/mesh_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace wakesurf::core::surface_history_test {

using namespace tests;

namespace {

constexpr std::size_t plenty = 1u << 30;

const Flow& gyre() {
    static const auto made = make_analytic_flow("double-gyre?w=0.1");
    return **made;
}

SurfaceParameters streak() {
    return {.kind = SurfaceKind::Streak, .to = 3.0, .separation = 0.12, .release_until = 2.0};
}

SurfaceParameters patch() {
    return {.kind = SurfaceKind::Time,
            .from = 3.0,
            .to = 0.0,
            .separation = 0.12,
            .sweep = Vec3(0.0, 0.0, 0.4)};
}

/// Asks for a stop in the middle of carrying particles, after `left` times of doing so.
class StoppingFlow final : public Flow {
  public:
    Box domain() const override { return gyre().domain(); }

    std::optional<std::array<double, 2>> time_range() const override { return gyre().time_range(); }

    double finest_spacing() const override { return gyre().finest_spacing(); }

    PointStatus status(const Vec3& p) const override { return gyre().status(p); }

    Result<TraceCost> trace(std::span<Curve> curves,
                            const TraceOptions& options,
                            std::stop_token stop) const override {
        return gyre().trace(curves, options, stop);
    }

    Result<TraceCost> advance(const Particles& particles,
                              double to,
                              const AdvanceOptions& options,
                              std::stop_token stop) const override {
        if (left-- == 0) {
            source.request_stop();
            // Half of them have arrived when the stop is heard.
            const std::size_t half = particles.count() / 2;
            const bool tangents = particles.tangents();
            const Particles first{particles.position.first(half),
                                  particles.along_s.first(tangents ? half : 0),
                                  particles.along_t.first(tangents ? half : 0),
                                  particles.time.first(half), particles.end.first(half)};
            EXPECT_TRUE(gyre().advance(first, to, options, {}));
        }
        return gyre().advance(particles, to, options, stop);
    }

    bool few_data(double, double) const override { return true; }

    bool obstacle() const override { return false; }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double> times,
                        std::span<Vec3> velocities,
                        std::stop_token stop,
                        bool smooth) const override {
        return gyre().sample(positions, times, velocities, stop, smooth);
    }

    mutable int left = -1;
    mutable std::stop_source source;
};

MovingSurface surface(const SurfaceParameters& parameters, const Flow& flow = gyre()) {
    static const SteadyClock clock;
    const Rake rake{Rake::Kind::Line, {{0.3, 0.2, 0.0}, {0.9, 0.7, 0.0}}, 8};
    auto started = MovingSurface::start(plan_surface(flow, rake, parameters).value(), {}, clock);
    EXPECT_TRUE(started);
    return std::move(*started);
}

std::uint64_t shown(SurfaceHistory& history, double time) {
    const auto mesh = history.at(time, {});
    EXPECT_TRUE(mesh) << time;
    if (!mesh)
        return 0;
    EXPECT_EQ(mesh->time, time);
    return hash(*mesh);
}

/// Times on and between steps, the first and the last.
std::vector<double> times() {
    return {0.0, 0.01, 0.5, 1.0, 1.5, 2.1, 2.7182, 3.0};
}

} // namespace

TEST(SurfaceHistory, WhatItShowsDoesNotDependOnWhatWasLookedAtBefore) {
    for (const SurfaceParameters& parameters : {streak(), patch()}) {
        std::vector<std::uint64_t> fresh;
        for (const double time : times()) {
            SurfaceHistory alone(surface(parameters), plenty);
            fresh.push_back(shown(alone, time));
        }
        std::vector<std::size_t> order(fresh.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        const auto all_as_fresh = [&](SurfaceHistory& history, const char* how) {
            for (const std::size_t i : order)
                EXPECT_EQ(shown(history, times()[i]), fresh[i]) << how << " " << times()[i];
        };
        SurfaceHistory history(surface(parameters), plenty);
        all_as_fresh(history, "forwards");
        std::reverse(order.begin(), order.end());
        all_as_fresh(history, "back again");
        SurfaceHistory small(surface(parameters), history.bytes() / 5);
        all_as_fresh(small, "backwards");
        std::shuffle(order.begin(), order.end(), std::mt19937(4));
        all_as_fresh(small, "at random, few checkpoints");
        SurfaceHistory none(surface(parameters), 0);
        all_as_fresh(none, "at random, one checkpoint");
        EXPECT_EQ(std::set(fresh.begin(), fresh.end()).size(), fresh.size());
    }
}

TEST(SurfaceHistory, KeepsItsBudget) {
    SurfaceParameters fine = streak();
    fine.separation = 0.06;
    SurfaceHistory all(surface(fine), plenty);
    const std::size_t first = all.bytes();
    ASSERT_TRUE(all.at(3.0, {}));
    ASSERT_GT(all.bytes(), 10 * first);
    for (const std::size_t part : {2u, 4u, 16u, 1000000u}) {
        const std::size_t budget = all.bytes() / part;
        SurfaceHistory history(surface(fine), budget);
        for (int i = 0; i <= 6; ++i) {
            ASSERT_TRUE(history.at(0.5 * i, {}));
            EXPECT_LE(history.bytes(), std::max(budget, first)) << "at " << 0.5 * i;
            EXPECT_GE(history.bytes(), first) << "the first stays";
        }
        if (part == 2) {
            EXPECT_GT(history.bytes(), budget / 4) << "gave up more than every other one";
        }
    }
}

TEST(SurfaceHistory, GivesUpWhatALaterBudgetDoesNotHoldAndShowsTheSame) {
    SurfaceHistory twin(surface(streak()), plenty);
    SurfaceHistory history(surface(streak()), plenty);
    const auto last = shown(history, 3.0);
    const std::size_t all = history.bytes();
    const std::size_t first = SurfaceHistory(surface(streak()), 0).bytes();
    for (const std::size_t budget : {all / 2, all / 5, std::size_t{0}}) {
        history.limit(budget);
        EXPECT_LE(history.bytes(), std::max(budget, first));
        EXPECT_GE(history.bytes(), first) << "the first stays";
        for (const double time : times())
            EXPECT_EQ(shown(history, time), shown(twin, time)) << time;
        EXPECT_LE(history.bytes(), std::max(budget, first));
    }
    history.limit(plenty);
    EXPECT_EQ(shown(history, 3.0), last);
}

TEST(SurfaceHistory, OutsideItsTimesThereIsNothing) {
    SurfaceHistory forward(surface(streak()), plenty);
    SurfaceHistory backward(surface(patch()), plenty);
    for (const double time : {-0.001, 3.001, std::numeric_limits<double>::quiet_NaN()})
        for (SurfaceHistory* history : {&forward, &backward}) {
            const auto mesh = history->at(time, {});
            ASSERT_FALSE(mesh) << time;
            EXPECT_EQ(mesh.error().code, Error::Code::OutOfTime);
        }
    EXPECT_TRUE(forward.at(3.0, {}));
    EXPECT_TRUE(backward.at(0.0, {}));
}

TEST(SurfaceHistory, ACancelledCallDoesNoHarm) {
    for (const SurfaceParameters& parameters : {streak(), patch()}) {
        SurfaceHistory fresh(surface(parameters), plenty);
        const std::uint64_t wanted = shown(fresh, 1.3);
        SurfaceHistory history(surface(parameters), plenty);
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = [&] {
            const auto mesh = history.at(1.3, stop.get_token());
            ASSERT_FALSE(mesh);
            EXPECT_EQ(mesh.error().code, Error::Code::Cancelled);
        };
        cancelled();
        EXPECT_EQ(shown(history, 1.3), wanted);
        cancelled(); // on the last part of the way now
        EXPECT_EQ(shown(history, 1.3), wanted);
        shown(history, 0.4);
        cancelled();
        EXPECT_EQ(shown(history, 1.3), wanted);
    }
}

TEST(SurfaceHistory, ACallCancelledInTheMiddleOfAStepDoesNoHarm) {
    for (const SurfaceParameters& parameters : {streak(), patch()}) {
        SurfaceHistory fresh(surface(parameters), plenty);
        const std::uint64_t wanted = shown(fresh, 1.3);
        int cancelled = 0;
        for (int after = 0; after < 6; ++after) {
            const StoppingFlow flow;
            SurfaceHistory history(surface(parameters, flow), after % 2 == 0 ? plenty : 0);
            flow.left = after;
            const auto mesh = history.at(1.3, flow.source.get_token());
            cancelled += !mesh;
            EXPECT_EQ(shown(history, 1.3), wanted) << after;
        }
        EXPECT_GT(cancelled, 2);
    }
}

} // namespace wakesurf::core::surface_history_test
