#include "core/field/analytic_flow.hpp"
#include "core/surface/budget_search.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/moving/moving_surface.hpp"
#include "tests/support/mesh_hash.hpp"
#include "tests/support/mesh_measures.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wakesurf::core::moving_surface_test {

using namespace tests;

namespace {

const SteadyClock steady_clock;

struct Case {
    const char* flow;
    Rake rake;
    double to;
    double separation;
    std::optional<Vec3> sweep; ///< a time surface; without it a streak surface
};

Rake line(Vec3 a, Vec3 b) {
    return {Rake::Kind::Line, {a, b}, 8};
}

Rake circle(Vec3 centre, double radius) {
    return {
        Rake::Kind::Circle, {centre, centre + Vec3(radius, 0, 0), centre + Vec3(0, radius, 0)}, 16};
}

/// Nothing tears in these.
const std::vector<Case>& smooth_cases() {
    static const std::vector<Case> all = {
        {"uniform", line({-9, 0, -3}, {-9, 0, 3}), 6, 0.2, {}},
        {"oscillating", line({0, -1, 0}, {0, 0, 1}), 4, 0.1, {}},
        {"shear", line({-10, 0, -0.5}, {-10, 0, 1}), 4, 0.1, {}},
        {"strain", line({-1, 4, 0}, {1, 4, 0.5}), 2, 0.1, {}},
        {"rotating-strain", line({0.1, 0, 0}, {1, 0, 1}), 4, 0.1, {}},
        {"lamb-oseen", line({0.3, 0, -5}, {1.5, 0, -5}), 2, 0.1, {}},
        {"abc?C=0.6", circle({0, 0, 0}, 1), 3, 0.15, {}},
        {"double-gyre", line({0.2, 0.5, 0}, {1.8, 0.5, 0}), 5, 0.1, {}},
        {"strain?a=-0.5,b=0.5", line({-2, 1, 0}, {2, 1, 0.5}), 3, 0.1, {}},
        {"hill", line({-0.3, 0.1, -2}, {0.5, 0.1, -2}), 3, 0.1, Vec3(0, 0.5, 0)},
        {"rotating-strain", line({0.1, 0, 0}, {1, 0, 1}), 4, 0.1, Vec3(0, 0.7, 0)},
        {"abc", circle({0, 0, 0}, 0.7), 3, 0.15, Vec3(0, 0, 1)},
    };
    return all;
}

/// The first of a flow, a streak surface unless `sweep` is asked for.
const Case& smooth_case(std::string_view flow, bool sweep = false) {
    const auto found = std::ranges::find_if(smooth_cases(), [&](const Case& each) {
        return std::string_view(each.flow) == flow && each.sweep.has_value() == sweep;
    });
    EXPECT_NE(found, smooth_cases().end()) << flow;
    return *found;
}

SurfaceParameters parameters(const Case& c, Accuracy accuracy = Accuracy::Balanced) {
    return {.kind = c.sweep ? SurfaceKind::Time : SurfaceKind::Streak,
            .to = c.to,
            .separation = c.separation,
            .accuracy = accuracy,
            .sweep = c.sweep};
}

MovingSurface started(const Flow& flow, const Case& c, const SurfaceParameters& p) {
    auto surface = MovingSurface::start(plan_surface(flow, c.rake, p).value(), {}, steady_clock);
    EXPECT_TRUE(surface) << c.flow << ": " << (surface ? "" : surface.error().message);
    return std::move(*surface);
}

QuadComplex finished(const Case& c, const SurfaceParameters& p) {
    const auto flow = make_analytic_flow(c.flow);
    MovingSurface surface = started(**flow, c, p);
    EXPECT_TRUE(surface.advance_to(surface.end_time(), {})) << c.flow;
    return surface.mesh().mesh;
}

/// Distance of every vertex from where its own particle is, traced again and finer than any surface is.
struct RetraceErrors {
    double traced = 0.0, approximated = 0.0;
};

RetraceErrors retraced(const Case& c, const QuadComplex& mesh) {
    const auto flow = make_analytic_flow(c.flow);
    const SeedingCurve seeding(c.rake);
    std::vector<Curve> curves;
    std::vector<std::size_t> of;
    for (std::size_t v = 0; v < mesh.vertices(); v += 1 + mesh.vertices() / 1000) {
        Curve curve;
        curve.seed = seeding.at(mesh.s[v]) + (c.sweep ? mesh.t[v] * *c.sweep : Vec3(0.0));
        curve.release = c.sweep ? 0.0 : mesh.t[v];
        curve.duration = c.to - curve.release;
        if (curve.duration <= 0.0)
            continue;
        curves.push_back(curve);
        of.push_back(v);
    }
    EXPECT_TRUE((*flow)->trace(curves, {.tolerance = 1e-11, .longest_step = 0.05}, {}));
    RetraceErrors errors;
    for (std::size_t i = 0; i < of.size(); ++i) {
        double& worst = mesh.approximated[of[i]] ? errors.approximated : errors.traced;
        worst = std::max(worst, glm::length(curves[i].last.position - mesh.position[of[i]]));
    }
    return errors;
}

} // namespace

TEST(MovingSurface, KeepsEveryInvariantAfterEveryStep) {
    for (const Case& c : smooth_cases())
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            const auto flow = make_analytic_flow(c.flow);
            MovingSurface surface = started(**flow, c, parameters(c, accuracy));
            while (surface.time() != surface.end_time()) {
                ASSERT_TRUE(surface.step(surface.end_time(), {}));
                const QuadComplex mesh = surface.mesh().mesh;
                ASSERT_EQ(surface.validate(), "") << c.flow << " at " << surface.time();
                ASSERT_LE(longest_edge(mesh), c.separation * (1.0 + 1e-6)) << c.flow;
                ASSERT_EQ(euler_characteristic(mesh), c.rake.closed() ? 0 : 1)
                    << c.flow << " at " << surface.time();
            }
        }
}

TEST(MovingSurface, TracedVerticesEqualTheirOwnRetraceAndInterpolatedOnesComeClose) {
    for (const Case& c : smooth_cases()) {
        const RetraceErrors exact = retraced(c, finished(c, parameters(c, Accuracy::Exact)));
        EXPECT_LE(exact.traced, 1e-7) << c.flow;
        EXPECT_EQ(exact.approximated, 0.0) << c.flow << ": nothing is interpolated in exact mode";
        const RetraceErrors balanced = retraced(c, finished(c, parameters(c)));
        EXPECT_LE(balanced.traced, 1e-3 * c.separation) << c.flow;
        EXPECT_LE(balanced.approximated, 0.05 * c.separation) << c.flow;
    }
}

TEST(MovingSurface, LambOseenStreakLiesOnItsClosedForm) {
    const Case c{"lamb-oseen", line({0.3, 0, -5}, {1.5, 0, -5}), 2, 0.05, {}};
    const QuadComplex mesh = finished(c, parameters(c, Accuracy::Exact));
    double worst = 0.0;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const double age = c.to - mesh.t[v];
        const double r = 0.3 + 1.2 * mesh.s[v];
        const double angle = age * (1.0 - std::exp(-r * r / 0.09)) / (r * r);
        const Vec3 truth(r * std::cos(angle), r * std::sin(angle), -5.0 + 0.5 * age);
        worst = std::max(worst, glm::length(mesh.position[v] - truth));
    }
    EXPECT_LE(worst, 1e-5);
}

TEST(MovingSurface, HermiteInsertionIsOfThirdOrderInTheSeparation) {
    // The largest error is that of one vertex, and not of the same one each time: hence not 3 exactly.
    const Case swirl{"lamb-oseen", line({0.3, 0, -5}, {1.5, 0, -5}), 1, 0.1, {}};
    const Case abc{"abc", line({0, 0, 0}, {1, 0, 0}), 3, 0.2, {}};
    for (const Case& coarse : {swirl, abc}) {
        std::vector<double> worst;
        for (const double part : {1.0, 0.5, 0.25}) {
            Case c = coarse;
            c.separation = part * coarse.separation;
            worst.push_back(retraced(c, finished(c, parameters(c))).approximated);
        }
        EXPECT_LE(worst[1], 1e-3) << coarse.flow;
        EXPECT_GE(std::log2(worst[0] / worst[2]) / 2.0, 2.75)
            << coarse.flow << ' ' << worst[0] << ' ' << worst[1] << ' ' << worst[2];
    }
}

TEST(MovingSurface, OscillatingStreakIsTheStreakNotThePath) {
    Case c{"oscillating", line({0, 0, -1}, {0, 0, 1}), 5, 0.1, {}};
    const QuadComplex streak = finished(c, parameters(c, Accuracy::Exact));
    double off_path = 0.0;
    for (std::size_t v = 0; v < streak.vertices(); ++v) {
        const double released = streak.t[v];
        EXPECT_NEAR(streak.position[v].x, 5.0 - released, 1e-6);
        EXPECT_NEAR(streak.position[v].y, 0.5 * (std::cos(2 * released) - std::cos(10.0)), 1e-6);
        const double along = streak.position[v].x;
        off_path =
            std::max(off_path, std::abs(streak.position[v].y - 0.5 * (1.0 - std::cos(2 * along))));
    }
    EXPECT_GT(off_path, 0.3);
}

TEST(MovingSurface, ATimeSurfaceIsItsPatchCarriedByTheFlow) {
    const Case c{"strain?a=0.5,b=-0.5", line({1, 1, 0}, {2, 1, 0}), 2, 0.1, Vec3(0, 1, 0)};
    const QuadComplex mesh = finished(c, parameters(c, Accuracy::Exact));
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        EXPECT_NEAR(mesh.position[v].x, (1.0 + mesh.s[v]) * std::exp(1.0), 1e-7);
        EXPECT_NEAR(mesh.position[v].y, (1.0 + mesh.t[v]) * std::exp(-1.0), 1e-7);
    }
    EXPECT_NEAR(area(mesh), 1.0, 1e-6); // the strain keeps area
}

TEST(MovingSurface, ASecondRakeBoundsThePatchLikeASweep) {
    Case c{"strain", line({1, 1, 0}, {2, 1, 0}), 1, 0.1, Vec3(0, 1, 0)};
    const QuadComplex swept = finished(c, parameters(c));
    SurfaceParameters p = parameters(c);
    p.sweep.reset();
    p.rake2 = line({1, 2, 0}, {2, 2, 0});
    const QuadComplex between = finished(c, p);
    ASSERT_EQ(swept.vertices(), between.vertices());
    for (std::size_t v = 0; v < swept.vertices(); ++v)
        EXPECT_LT(glm::length(swept.position[v] - between.position[v]), 1e-12);
}

TEST(MovingSurface, AStreakSheetLeavesTheRakeWhenTheReleaseStops) {
    const Case c{"uniform", line({-9, 0, -1}, {-9, 0, 1}), 6, 0.1, {}};
    SurfaceParameters p = parameters(c);
    p.release_until = 2.0;
    const QuadComplex mesh = finished(c, p);
    const auto [low, high] = std::minmax_element(mesh.t.begin(), mesh.t.end());
    EXPECT_DOUBLE_EQ(*low, 0.0);
    EXPECT_DOUBLE_EQ(*high, 2.0);
    EXPECT_NEAR(area(mesh), 4.0, 1e-9);
    for (const Vec3& position : mesh.position)
        EXPECT_GE(position.x, -5.0 - 1e-9);
}

TEST(MovingSurface, ShearIsMetWithSquareQuads) {
    for (const Case& c : {Case{"shear", line({-10, 0, -0.5}, {-10, 0, 2}), 6, 0.1, {}},
                          Case{"lamb-oseen", line({0.3, 0, -5}, {1.5, 0, -5}), 2, 0.1, {}}}) {
        const QuadComplex mesh = finished(c, parameters(c));
        EXPECT_GE(median_smallest_angle(mesh), 55.0) << c.flow;
        // Of cells as large as they may be an area has as many as of squares with three quarters of the
        // separation.
        EXPECT_LE(static_cast<double>(mesh.cells.size()),
                  1.7 * area(mesh) / std::pow(0.75 * c.separation, 2.0))
            << c.flow;
    }
}

TEST(MovingSurface, MergingKeepsAConvergingSurfaceCoarse) {
    const Case c{"strain?a=-1,b=1", line({-4, 0.3, 0}, {4, 0.3, 0.5}), 3.5, 0.1, Vec3(0, 0, 1)};
    SurfaceParameters p = parameters(c);
    const QuadComplex merged = finished(c, p);
    p.merge = 0.0;
    const QuadComplex all = finished(c, p);
    EXPECT_LE(static_cast<double>(merged.cells.size()),
              0.4 * static_cast<double>(all.cells.size()));
    EXPECT_LE(longest_edge(merged), c.separation * (1.0 + 1e-6));
}

TEST(MovingSurface, ASphereTearsTheSheetAndBothPartsGoOn) {
    for (const Accuracy accuracy : {Accuracy::Balanced, Accuracy::Exact}) {
        const Case c{"sphere", line({-2, -1, 0}, {-2, 1, 0}), 7, 0.1, {}}; // on the stagnation line
        const auto flow = make_analytic_flow(c.flow);
        MovingSurface surface = started(**flow, c, parameters(c, accuracy));
        while (surface.time() != surface.end_time()) {
            ASSERT_TRUE(surface.step(surface.end_time(), {}));
            ASSERT_EQ(surface.validate(), "") << surface.time();
        }
        const QuadComplex mesh = surface.mesh().mesh;
        double left = 0.0, right = 0.0;
        for (const Vec3& position : mesh.position) {
            EXPECT_GE(glm::length(position), 0.5 - 1e-6);
            if (position.y < -0.1)
                left = std::max(left, position.x);
            if (position.y > 0.1)
                right = std::max(right, position.x);
        }
        EXPECT_GT(left, 3.0);
        EXPECT_GT(right, 3.0);
        for (const Cell& cell : mesh.cells)
            for (std::size_t i = 0; i < 4; ++i) {
                const Vec3 middle =
                    0.5 * (mesh.position[cell.corner[i]] + mesh.position[cell.corner[(i + 1) % 4]]);
                EXPECT_GE(glm::length(middle), 0.5 - 0.25 * c.separation);
            }
        // A fork: two prongs, one on each side of the body, and nothing between them or missing in them.
        EXPECT_EQ(boundary_loops(mesh), 1);
        for (const Cell& cell : mesh.cells) {
            double low = 1e300, high = -1e300;
            for (const VertexId v : cell.corner)
                if (mesh.position[v].x > 0.6) {
                    low = std::min(low, mesh.position[v].y);
                    high = std::max(high, mesh.position[v].y);
                }
            EXPECT_FALSE(low < -1e-3 && high > 1e-3) << "a cell lies across the wake";
        }
    }
}

TEST(MovingSurface, WhatLeavesTheDomainIsTornOffAndCounted) {
    const Case c{"uniform", line({8, -1, 0}, {8, 1, 0.3}), 6, 0.1, {}};
    const auto flow = make_analytic_flow(c.flow);
    MovingSurface surface = started(**flow, c, parameters(c));
    ASSERT_TRUE(surface.advance_to(c.to, {}));
    const QuadComplex mesh = surface.mesh().mesh;
    EXPECT_GT(surface.statistics().terminated.domain, 0u);
    EXPECT_EQ(surface.validate(), "");
    double farthest = 0.0;
    for (const Vec3& position : mesh.position)
        farthest = std::max(farthest, position.x);
    EXPECT_LE(farthest, 10.0);
    EXPECT_GE(farthest, 10.0 - 0.5 * c.separation); // refined towards the border before it is cut
}

TEST(MovingSurface, SameBytesForAnyNumberOfThreads) {
    for (const Case& c : {smooth_case("lamb-oseen"), smooth_case("abc?C=0.6"),
                          smooth_case("double-gyre"), smooth_case("hill", true)}) {
        const auto flow = make_analytic_flow(c.flow);
        std::uint64_t first = 0;
        for (const int threads : {1, 2, 3, 8}) {
            const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 8);
            tbb::task_arena arena(threads);
            arena.execute([&] {
                MovingSurface surface = started(**flow, c, parameters(c));
                ASSERT_TRUE(surface.advance_to(surface.end_time(), {}));
                const std::uint64_t now = hash(surface.mesh());
                first = threads == 1 ? now : first;
                EXPECT_EQ(now, first) << c.flow << ", " << threads << " threads";
            });
        }
    }
}

TEST(MovingSurface, SteppingOnFromACheckpointGivesTheSameBytes) {
    const Case c = smooth_case("double-gyre");
    const auto flow = make_analytic_flow(c.flow);
    MovingSurface surface = started(**flow, c, parameters(c));
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(surface.step(c.to, {}));
    const MovingState checkpoint = surface.state();
    ASSERT_TRUE(surface.advance_to(c.to, {}));
    const std::uint64_t straight = hash(surface.mesh());
    surface.restore(checkpoint);
    EXPECT_EQ(surface.time(), checkpoint.mesh.time);
    ASSERT_TRUE(surface.advance_to(c.to, {}));
    EXPECT_EQ(hash(surface.mesh()), straight);
}

TEST(MovingSurface, TheQuadBudgetCoarsensAndSaysSo) {
    Case c = smooth_case("double-gyre");
    SurfaceParameters p = parameters(c);
    p.max_quads = 300;
    const auto flow = make_analytic_flow(c.flow);
    MovingSurface surface = started(**flow, c, p);
    while (surface.time() != surface.end_time()) {
        ASSERT_TRUE(surface.step(surface.end_time(), {}));
        ASSERT_LE(surface.state().mesh.triangles.quads(), 300u);
        ASSERT_EQ(surface.validate(), "");
    }
    EXPECT_TRUE(surface.statistics().coarsened());
    EXPECT_EQ(surface.statistics().requested_separation, c.separation);
    EXPECT_LE(surface.statistics().separation, coarsest_separation((*flow)->domain()));
}

TEST(MovingSurface, ALiveMeshStaysWithinItsMemory) {
    const Case c{"lamb-oseen", line({0.3, 0, -5}, {1.5, 0, -5}), 2, 0.03, {}};
    const auto flow = make_analytic_flow(c.flow);
    MovingSurface surface = started(**flow, c, parameters(c));
    ASSERT_TRUE(surface.advance_to(c.to, {}));
    const MovingState& state = surface.state();
    EXPECT_LE(state.bytes(), 200 * state.mesh.vertices.used() + 100 * state.mesh.triangles.quads());
}

TEST(MovingSurface, DeformationIsTheAreaRatioOfTheFlowMap) {
    const Case c{"strain?a=0.5,b=0,c=-0.5", line({1, -1, 0}, {1, 1, 0}), 2, 0.1, Vec3(1, 0, 0)};
    SurfaceParameters p = parameters(c, Accuracy::Exact);
    p.deformation = true;
    const QuadComplex mesh = finished(c, p);
    for (const float deformation : mesh.deformation)
        EXPECT_NEAR(deformation, 0.5 * c.to / M_LN2, 1e-4);
}

TEST(MovingSurface, ARakeInsideAnObstacleGivesAnEmptySurface) {
    const auto flow = make_analytic_flow("sphere");
    SurfaceParameters p{.kind = SurfaceKind::Streak, .separation = 0.1};
    const auto surface = build_surface(**flow, line({-0.2, 0, 0}, {0.2, 0, 0}), p);
    ASSERT_TRUE(surface);
    EXPECT_TRUE(surface->mesh.cells.empty());
    EXPECT_GT(surface->statistics.terminated.obstacle, 0u);
}

TEST(MovingSurface, ImpossibleRequestsAreRefused) {
    const auto flow = make_analytic_flow("uniform");
    const Rake rake = line({0, 0, 0}, {1, 0, 0});
    const auto refused = [&](auto change) {
        SurfaceParameters p{.kind = SurfaceKind::Time, .separation = 0.1, .sweep = Vec3(0, 1, 0)};
        change(p);
        const auto surface = build_surface(**flow, rake, p);
        return surface ? std::string("made") : surface.error().message;
    };
    EXPECT_EQ(refused([](auto&) {}), "made");
    EXPECT_NE(refused([](auto& p) { p.sweep.reset(); }), "made");
    EXPECT_NE(refused([&](auto& p) { p.rake2 = rake; }), "made");
    EXPECT_NE(refused([](auto& p) { p.sweep = Vec3(0.0); }), "made");
    EXPECT_NE(refused([](auto& p) { p.sweep = Vec3(NAN, 0, 0); }), "made");
    EXPECT_NE(refused([](auto& p) { p.kind = SurfaceKind::Streak; }), "made");
    EXPECT_NE(refused([](auto& p) {
                  p.kind = SurfaceKind::Streak, p.sweep.reset(), p.release_until = 2.0;
              }),
              "made");
    EXPECT_NE(refused([](auto& p) { p.separation = -1.0; }), "made");
    EXPECT_NE(refused([](auto& p) { p.separation = NAN; }), "made");
    EXPECT_NE(refused([](auto& p) { p.to = p.from; }), "made");
    EXPECT_NE(refused([](auto& p) { p.merge = 0.6; }), "made");
    EXPECT_NE(refused([](auto& p) { p.angle = 0.0; }), "made");
}

TEST(MovingSurface, AbsurdSeparationsAndSeedsEndInACoarseSurfaceOrAnError) {
    const auto flow = make_analytic_flow("uniform");
    for (const auto kind : {SurfaceKind::Streak, SurfaceKind::Time}) {
        SurfaceParameters p{.kind = kind, .to = 2.0, .separation = 4e-5, .max_quads = 5'000};
        if (kind == SurfaceKind::Time)
            p.sweep = Vec3(0, 0, 2);
        const auto surface = value_of(build_surface(**flow, line({-9, -2, 0}, {-9, 2, 0}), p));
        EXPECT_LE(surface.statistics.quads, 5'000u);
        EXPECT_GT(surface.statistics.quads, 500u);
        Rake crowded = line({-9, -2, 0}, {-9, 2, 0});
        crowded.seeds = 1'000'000'000;
        const auto of_crowded = value_of(build_surface(**flow, crowded, p));
        EXPECT_LE(of_crowded.statistics.quads, 5'000u);
        EXPECT_TRUE(of_crowded.statistics.coarsened());
    }
}

TEST(MovingSurface, ThePolylinesCornersAreVertices) {
    const auto flow = make_analytic_flow("uniform");
    const Rake bent{Rake::Kind::Polyline, {{-9, 0, 0}, {-9, 0.333, 0}, {-9, 0.333, 0.777}}, 4};
    for (const auto kind : {SurfaceKind::Streak, SurfaceKind::Stream}) {
        SurfaceParameters p{.kind = kind, .to = 2.0, .separation = 0.1};
        const auto surface = build_surface(**flow, bent, p);
        ASSERT_TRUE(surface);
        EXPECT_NEAR(area(surface->mesh), 2.0 * (0.333 + 0.777), 1e-9);
    }
}

TEST(MovingSurface, AStopRequestCancels) {
    std::stop_source stop;
    stop.request_stop();
    const Case c = smooth_cases()[5];
    const auto flow = make_analytic_flow(c.flow);
    const auto surface = build_surface(**flow, c.rake, parameters(c), stop.get_token());
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::moving_surface_test
