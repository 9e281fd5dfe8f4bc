#include "core/field/stored_flow.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <numbers>
#include <random>

namespace wakesurf::core::periodic_sampling_test {

using tests::SampledSource;

namespace {

constexpr double period = 2.0 * std::numbers::pi;

/// An ABC flow that swells in time: periodic along all axes.
Vec3 abc(const Vec3& p, double t) {
    const double a = 1.0 + 0.2 * t;
    return {a * std::sin(p.z) + 0.8 * std::cos(p.y), 0.7 * std::sin(p.x) + a * std::cos(p.z),
            0.8 * std::sin(p.y) + 0.7 * std::cos(p.x)};
}

std::unique_ptr<Flow> flow_on(Grid grid,
                              PeriodicAxes periodic,
                              SampledSource::Velocity velocity = abc,
                              std::vector<double> times = {0.0, 1.5, 4.0, 8.0}) {
    auto source = std::make_shared<SampledSource>(std::move(grid), std::move(times), velocity);
    source->periodic_axes = periodic;
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}));
}

/// Nodes that repeat along all axes, from `low` periods before the first one to `high` after it.
UniformGrid uniform(int low, int high, std::uint32_t cells = 10) {
    const auto nodes = static_cast<std::uint32_t>(high - low) * cells + 1;
    return {Vec3(low * period), Vec3(period / cells), {nodes, nodes, nodes}};
}

RectilinearGrid rectilinear(int low, int high) {
    std::vector<double> along;
    for (int i = low * 16; i <= high * 16; ++i)
        along.push_back(period / 16.0 * i + 0.1 * std::sin(period / 16.0 * i));
    return {{along, along, along}};
}

CellMesh cells(int low, int high) {
    const auto count = static_cast<std::uint32_t>(high - low) * 8;
    return tests::block({count, count, count}, [&](const Vec3& lattice) {
        return Vec3(low * period) + lattice * ((high - low) * period);
    });
}

struct Swarm {
    std::vector<Vec3> position;
    std::vector<Vec3> along_s{}, along_t{};
    std::vector<double> time{};
    std::vector<CurveEnd> end{};

    explicit Swarm(std::vector<Vec3> places, double start = 0.0)
        : position(std::move(places)), along_s(position.size(), Vec3(1, 0, 0)),
          along_t(position.size(), Vec3(0, 1, 0)), time(position.size(), start),
          end(position.size(), CurveEnd::Running) {}

    Particles particles() { return {position, along_s, along_t, time, end}; }
};

std::vector<Vec3> seeds(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, period);
    std::vector<Vec3> out(count);
    for (Vec3& each : out)
        each = {unit(random), unit(random), unit(random)};
    return out;
}

AdvanceOptions carried_by(IntegrationMethod method, bool smooth = false) {
    AdvanceOptions options;
    options.method = method;
    options.step = 0.005;
    options.tolerance = 1e-9;
    options.longest_step = 0.5;
    options.smooth = smooth;
    return options;
}

TraceOptions traced_by(IntegrationMethod method, bool frozen) {
    TraceOptions options;
    options.method = method;
    options.frozen = frozen;
    options.tolerance = 1e-9;
    options.step = 0.005;
    options.longest_step = 0.5;
    options.stretch = true;
    return options;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance, const std::string& what) {
    EXPECT_LE(glm::length(a - b), tolerance) << what << ": " << a.x << ' ' << a.y << ' ' << a.z
                                             << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

/// Carries a swarm through one period and through a grid of as many periods as it goes.
void expect_twins(const Flow& repeated,
                  const Flow& twin,
                  const AdvanceOptions& options,
                  double from,
                  double to,
                  double tolerance) {
    Swarm a(seeds(200), from), b(seeds(200), from);
    for (const double until : {0.5 * (from + to), to}) {
        ASSERT_TRUE(repeated.advance(a.particles(), until, options, {}));
        ASSERT_TRUE(twin.advance(b.particles(), until, options, {}));
    }
    int beyond = 0;
    for (std::size_t i = 0; i < a.position.size(); ++i) {
        ASSERT_EQ(b.end[i], CurveEnd::Running);
        ASSERT_EQ(a.end[i], CurveEnd::Running) << i;
        EXPECT_EQ(a.time[i], to);
        expect_near(a.position[i], b.position[i], tolerance, "particle " + std::to_string(i));
        expect_near(a.along_s[i], b.along_s[i], 100 * tolerance * (1.0 + glm::length(b.along_s[i])),
                    "tangent");
        beyond += repeated.domain().contains(a.position[i]) ? 0 : 1;
    }
    EXPECT_GT(beyond, 50);
}

Curve curve_from(const Vec3& seed, double release, double duration) {
    Curve curve;
    curve.seed = seed;
    curve.seed_tangent = {1, 0, 0};
    curve.release = release;
    curve.duration = duration;
    return curve;
}

void expect_twin_curves(const Flow& repeated,
                        const Flow& twin,
                        const TraceOptions& options,
                        double release,
                        double duration,
                        double tolerance) {
    std::vector<Curve> a, b;
    for (const Vec3& seed : seeds(40))
        a.push_back(curve_from(seed, release, duration));
    b = a;
    ASSERT_TRUE(repeated.trace(a, options, {}));
    ASSERT_TRUE(twin.trace(b, options, {}));
    int beyond = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(b[i].end, CurveEnd::Time);
        ASSERT_EQ(a[i].end, CurveEnd::Time) << i;
        EXPECT_EQ(a[i].seed, b[i].seed);
        EXPECT_NEAR(a[i].last.arc, b[i].last.arc, 10 * tolerance);
        for (double part = 0.0; part <= 1.0; part += 0.01) {
            const CurvePoint p = a[i].at_time(part * duration);
            const CurvePoint q = b[i].at_time(part * duration);
            expect_near(p.position, q.position, tolerance, "at part " + std::to_string(part));
            expect_near(p.stretch, q.stretch, 1000 * tolerance * (1.0 + glm::length(q.stretch)),
                        "stretch");
            expect_near(a[i].at_arc(p.arc).position, p.position, tolerance, "at arc");
        }
        for (std::size_t k = 0; k + 1 < a[i].steps.size(); ++k) {
            const CurveStep& step = a[i].steps[k];
            expect_near(Vec3(step.at(1.0)), Vec3(a[i].steps[k + 1].c[0]), 1e-6, "steps meet");
            EXPECT_NEAR(step.time + step.dt, a[i].steps[k + 1].time, 1e-9);
        }
        beyond += repeated.domain().contains(a[i].last.position) ? 0 : 1;
    }
    EXPECT_GT(beyond, 10);
}

constexpr PeriodicAxes all{true, true, true};

} // namespace

TEST(PeriodicSampling, AParticleIsCarriedStraightOnThroughTheSidesOfTheBox) {
    const Vec3 wind(1.0, -0.4, 0.3);
    const auto flow = flow_on(uniform(0, 1), all, [&](const Vec3&, double) { return wind; });
    for (const auto method : {IntegrationMethod::Rk4, IntegrationMethod::Dopri5}) {
        AdvanceOptions options = carried_by(method);
        options.longest_step = 1e9;
        options.step = 3.0;
        Swarm swarm(seeds(100));
        const auto start = swarm.position;
        for (const double until : {0.3, 2.0, 7.9})
            ASSERT_TRUE(flow->advance(swarm.particles(), until, options, {}));
        for (std::size_t i = 0; i < start.size(); ++i) {
            EXPECT_EQ(swarm.end[i], CurveEnd::Running);
            expect_near(swarm.position[i], start[i] + 7.9 * wind, 1e-5, "particle");
        }
    }
}

TEST(PeriodicSampling, ParticlesGoTheSameWayAsThroughAGridOfSeveralPeriods) {
    const auto repeated = flow_on(uniform(0, 1), all);
    const auto twin = flow_on(uniform(-3, 4), {});
    expect_twins(*repeated, *twin, carried_by(IntegrationMethod::Dopri5), 0.0, 4.0, 1e-6);
    expect_twins(*repeated, *twin, carried_by(IntegrationMethod::Dopri5), 4.0, 0.0, 1e-6);
    expect_twins(*repeated, *twin, carried_by(IntegrationMethod::Rk4), 0.0, 4.0, 2e-4);
    expect_twins(*repeated, *twin, carried_by(IntegrationMethod::Rk4), 4.0, 0.0, 2e-4);
}

TEST(PeriodicSampling, ParticlesCrossTheSidesOfRectilinearGridsAndOfMeshes) {
    expect_twins(*flow_on(rectilinear(0, 1), all), *flow_on(rectilinear(-2, 3), {}),
                 carried_by(IntegrationMethod::Dopri5), 0.0, 4.0, 1e-6);
    expect_twins(*flow_on(rectilinear(0, 1), all), *flow_on(rectilinear(-2, 3), {}),
                 carried_by(IntegrationMethod::Rk4), 0.0, 4.0, 2e-4);
    expect_twins(*flow_on(cells(0, 1), all), *flow_on(cells(-1, 2), {}),
                 carried_by(IntegrationMethod::Dopri5), 0.0, 3.0, 1e-6);
}

TEST(PeriodicSampling, ASmoothFieldIsSampledBeyondTheBoxToo) {
    const auto repeated = flow_on(uniform(0, 1, 32), all);
    const auto twin = flow_on(uniform(-1, 2, 32), {});
    // Cubics of the outermost cells know no nodes of the next period.
    expect_twins(*repeated, *twin, carried_by(IntegrationMethod::Rk4, true), 0.0, 2.0, 1e-2);
}

TEST(PeriodicSampling, CurvesGoOnBeyondTheBoxInOnePiece) {
    const auto repeated = flow_on(uniform(0, 1), all);
    const auto twin = flow_on(uniform(-3, 4), {});
    for (const bool frozen : {true, false})
        for (const double sign : {1.0, -1.0}) {
            const double release = sign > 0.0 ? 0.5 : 6.5;
            expect_twin_curves(*repeated, *twin, traced_by(IntegrationMethod::Dopri5, frozen),
                               release, 6.0 * sign, 1e-6);
            expect_twin_curves(*repeated, *twin, traced_by(IntegrationMethod::Rk4, frozen), release,
                               6.0 * sign, 2e-4);
        }
    expect_twin_curves(*flow_on(cells(0, 1), all), *flow_on(cells(-1, 2), {}),
                       traced_by(IntegrationMethod::Dopri5, false), 0.5, 3.0, 1e-6);
}

TEST(PeriodicSampling, VelocityAndStatusAreThoseOfThePlaceInTheBox) {
    const auto flow = flow_on(uniform(0, 1), {true, false, true});
    const std::vector<Vec3> places{{1.0 + 2 * period, 2.0, 3.0 - period}, {1.0, 2.0, 3.0}};
    const std::vector<double> times{1.0, 1.0};
    std::vector<Vec3> velocity(2);
    ASSERT_TRUE(flow->sample(places, times, velocity, {}));
    expect_near(velocity[0], velocity[1], 1e-6, "sample");
    for (const bool smooth : {false, true}) {
        std::vector<Vec3f> at(2);
        ASSERT_TRUE(flow->sample_at(places, 1.0, at, {}, smooth));
        expect_near(Vec3(at[0]), Vec3(at[1]), 1e-5, "sample_at");
    }
    EXPECT_EQ(flow->status(places[0]), PointStatus::Inside);
    EXPECT_EQ(flow->shares(places[0]).node, flow->shares(places[1]).node);
    EXPECT_EQ(flow->status({1.0, -0.1, 1.0}), PointStatus::OutsideDomain);
    EXPECT_EQ(flow->status({1.0 + 8 * period, 1.0, 1.0}), PointStatus::OutsideDomain);
    EXPECT_EQ(flow->domain().hi.x, uniform(0, 1).bounds().hi.x);
}

TEST(PeriodicSampling, AParticleInACornerCrossesTheSidesThatTheFlowPassesThere) {
    for (const Vec3& wind :
         {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, -1, -1), Vec3(-1, -1, -1), Vec3(0, -1, 1)}) {
        const auto flow = flow_on(uniform(0, 1), all, [&](const Vec3&, double) { return wind; });
        for (const Vec3& corner : {Vec3(0.0), Vec3(period, 0.0, period), Vec3(period)})
            for (const auto method : {IntegrationMethod::Rk4, IntegrationMethod::Dopri5}) {
                Swarm swarm({corner, corner - 2.5 * wind});
                AdvanceOptions options = carried_by(method);
                ASSERT_TRUE(flow->advance(swarm.particles(), 5.0, options, {}));
                expect_near(swarm.position[0], corner + 5.0 * wind, 1e-5, "from the corner");
                expect_near(swarm.position[1], corner + 2.5 * wind, 1e-5, "through it");
                EXPECT_EQ(swarm.end[0], CurveEnd::Running);
                std::vector<Curve> curves{curve_from(corner, 0.0, 5.0)};
                ASSERT_TRUE(flow->trace(curves, traced_by(method, true), {}));
                EXPECT_EQ(curves[0].end, CurveEnd::Time);
                expect_near(curves[0].last.position, corner + 5.0 * wind, 1e-5, "curve");
                EXPECT_NEAR(curves[0].last.arc, 5.0 * glm::length(wind), 1e-5);
            }
    }
}

TEST(PeriodicSampling, AParticleEndsWhereItIsSentBackAndForthAcrossASide) {
    // The flow meets itself there, as it does in data that do not repeat.
    const auto flow = flow_on(uniform(0, 1), {true, false, false}, [](const Vec3& p, double) {
        return Vec3(p.x > 0.5 * period ? 1.0 : -1.0, 0.0, 0.0);
    });
    for (const auto method : {IntegrationMethod::Rk4, IntegrationMethod::Dopri5}) {
        Swarm swarm({Vec3(6.0, 1.0, 1.0)});
        ASSERT_TRUE(flow->advance(swarm.particles(), 5.0, carried_by(method), {}));
        EXPECT_EQ(swarm.end[0], CurveEnd::Domain);
        expect_near(swarm.position[0], Vec3(period, 1.0, 1.0), 1e-5, "the side");
        std::vector<Curve> curves{curve_from(Vec3(6.0, 1.0, 1.0), 0.0, 5.0)};
        ASSERT_TRUE(flow->trace(curves, traced_by(method, true), {}));
        EXPECT_EQ(curves[0].end, CurveEnd::Domain);
        expect_near(curves[0].last.position, Vec3(period, 1.0, 1.0), 1e-5, "the side");
    }
}

TEST(PeriodicSampling, AParticleEndsAtASideThatDoesNotRepeatAndAfterSevenPeriods) {
    const auto flow = flow_on(uniform(0, 1), {true, false, false},
                              [](const Vec3&, double) { return Vec3(2.0, 0.5, 0.0); });
    Swarm leaves({Vec3(1.0, period - 1.0, 1.0)});
    ASSERT_TRUE(flow->advance(leaves.particles(), 8.0, carried_by(IntegrationMethod::Rk4), {}));
    EXPECT_EQ(leaves.end[0], CurveEnd::Domain);
    expect_near(leaves.position[0], Vec3(5.0, period, 1.0), 1e-5, "the outlet");
    std::vector<Curve> curves{curve_from(Vec3(1.0, 1.0, 1.0), 0.0, 1e3)};
    const auto fast = flow_on(uniform(0, 1), {true, false, false},
                              [](const Vec3&, double) { return Vec3(2.0, 0.0, 0.0); });
    ASSERT_TRUE(fast->trace(curves, traced_by(IntegrationMethod::Dopri5, true), {}));
    EXPECT_EQ(curves[0].end, CurveEnd::Domain);
    expect_near(curves[0].last.position, Vec3(8.0 * period, 1.0, 1.0), 1e-5, "the last period");
}

TEST(PeriodicSampling, AWatchSeesTheStepsWhereTheyAreDrawn) {
    const auto flow = flow_on(uniform(0, 1), all);
    std::vector<Curve> curves{curve_from(Vec3(3.0, 5.5, 1.0), 0.0, 12.0)};
    std::vector<Curve> kept = curves;
    ASSERT_TRUE(flow->trace(kept, traced_by(IntegrationMethod::Dopri5, true), {}));
    ASSERT_FALSE(flow->domain().contains(kept[0].last.position));
    double seen = 0.0;
    const StepWatch watch = [&](const Curve& curve, const CurveStep& step) {
        const double part = (curve.last.time - step.time) / step.dt;
        expect_near(Vec3(step.at(part)), curve.last.position, 1e-9, "step");
        expect_near(kept[0].at_time(curve.last.time).position, curve.last.position, 1e-6, "curve");
        EXPECT_GE(curve.last.arc, seen);
        seen = curve.last.arc;
        return true;
    };
    TraceOptions options = traced_by(IntegrationMethod::Dopri5, true);
    options.watch = &watch;
    ASSERT_TRUE(flow->trace(curves, options, {}));
    EXPECT_EQ(curves[0].end, CurveEnd::Time);
    expect_near(curves[0].last.position, kept[0].last.position, 1e-6, "end");
}

TEST(PeriodicSampling, TheNumberOfThreadsChangesNoBit) {
    std::vector<std::vector<Vec3>> ends;
    for (const int threads : {1, 4}) {
        tbb::task_arena arena(threads);
        arena.execute([&] {
            const auto flow = flow_on(uniform(0, 1), all);
            Swarm swarm(seeds(500));
            ASSERT_TRUE(
                flow->advance(swarm.particles(), 6.0, carried_by(IntegrationMethod::Rk4), {}));
            ends.push_back(swarm.position);
        });
    }
    EXPECT_EQ(ends[0], ends[1]);
}

} // namespace wakesurf::core::periodic_sampling_test
