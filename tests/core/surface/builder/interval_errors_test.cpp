// The error between stored times, in a fluid that moves as one, where it is known.
#include "core/field/function_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wakesurf::core::interval_errors_test {

namespace {

constexpr double end = 4.0;

UniformGrid grid() {
    UniformGrid out;
    out.origin = {-8, -4, -4};
    out.spacing = Vec3(1.0);
    out.dimensions = {33, 9, 9};
    return out;
}

/// Moves along x at the speed of the time, and slowly along z.
std::shared_ptr<const Flow> stored(const std::function<double(double)>& speed,
                                   int intervals,
                                   UniformGrid of = grid(),
                                   PeriodicAxes periodic = {}) {
    std::vector<double> times;
    for (int k = 0; k <= intervals; ++k)
        times.push_back(end * k / intervals);
    auto source = std::make_shared<tests::SampledSource>(
        std::move(of), std::move(times),
        [speed](const Vec3&, double t) { return Vec3(speed(t), 0.0, 0.25); });
    source->periodic_axes = periodic;
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}));
}

SurfacePlan plan(std::shared_ptr<const Flow> flow,
                 SurfaceKind kind,
                 double separation = 0.25,
                 Between between = Between::Linear) {
    SurfaceParameters p;
    p.kind = kind;
    p.to = end;
    p.separation = separation;
    p.between = between;
    p.accuracy = Accuracy::Exact;
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.5, 0.0, 0.0);
    return value_of(
        plan_surface(std::move(flow), {Rake::Kind::Line, {{0, -1, 0}, {0, 1, 0}}, 5}, p));
}

double oscillating(double t) {
    return 1.0 + std::sin(2.0 * t);
}

/// How far oscillating() carries a particle from one time to another.
double way(double from, double to) {
    return to - from - 0.5 * (std::cos(2.0 * to) - std::cos(2.0 * from));
}

/// When a vertex was released, and the time it is shown at.
std::pair<double, double> ends(SurfaceKind kind, double t) {
    return kind == SurfaceKind::Streak ? std::pair(t, end)
           : kind == SurfaceKind::Path ? std::pair(0.0, t)
                                       : std::pair(0.0, end);
}

Surface stated(const SurfacePlan& asked) {
    Surface surface = value_of(build_surface(asked));
    EXPECT_TRUE(state_interval_errors(asked, surface, {}));
    return surface;
}

constexpr std::array moving{SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time};

} // namespace

TEST(IntervalErrors, ComeNearerToTheTrueOnesWithTheSquareOfTheInterval) {
    for (const SurfaceKind kind : moving) {
        double before = 0.0;
        for (const int intervals : {16, 32, 64}) {
            const SurfacePlan asked = plan(stored(oscillating, intervals), kind);
            const Surface surface = stated(asked);
            double off = 0.0, largest = 0.0;
            for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
                if (std::isnan(surface.mesh.interval_error[v]))
                    continue;
                const auto [from, to] = ends(kind, surface.mesh.t[v]);
                const double start = kind == SurfaceKind::Time ? 0.5 * surface.mesh.t[v] : 0.0;
                const double real = std::abs(surface.mesh.position[v].x - start - way(from, to));
                off = std::max(off, std::abs(real - double{surface.mesh.interval_error[v]}));
                largest = std::max(largest, real);
            }
            EXPECT_GT(largest, 1e-4);
            EXPECT_LT(off, largest);
            if (before > 0.0) {
                EXPECT_LT(off, before / 3.0) << intervals;
            }
            before = off;
        }
    }
}

TEST(IntervalErrors, OfAPathSurfaceInBothDirectionsAreThoseOfEither) {
    SurfaceParameters p;
    p.kind = SurfaceKind::Path;
    p.from = 0.5 * end;
    p.to = end;
    p.separation = 0.25;
    p.accuracy = Accuracy::Exact;
    p.direction = Direction::Both;
    const SurfacePlan asked = value_of(
        plan_surface(stored(oscillating, 32), {Rake::Kind::Line, {{2, -1, 0}, {2, 1, 0}}, 5}, p));
    const Surface surface = stated(asked);
    ASSERT_TRUE(surface.statistics.interval_error);
    EXPECT_LT(surface.statistics.interval_error->unresolved, 0.1);
    std::array<double, 2> largest{};
    for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
        if (std::isnan(surface.mesh.interval_error[v]))
            continue;
        const double t = surface.mesh.t[v];
        const double real = std::abs(surface.mesh.position[v].x - 2.0 - way(p.from, p.from + t));
        if (std::abs(t) > 0.25) {
            EXPECT_NEAR(std::log2(double{surface.mesh.interval_error[v]} / real), 0.0, 1.0) << t;
        }
        double& side = largest[t < 0.0 ? 0 : 1];
        side = std::max(side, real);
    }
    EXPECT_GT(largest[0], 1e-3);
    EXPECT_GT(largest[1], 1e-3);
}

TEST(IntervalErrors, AreTheSameWhereParticlesGoOnFromTheOtherSideOfAPeriodicBox) {
    UniformGrid box = grid();
    box.origin.x = -2.0;
    box.dimensions[0] = 5; // way() goes through it twice
    for (const SurfaceKind kind : moving) {
        const Surface whole = stated(plan(stored(oscillating, 16), kind));
        const Surface periodic =
            stated(plan(stored(oscillating, 16, box, {true, false, false}), kind));
        ASSERT_TRUE(whole.statistics.interval_error && periodic.statistics.interval_error);
        EXPECT_NEAR(periodic.statistics.interval_error->error99,
                    whole.statistics.interval_error->error99, 1e-4);
        EXPECT_EQ(periodic.statistics.interval_error->unresolved,
                  whole.statistics.interval_error->unresolved);
    }
}

TEST(IntervalErrors, AreNoneWhereTheFlowIsLinearBetweenStoredTimes) {
    for (const SurfaceKind kind : moving) {
        const SurfacePlan asked = plan(stored([](double t) { return 0.5 + t; }, 16), kind);
        const auto error = stated(asked).statistics.interval_error;
        ASSERT_TRUE(error);
        EXPECT_LT(error->error99, 1e-5);
        EXPECT_EQ(error->unresolved, 0.0);
    }
}

TEST(IntervalErrors, AdviseAnIntervalThatBringsThemToTheSeparation) {
    const SurfacePlan asked = plan(stored(oscillating, 32), SurfaceKind::Streak, 0.05);
    const auto advice = stated(asked).statistics.advised_interval;
    ASSERT_TRUE(advice) << stated(asked).statistics.interval_error->unresolved;
    const int intervals = static_cast<int>(std::lround(end / *advice));
    ASSERT_GE(intervals, 4);
    const SurfacePlan advised = plan(stored(oscillating, intervals), SurfaceKind::Streak, 0.05);
    const Surface there = value_of(build_surface(advised));
    double largest = 0.0;
    for (std::size_t v = 0; v < there.mesh.vertices(); ++v)
        largest = std::max(largest, std::abs(there.mesh.position[v].x - way(there.mesh.t[v], end)));
    EXPECT_LT(largest, 2.0 * asked.parameters.separation);
    EXPECT_GT(largest, 0.5 * asked.parameters.separation);
}

TEST(IntervalErrors, AreNotStatedWhereTheSeriesDoesNotResolveTheFlow) {
    // About three stored times a period: every second and every third say different things.
    const SurfacePlan asked =
        plan(stored([](double t) { return 1.0 + std::sin(6.0 * t); }, 12), SurfaceKind::Streak);
    const auto error = stated(asked).statistics.interval_error;
    EXPECT_TRUE(!error || error->unresolved > 0.5);
}

TEST(IntervalErrors, AreTheSameOnAnyNumberOfThreads) {
    for (const SurfaceKind kind : moving) {
        const SurfacePlan asked = plan(stored(oscillating, 16), kind);
        const auto on = [&](int threads) {
            return tbb::task_arena(threads).execute(
                [&] { return stated(asked).mesh.interval_error; });
        };
        const auto same = [](float a, float b) {
            return a == b || (std::isnan(a) && std::isnan(b));
        };
        EXPECT_TRUE(std::ranges::equal(on(1), on(4), same));
    }
}

TEST(IntervalErrors, AreLeftOutWithTheReason) {
    const auto reason = [](std::shared_ptr<const Flow> flow, SurfaceKind kind) {
        return no_interval_errors(plan(std::move(flow), kind));
    };
    const std::shared_ptr<const Flow> formula = make_function_flow(
        [](const Vec3&, double) { return Vec3(1, 0, 0.25); }, {{-8, -4, -4}, {24, 4, 4}});
    EXPECT_EQ(reason(formula, SurfaceKind::Streak),
              "the flow is known at all times: nothing is interpolated between stored times");
    EXPECT_EQ(reason(stored(oscillating, 16), SurfaceKind::Stream),
              "the field is frozen: nothing is interpolated between stored times");
    EXPECT_EQ(reason(stored(oscillating, 3), SurfaceKind::Streak),
              "the surface uses 4 stored times, and at least 5 are needed");
    EXPECT_EQ(reason(stored(oscillating, 4), SurfaceKind::Streak), "");
    for (const Between between : {Between::Cubic, Between::Flow})
        EXPECT_EQ(
            no_interval_errors(plan(stored(oscillating, 16), SurfaceKind::Streak, 0.25, between)),
            "it is estimated only of what is linear between stored times");
}

TEST(ThinnedFlow, HasTheTimesThatAreLeftAndIsLinearBetween) {
    const auto flow = stored(oscillating, 16);
    const double h = end / 16;
    const auto thin = flow->thinned(4, 5.5 * h); // steps 1, 5, 9, 13, and both ends
    std::vector<double> times;
    for (auto next = thin->next_stored_time(-1.0, +1.0); next;
         next = thin->next_stored_time(*next, +1.0))
        times.push_back(*next / h);
    EXPECT_EQ(times, (std::vector<double>{0, 1, 5, 9, 13, 16}));
    const std::vector<Vec3> place(3, Vec3(0.0));
    const std::vector<double> when{5 * h, 6 * h, 9 * h};
    std::vector<Vec3> velocity(3);
    ASSERT_TRUE(thin->sample(place, when, velocity, {}));
    EXPECT_NEAR(velocity[0].x, oscillating(5 * h), 1e-6);
    EXPECT_NEAR(velocity[1].x, 0.75 * oscillating(5 * h) + 0.25 * oscillating(9 * h), 1e-6);
    EXPECT_NEAR(velocity[2].x, oscillating(9 * h), 1e-6);
}

} // namespace wakesurf::core::interval_errors_test
