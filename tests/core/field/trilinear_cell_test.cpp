#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/curve_at_time.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace wakesurf::core::trilinear_cell_test {

using namespace tests;

namespace {

/// Uneven cells, and a solid ball in the middle when asked for.
std::unique_ptr<Flow> sampled(const char* name, Box box, bool ball = false) {
    const std::shared_ptr<const Flow> form = *make_analytic_flow(name);
    UniformGrid grid{
        .origin = box.lo, .spacing = box.extent() / Vec3(40, 32, 36), .dimensions = {41, 33, 37}};
    SolidMask mask;
    if (ball)
        for (std::size_t node = 0; node < grid.nodes(); ++node) {
            const Vec3 p =
                grid.origin + grid.spacing * Vec3(node % 41, node / 41 % 33, node / (41 * 33));
            mask.fluid.push_back(glm::length(p) > 0.5);
        }
    auto source = std::make_shared<SampledSource>(
        grid, std::vector<double>{0.0, 0.7, 1.1, 2.0, 3.5},
        [form](const Vec3& p, double t) {
            Vec3 v;
            EXPECT_TRUE(form->sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
            return v;
        },
        std::move(mask));
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

struct Sampled {
    const char* name;
    Box box;
    Vec3 from, to;
    SurfaceKind kind = SurfaceKind::Stream;
    bool ball = false;
};

const std::vector<Sampled>& flows() {
    static const std::vector<Sampled> all = {
        {"abc", {Vec3(-3), Vec3(3)}, {-1, 0, 0}, {1, 0.3, 0.2}},
        {"lamb-oseen", {Vec3(-2), Vec3(2)}, {0.1, 0, -1.5}, {1.5, 0, -1.5}},
        {"sphere", {Vec3(-3), Vec3(3)}, {-2, -1, 0.1}, {-2, 1, 0.1}, SurfaceKind::Stream, true},
        {"double-gyre",
         {Vec3(0, 0, -1), Vec3(2, 1, 1)},
         {0.3, 0.5, 0},
         {1.6, 0.4, 0},
         SurfaceKind::Path},
        {"rotating-strain", {Vec3(-4), Vec3(4)}, {0.1, 0, 0}, {1, 0.2, 1}, SurfaceKind::Path},
    };
    return all;
}

std::vector<Curve> curves(const Sampled& c, double duration) {
    std::vector<Curve> made(12);
    for (std::size_t i = 0; i < made.size(); ++i) {
        made[i].seed = glm::mix(c.from, c.to, static_cast<double>(i) / 11.0);
        made[i].release = duration < 0.0 ? 3.3 : 0.1;
        made[i].duration = duration;
    }
    return made;
}

Vec3 end_of(const Flow& flow,
            SurfaceKind kind,
            const Vec3& seed,
            double release,
            double time,
            bool smooth = false) {
    std::vector<Curve> curve(1);
    curve[0].seed = seed;
    curve[0].release = release;
    curve[0].duration = time;
    EXPECT_TRUE(flow.trace(curve,
                           {.frozen = kind == SurfaceKind::Stream,
                            .tolerance = 1e-13,
                            .longest_step = 0.01,
                            .smooth = smooth},
                           {}));
    return curve[0].last.position;
}

/// How much the flow map magnifies what a particle is off by: at least 1.
double
magnification(const Flow& flow, SurfaceKind kind, const Vec3& seed, double release, double time) {
    const double nudge = 1e-6;
    const Vec3 truth = end_of(flow, kind, seed, release, time);
    double sum = 1.0;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        sum += glm::length(end_of(flow, kind, seed + nudge * axis, release, time) - truth) / nudge;
    return sum;
}

} // namespace

TEST(TrilinearCell, CurvesEqualTinyRungeKuttaStepsThroughTheSampledField) {
    for (const Sampled& c : flows())
        for (const double duration : {+3.0, -3.0}) {
            const auto flow = sampled(c.name, c.box, c.ball);
            std::vector<Curve> exact = curves(c, duration);
            std::vector<Curve> tiny = exact;
            TraceOptions options{.frozen = c.kind == SurfaceKind::Stream,
                                 .tolerance = 1e-10,
                                 .longest_step = flow->finest_spacing()};
            ASSERT_TRUE(flow->trace(exact, options, {}));
            options.method = TraceOptions::Method::Rk4;
            options.step = 2e-4;
            ASSERT_TRUE(flow->trace(tiny, options, {}));
            for (std::size_t i = 0; i < exact.size(); ++i) {
                EXPECT_EQ(exact[i].end, tiny[i].end) << c.name << " " << i;
                for (double part = 0.0; part <= 1.0; part += 0.05) {
                    const double time =
                        part * std::min(std::abs(exact[i].last.time), std::abs(tiny[i].last.time));
                    const double signed_time = duration < 0.0 ? -time : time;
                    EXPECT_LT(glm::length(at_time(exact[i], signed_time).position -
                                          at_time(tiny[i], signed_time).position),
                              2e-6 * (1.0 + exact[i].last.arc))
                        << c.name << " " << i << " at " << signed_time;
                }
            }
        }
}

TEST(TrilinearCell, TangentsAndExpansionEqualThoseOfTinyRungeKuttaSteps) {
    const auto expansion = [](const Curve& curve) {
        return std::accumulate(
            curve.steps.begin(), curve.steps.end(), 0.0,
            [](double sum, const CurveStep& step) { return sum + double(step.expansion); });
    };
    for (const Sampled& c : flows())
        for (const double duration : {+1.5, -1.5}) {
            const auto flow = sampled(c.name, c.box, c.ball);
            std::vector<Curve> exact = curves(c, duration);
            for (Curve& curve : exact)
                curve.seed_tangent = c.to - c.from;
            std::vector<Curve> tiny = exact;
            std::vector<Curve> alone = exact;
            TraceOptions options{.frozen = c.kind == SurfaceKind::Stream,
                                 .tolerance = 1e-10,
                                 .longest_step = flow->finest_spacing(),
                                 .stretch = true};
            ASSERT_TRUE(flow->trace(exact, options, {}));
            options.stretch = false;
            ASSERT_TRUE(flow->trace(alone, options, {}));
            options.stretch = true;
            options.method = TraceOptions::Method::Rk4;
            options.step = 5e-4;
            ASSERT_TRUE(flow->trace(tiny, options, {}));
            for (std::size_t i = 0; i < exact.size(); ++i) {
                if (exact[i].end != CurveEnd::Time)
                    continue;
                const double length = glm::length(tiny[i].last.stretch);
                EXPECT_LT(glm::length(exact[i].last.stretch - tiny[i].last.stretch), 2e-3 * length)
                    << c.name << " " << i << " " << duration;
                EXPECT_NEAR(expansion(exact[i]), expansion(tiny[i]), 4e-3) << c.name << " " << i;
                EXPECT_NEAR(expansion(exact[i]), expansion(alone[i]), 2e-3) << c.name << " " << i;
            }
        }
}

TEST(TrilinearCell, TheErrorFollowsTheTolerance) {
    for (const Sampled& c : flows()) {
        if (c.ball)
            continue;
        const auto flow = sampled(c.name, c.box);
        const auto traced = [&](double tolerance) {
            std::vector<Curve> made = curves(c, 3.0);
            EXPECT_TRUE(flow->trace(made,
                                    {.frozen = c.kind == SurfaceKind::Stream,
                                     .tolerance = tolerance,
                                     .longest_step = 0.1},
                                    {}));
            return made;
        };
        const std::vector<Curve> truth = traced(1e-13);
        for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
            const std::vector<Curve> made = traced(tolerance);
            for (std::size_t i = 0; i < made.size(); ++i) {
                if (made[i].end != CurveEnd::Time || made[i].last.arc == 0.0)
                    continue;
                EXPECT_LT(glm::length(made[i].last.position - truth[i].last.position),
                          10.0 * tolerance * made[i].last.arc *
                              magnification(*flow, c.kind, made[i].seed, made[i].release, 3.0))
                    << c.name << " " << i << " " << tolerance;
            }
        }
    }
}

TEST(TrilinearCell, EveryVertexOfASurfaceOfStoredDataEqualsItsOwnRetraceWithinTenTolerances) {
    std::mt19937 random(5);
    for (const Sampled& c : flows()) {
        const auto flow = sampled(c.name, c.box, c.ball);
        const Rake rake{Rake::Kind::Line, {c.from, c.to}, 16};
        SurfaceParameters p{.kind = c.kind, .to = 3.0, .separation = 0.1};
        const auto surface = build_surface(*flow, rake, p);
        const double tolerance = 1e-5;
        ASSERT_TRUE(surface);
        EXPECT_EQ(surface->mesh.validate(), "");
        const SeedingCurve seeding(rake);
        std::uniform_int_distribution<VertexId> pick(
            0, static_cast<VertexId>(surface->mesh.vertices() - 1));
        for (int i = 0; i < 60; ++i) {
            const VertexId v = pick(random);
            const double time = surface->mesh.t[v];
            if (time == 0.0 || surface->mesh.approximated[v])
                continue;
            const Vec3 seed = seeding.at(surface->mesh.s[v]);
            EXPECT_LT(
                glm::length(end_of(*flow, c.kind, seed, 0.0, time) - surface->mesh.position[v]),
                10.0 * tolerance * time * surface->mesh.speed(v) *
                    magnification(*flow, c.kind, seed, 0.0, time))
                << c.name << " vertex " << v;
        }
    }
}

TEST(SmoothSampling, EveryVertexOfAnExactSurfaceEqualsItsOwnSmoothRetraceWithinTenTolerances) {
    for (const Sampled& c : flows()) {
        if (c.ball)
            continue;
        const auto flow = sampled(c.name, c.box);
        const Rake rake{Rake::Kind::Line, {c.from, c.to}, 16};
        SurfaceParameters p{.kind = c.kind,
                            .to = 2.0,
                            .separation = 0.2,
                            .accuracy = Accuracy::Exact,
                            .interpolation = Interpolation::Smooth};
        const auto surface = build_surface(*flow, rake, p);
        ASSERT_TRUE(surface);
        const SeedingCurve seeding(rake);
        const double tolerance = 1e-9;
        for (VertexId v = 0; v < surface->mesh.vertices(); v += 97) {
            const double time = surface->mesh.t[v];
            if (time == 0.0)
                continue;
            const Vec3 seed = seeding.at(surface->mesh.s[v]);
            EXPECT_LT(glm::length(end_of(*flow, c.kind, seed, 0.0, time, true) -
                                  surface->mesh.position[v]),
                      10.0 * tolerance * (1.0 + time * surface->mesh.speed(v)) *
                          magnification(*flow, c.kind, seed, 0.0, time))
                << c.name << " vertex " << v;
        }
    }
}

TEST(TrilinearCell, AParticleLeavesExactlyAtTheBorder) {
    const auto flow = sampled("uniform?u=1,v=0.37,w=-0.2", {Vec3(-1), Vec3(1)});
    std::vector<Curve> curve(1);
    curve[0].seed = Vec3(-0.3, 0.1, 0.2);
    curve[0].duration = 100.0;
    ASSERT_TRUE(flow->trace(curve, {.frozen = true, .tolerance = 1e-6, .longest_step = 0.1}, {}));
    EXPECT_EQ(curve[0].end, CurveEnd::Domain);
    EXPECT_NEAR(curve[0].last.time, 1.3, 1e-6); // stored as float
    EXPECT_NEAR(curve[0].last.position.x, 1.0, 1e-12);
}

} // namespace wakesurf::core::trilinear_cell_test
