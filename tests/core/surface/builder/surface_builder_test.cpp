#include "core/field/analytic_flow.hpp"
#include "core/surface/budget_search.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <numbers>
#include <random>

namespace wakesurf::core::surface_builder_test {

using namespace tests;

namespace {

struct Case {
    const char* flow;
    Rake rake;
    double to;
    double separation;
    SurfaceKind kind = SurfaceKind::Stream;
};

Rake line(Vec3 a, Vec3 b, std::uint32_t seeds = 16) {
    return {Rake::Kind::Line, {a, b}, seeds};
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"uniform", line({-9, 0, -3}, {-9, 0, 3}), 10, 0.2},
        {"lamb-oseen", line({0.1, 0, -5}, {1.5, 0, -5}), 3, 0.05},
        {"abc", line({0, 0, 0}, {3, 0, 0}), 6, 0.1},
        {"strain", line({-1, 4, 0}, {1, 4, 0.5}), 3, 0.1},
        {"shear", line({-10, 0, -0.5}, {-10, 0, 2}), 6, 0.1},
        {"sphere", line({-4, 0.01, -2}, {-4, 0.02, 2}), 9, 0.1},
        {"sphere", line({-4, -2, 0}, {-4, 2, 0}), 9, 0.1},
        {"cylinder", line({-4, -2, 0}, {-4, 2, 0.5}), 9, 0.1},
        {"tornado", line({0.3, 0.5, 0.1}, {0.7, 0.5, 0.6}), 5, 0.01},
        {"stagnation", line({-1, 0, 3}, {1, 0.5, 3}), 3, 0.1},
        {"hill", line({-0.3, 0, -2}, {0.5, 0, -2}), 8, 0.05},
        {"oscillating", line({0, -1, 0}, {0, 0, 1}), 5, 0.05, SurfaceKind::Path},
        {"double-gyre", line({0.2, 0.5, 0}, {1.8, 0.5, 0}), 8, 0.05, SurfaceKind::Path},
        {"rotating-strain", line({0.1, 0, 0}, {1, 0, 1}), 4, 0.1, SurfaceKind::Path},
        {"abc?A=1,B=0.8,C=0.6",
         {Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 24},
         5,
         0.1},
    };
    return all;
}

SurfaceParameters parameters(const Case& c, Accuracy accuracy = Accuracy::Balanced) {
    return {.kind = c.kind, .to = c.to, .separation = c.separation, .accuracy = accuracy};
}

Surface built(const Case& c, const SurfaceParameters& p) {
    auto surface = build_surface(**make_analytic_flow(c.flow), c.rake, p);
    EXPECT_TRUE(surface) << c.flow << ": " << (surface ? "" : surface.error().message);
    return std::move(*surface);
}

/// Where a particle is after `time`, integrated again and finer than any surface is.
Vec3 retraced(const Flow& flow, const Vec3& seed, double time, SurfaceKind kind) {
    std::vector<Curve> curve(1);
    curve[0].seed = seed;
    curve[0].duration = time;
    EXPECT_TRUE(flow.trace(
        curve, {.frozen = kind == SurfaceKind::Stream, .tolerance = 1e-12, .longest_step = 0.02},
        {}));
    return curve[0].last.position;
}

} // namespace

TEST(SurfaceBuilder, EverySurfaceIsWatertightOrientedAndNoEdgeIsLongerThanTheSeparation) {
    for (const Case& c : cases()) {
        const Surface surface = built(c, parameters(c));
        EXPECT_EQ(surface.mesh.validate(), "") << c.flow;
        EXPECT_GT(surface.mesh.cells.size(), 100u) << c.flow;
        EXPECT_LE(surface.statistics.max_edge, c.separation * (1.0 + 1e-6)) << c.flow;
        for (const auto& [edge, uses] : edge_uses(surface.mesh))
            ASSERT_LE(uses, 2) << c.flow;
    }
}

TEST(SurfaceBuilder, UntornSheetsAreDiscsAndCircularRakesMakeTubes) {
    for (const Case& c : cases()) {
        if (std::string_view(c.flow).starts_with("sphere") ||
            std::string_view(c.flow) == "cylinder")
            continue;
        const Surface surface = built(c, parameters(c));
        const bool tube = c.rake.closed();
        EXPECT_EQ(euler_characteristic(surface.mesh), tube ? 0 : 1) << c.flow;
        EXPECT_EQ(boundary_loops(surface.mesh), tube ? 2 : 1) << c.flow;
    }
}

TEST(SurfaceBuilder, EveryVertexEqualsItsOwnRetraceFromTheRake) {
    std::mt19937 random(11);
    for (const Case& c : cases()) {
        if (std::string_view(c.flow) == "tornado")
            continue; // its magnitude jumps, so no step size converges to 1e-6 of it
        const auto flow = make_analytic_flow(c.flow);
        const Surface surface = built(c, parameters(c, Accuracy::Exact));
        const SeedingCurve seeding(c.rake);
        std::uniform_int_distribution<std::size_t> pick(0, surface.mesh.vertices() - 1);
        for (int i = 0; i < 40; ++i) {
            const std::size_t v = pick(random);
            const double time = surface.mesh.t[v];
            if (time == 0.0)
                continue;
            const Vec3 seed = seeding.at(surface.mesh.s[v]);
            const Vec3 truth = retraced(**flow, seed, time, c.kind);
            // Near a stagnation point neighbours part exponentially; errors grow as the flow map stretches.
            const double nudge = 1e-7;
            const double stretch =
                glm::length(retraced(**flow, seed + Vec3(nudge), time, c.kind) - truth) / nudge;
            EXPECT_LT(glm::length(truth - surface.mesh.position[v]), 1e-7 * (1.0 + stretch))
                << c.flow << " vertex " << v;
        }
    }
}

TEST(SurfaceBuilder, LambOseenVerticesLieOnTheClosedForm) {
    const Case c = cases()[1];
    const Surface surface = built(c, parameters(c, Accuracy::Exact));
    double worst = 0.0;
    for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
        const double r = 0.1 + 1.4 * surface.mesh.s[v];
        const double angle = surface.mesh.t[v] * (1.0 - std::exp(-r * r / 0.09)) / (r * r);
        const Vec3 truth(r * std::cos(angle), r * std::sin(angle), -5.0 + 0.5 * surface.mesh.t[v]);
        worst = std::max(worst, glm::length(surface.mesh.position[v] - truth));
    }
    EXPECT_LT(worst, 1e-5);
}

TEST(SurfaceBuilder, StreamAndPathSurfacesOfAnUnsteadyFlowDifferAsTheirFormulasDo) {
    Case c{"oscillating", line({0, 0, -1}, {0, 0, 1}), 5, 0.1};
    SurfaceParameters p = parameters(c, Accuracy::Exact);
    p.from = 0.3;
    p.to = 5.3;
    const Surface stream = built(c, p);
    for (std::size_t v = 0; v < stream.mesh.vertices(); ++v)
        ASSERT_NEAR(stream.mesh.position[v].y, std::sin(0.6) * stream.mesh.position[v].x, 1e-6);
    p.kind = SurfaceKind::Path;
    const Surface path = built(c, p);
    for (std::size_t v = 0; v < path.mesh.vertices(); ++v) {
        const double now = 0.3 + path.mesh.t[v];
        ASSERT_NEAR(path.mesh.position[v].y, 0.5 * (std::cos(0.6) - std::cos(2 * now)), 1e-6);
    }
}

TEST(SurfaceBuilder, ASphereSplitsTheSheetAndNoPartEntersIt) {
    const Case c = cases()[6]; // the rake crosses the stagnation line
    const Surface surface = built(c, parameters(c));
    double farthest_left = 0.0, farthest_right = 0.0;
    for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
        const Vec3& p = surface.mesh.position[v];
        EXPECT_GT(glm::length(p), 0.5 - 1e-6);
        if (p.x > 1.0)
            (p.y < 0 ? farthest_left : farthest_right) =
                std::max(p.y < 0 ? farthest_left : farthest_right, p.x);
    }
    EXPECT_GT(farthest_left, 3.0);
    EXPECT_GT(farthest_right, 3.0);
    for (const Cell& cell :
         surface.mesh.cells) { // chords dip in by less than a quarter of the separation
        Vec3 centre(0.0);
        for (const VertexId v : cell.corner)
            centre += 0.25 * surface.mesh.position[v];
        EXPECT_GT(glm::length(centre), 0.5 - 0.25 * c.separation);
    }
    // Downstream no cell spans the wake from one side to the other.
    for (const Cell& cell : surface.mesh.cells)
        if (surface.mesh.position[cell.corner[0]].x > 0.6) {
            EXPECT_GT(surface.mesh.position[cell.corner[0]].y *
                          surface.mesh.position[cell.corner[2]].y,
                      0.0);
        }
}

TEST(SurfaceBuilder, ARakeThroughAnObstacleMakesTwoSurfaces) {
    const Case c{"sphere", line({0, -2, 0}, {0, 2, 0}), 3, 0.1};
    const Surface surface = built(c, parameters(c));
    EXPECT_EQ(surface.mesh.validate(), "");
    EXPECT_EQ(*std::max_element(surface.mesh.component.begin(), surface.mesh.component.end()), 1u);
    for (const Vec3& p : surface.mesh.position)
        EXPECT_GT(glm::length(p), 0.5 - 1e-6);
}

TEST(SurfaceBuilder, TheSheetEndsAtTheDomainsBorder) {
    const Case c{"uniform", line({8, -1, 0}, {8, 1, 0.3}), 10, 0.1};
    const Surface surface = built(c, parameters(c));
    EXPECT_GT(surface.statistics.terminated.domain, 0u);
    EXPECT_EQ(surface.statistics.terminated.time, 0u);
    EXPECT_NEAR(area(surface.mesh), 2.0 * std::hypot(2.0, 0.3), 1e-9);
}

TEST(SurfaceBuilder, SameBytesForAnyNumberOfThreads) {
    for (const Case& c : cases()) {
        Surface first;
        for (const int threads : {1, 2, 3, 8}) {
            const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 8);
            tbb::task_arena arena(threads);
            Surface surface = arena.execute([&] { return built(c, parameters(c)); });
            if (threads == 1) {
                first = std::move(surface);
                continue;
            }
            ASSERT_EQ(first.mesh.cells, surface.mesh.cells)
                << c.flow << ", " << threads << " threads";
            ASSERT_EQ(first.mesh.position, surface.mesh.position)
                << c.flow << ", " << threads << " threads";
            ASSERT_EQ(first.mesh.velocity, surface.mesh.velocity)
                << c.flow << ", " << threads << " threads";
        }
    }
}

TEST(SurfaceBuilder, BothDirectionsShareTheRakeAndFaceTheSameWay) {
    const Case c{"abc", line({0, 0, 0}, {3, 0, 0}), 3, 0.1};
    SurfaceParameters p = parameters(c);
    p.direction = Direction::Both;
    const Surface surface = built(c, p);
    EXPECT_EQ(surface.mesh.validate(), "");
    EXPECT_EQ(euler_characteristic(surface.mesh), 1);
    p.direction.reset();
    p.to = p.from - (p.to - p.from);
    const Surface back = built(c, p);
    EXPECT_LT(*std::min_element(back.mesh.t.begin(), back.mesh.t.end()), -2.9);
    EXPECT_LE(*std::max_element(back.mesh.t.begin(), back.mesh.t.end()), 0.0);
}

TEST(SurfaceBuilder, DeformationIsTheAreaRatioOfTheFlowMap) {
    // Uniform strain in the plane of the sheet: area grows as exp((a + b) t), b = 0 across the rake here.
    const Case c{"strain?a=0.5,b=0,c=-0.5", line({1, -1, 0}, {1, 1, 0}), 2, 0.1};
    SurfaceParameters p = parameters(c);
    p.deformation = true;
    const Surface surface = built(c, p);
    for (std::size_t v = 0; v < surface.mesh.vertices(); ++v)
        ASSERT_NEAR(surface.mesh.deformation[v], 0.5 * surface.mesh.t[v] / std::numbers::ln2, 2e-3);
}

TEST(SurfaceBuilder, TheQuadBudgetCoarsensAndSaysSo) {
    const Case c = cases()[1];
    SurfaceParameters p = parameters(c);
    for (const std::uint64_t most : {2000, 4000}) {
        p.max_quads = most;
        const Surface surface = built(c, p);
        EXPECT_LE(surface.statistics.quads, most);
        EXPECT_GE(surface.statistics.quads, most * 7 / 10);
        EXPECT_TRUE(surface.statistics.coarsened());
        EXPECT_EQ(surface.statistics.requested_separation, c.separation);
    }
}

TEST(SurfaceBuilder, BothDirectionsShareOneBudgetAndSeedsGiveWayBeforeTheSeparationIsAbsurd) {
    const Case c{"uniform", line({0, -1, 0}, {0, 1, 0}, 100), 20, 0.02};
    SurfaceParameters p = parameters(c);
    p.direction = Direction::Both;
    p.max_quads = 200;
    const Surface surface = built(c, p);
    EXPECT_LE(surface.statistics.quads, 200u);
    EXPECT_GE(surface.statistics.quads, 100u);
    EXPECT_LE(surface.statistics.separation,
              coarsest_separation((*make_analytic_flow(c.flow))->domain()));
}

TEST(SurfaceBuilder, ASurfaceThatFitsAtNoSeparationIsRefusedWithWhatToDo) {
    const auto flow = make_analytic_flow("uniform");
    SurfaceParameters p{.to = 8.0, .separation = 0.1, .max_quads = 3};
    const auto surface = build_surface(**flow, line({-9, -9, 0}, {-9, 9, 0}), p);
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, Error::Code::OverLimit);
    EXPECT_EQ(surface.error().message,
              "the surface needs more than 3 quads, even at a separation of 2");
}

TEST(SurfaceBuilder, AnAbsurdSeparationIsCoarsenedBeforeMillionsOfColumnsAreTraced) {
    const Case c{"uniform", line({-9, -5, 0}, {-9, 5, 0}), 10, 4e-5};
    SurfaceParameters p = parameters(c);
    p.max_quads = 20'000;
    const Surface surface = built(c, p);
    EXPECT_LE(surface.statistics.quads, 20'000u);
    EXPECT_GT(surface.statistics.quads, 8'000u);
}

TEST(SurfaceBuilder, ParticlesThatCircleForEverEndAtTheStepBudget) {
    const Case c{"rotation?w=0", line({1, 0, 0}, {3, 0, 0}), 1e7, 0.5};
    SurfaceParameters p = parameters(c);
    p.max_quads = 20'000;
    const Surface surface = built(c, p);
    EXPECT_GT(surface.statistics.terminated.budget, 0u);
    EXPECT_LE(surface.statistics.quads, 20'000u);
    EXPECT_EQ(surface.mesh.validate(), "");
}

TEST(SurfaceBuilder, ImpossibleRequestsAreRefused) {
    const auto flow = make_analytic_flow("uniform");
    SurfaceParameters p;
    p.kind = SurfaceKind::Stream;
    p.to = p.from - 1.0;
    p.direction = Direction::Forward;
    EXPECT_EQ(build_surface(**flow, line({0, 0, 0}, {1, 0, 0}), p).error().code,
              Error::Code::InvalidArgument);
    p.to = p.from;
    EXPECT_EQ(build_surface(**flow, line({0, 0, 0}, {1, 0, 0}), p).error().code,
              Error::Code::InvalidArgument);
    p.to = 1.0;
    p.max_quads = 10;
    p.to = std::nan("");
    EXPECT_EQ(build_surface(**flow, line({0, 0, 0}, {1, 0, 0}), p).error().code,
              Error::Code::InvalidArgument);
}

TEST(SurfaceBuilder, AStopRequestCancels) {
    std::stop_source stop;
    stop.request_stop();
    const Case c = cases()[1];
    const auto surface =
        build_surface(**make_analytic_flow(c.flow), c.rake, parameters(c), stop.get_token());
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::surface_builder_test
