// Particles and curves through meshes of cells, beside closed forms.
#include "core/surface/moving/moving_surface.hpp"
#include "tests/support/meshed_source.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <random>

namespace wakesurf::core::cell_flow_test {

using namespace tests;

namespace {

/// Half of a ball is fine, the surface between goes through all kinds of cells.
CellMesh refined(std::uint32_t n, const Bend& bend) {
    return TwoToOne(
               n,
               [](const Vec3& c) {
                   return glm::length(c - 0.45) < 0.31 ? TwoToOne::Kind::Fine
                                                       : TwoToOne::Kind::Coarse;
               },
               bend)
        .take();
}

std::vector<Vec3> curve_seeds(int count) {
    std::vector<Vec3> seeds;
    for (int i = 0; i < count; ++i) // places on faces and nodes among them
        seeds.push_back(
            wavy(glm::fract(Vec3(i % 5 == 0 ? 0.125 * (i % 8) : 0.31 * i, 0.0617 * i, 0.5))));
    return seeds;
}

AdvanceOptions advance() {
    return {.method = AdvanceOptions::Method::Dopri5, .longest_step = 0.1};
}

std::vector<Curve> curves_from(int count, const Vec3& lo, const Vec3& hi, double duration) {
    std::mt19937 random(29);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<Curve> curves(static_cast<std::size_t>(count));
    for (Curve& curve : curves) {
        const double x = part(random), y = part(random), z = part(random);
        curve.seed = lo + (hi - lo) * Vec3(x, y, z);
        curve.duration = duration;
    }
    return curves;
}

} // namespace

TEST(CellFlow, NoStreamlineEndsInsideTheFluidOfARefinedMesh) {
    // Round the sphere of radius 1/4 in the middle, which the mesh does not know of: nothing may end a line but the sides.
    const auto flow = meshed_flow(refined(12, wavy), {0.0}, [](const Vec3& p, double) {
        return Vec3(1.0, 0.4 * std::sin(7.0 * p.x + 2.0 * p.z), 0.4 * std::cos(6.0 * p.x + p.y));
    });
    std::vector<Curve> curves = curves_from(400, Vec3(0.01), Vec3(0.3, 0.99, 0.99), 100.0);
    TraceOptions options{.frozen = true, .longest_step = 0.1};
    ASSERT_TRUE(flow->trace(curves, options, {}));
    int at_side = 0;
    for (const Curve& curve : curves) {
        const Vec3 p = curve.last.position;
        const Vec3 from_middle = glm::abs(p - 0.5);
        const double side = std::max({from_middle.x, from_middle.y, from_middle.z});
        EXPECT_EQ(curve.end, CurveEnd::Domain);
        EXPECT_NEAR(side, 0.5, 1e-8) << p.x << " " << p.y << " " << p.z;
        at_side += std::abs(side - 0.5) < 1e-8;
    }
    EXPECT_EQ(at_side, 400);
}

TEST(CellFlow, ALinearVelocityGivesTheClosedFormsPathThroughAllShapes) {
    // A rotation: linear, so that the mesh changes nothing but by the rounding of its nodes to float.
    const auto flow = meshed_flow(refined(8, wavy), {0.0}, [](const Vec3& p, double) {
        return Vec3(0.5 - p.y, p.x - 0.5, 0.0);
    });
    std::vector<Curve> curves =
        curves_from(50, Vec3(0.3, 0.3, 0.1), Vec3(0.7, 0.7, 0.9), 2.0 * 3.14159265358979323846);
    TraceOptions options{.frozen = true, .tolerance = 1e-8, .longest_step = 0.1};
    ASSERT_TRUE(flow->trace(curves, options, {}));
    for (const Curve& curve : curves) {
        EXPECT_EQ(curve.end, CurveEnd::Time);
        EXPECT_LT(glm::length(curve.last.position - curve.seed), 1e-6);
    }
}

TEST(CellFlow, IsTheSameToTheBitOnAnyNumberOfThreads) {
    const auto flow =
        meshed_flow(refined(10, wavy), {0.0, 0.4, 1.0, 2.0}, [](const Vec3& p, double t) {
            return Vec3(0.2 + 0.3 * std::sin(5.0 * p.y + t), 0.3 * std::cos(7.0 * p.x - t),
                        0.1 * std::sin(t));
        });
    std::vector<Vec3> expected;
    std::vector<Vec3> expected_ends;
    for (const std::size_t threads : {1u, 2u, 3u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<Curve> curves = curves_from(200, Vec3(0.05), Vec3(0.95), 1.7);
        std::vector<Vec3> position, s, t;
        for (const Curve& curve : curves) {
            position.push_back(curve.seed);
            s.push_back({1, 0, 0});
            t.push_back({0, 1, 0});
        }
        std::vector<double> time(position.size(), 0.0);
        std::vector<CurveEnd> end(position.size(), CurveEnd::Running);
        AdvanceOptions advance;
        advance.step = 0.02;
        ASSERT_TRUE(flow->advance({position, s, t, time, end}, 1.7, advance, {}));
        position.insert(position.end(), s.begin(), s.end());
        TraceOptions options;
        options.longest_step = 0.1;
        ASSERT_TRUE(flow->trace(curves, options, {}));
        std::vector<Vec3> ends;
        for (const Curve& curve : curves)
            ends.push_back(curve.last.position);
        if (threads == 1) {
            expected = position;
            expected_ends = ends;
        }
        EXPECT_EQ(position, expected);
        EXPECT_EQ(ends, expected_ends);
    }
}

TEST(CellFlow, WhatAParticleIsToldDoesNotDependOnThoseBeforeIt) {
    const auto flow = meshed_flow(refined(10, wavy), {0.0, 1.0}, [](const Vec3& p, double t) {
        return Vec3(0.2 + 0.3 * std::sin(5.0 * p.y + t), 0.3 * std::cos(7.0 * p.x - t), 0.1);
    });
    // Neighbours in a row, as on a surface, and among them places on faces, at nodes and outside.
    std::vector<Vec3> start;
    for (int i = 0; i < 400; ++i) {
        Vec3 p(0.02 + 0.0024 * i, 0.3 + 0.1 * std::sin(0.05 * i), 0.4);
        if (i % 9 == 4)
            p = wavy(glm::round(10.0 * p) / 10.0);
        if (i % 31 == 7)
            p.y = -0.2;
        start.push_back(p);
    }
    const auto carried = [&](std::vector<Vec3> position) {
        std::vector<Vec3> s(position.size(), Vec3(1, 0, 0)), t(position.size(), Vec3(0, 1, 0));
        std::vector<double> time(position.size(), 0.0);
        std::vector<CurveEnd> end(position.size(), CurveEnd::Running);
        AdvanceOptions advance;
        advance.step = 0.02;
        EXPECT_TRUE(flow->advance({position, s, t, time, end}, 0.1, advance, {}));
        std::vector<Vec3> velocity(position.size());
        EXPECT_TRUE(flow->sample(position, time, velocity, {}));
        for (const auto* more : {&s, &t, &velocity})
            position.insert(position.end(), more->begin(), more->end());
        return position;
    };
    const std::vector<Vec3> together = carried(start);
    for (std::size_t i = 0; i < start.size(); ++i) {
        const std::vector<Vec3> alone = carried({start[i]});
        for (std::size_t part = 0; part < alone.size(); ++part)
            ASSERT_EQ(alone[part], together[part * start.size() + i]) << i << " " << part;
    }
}

TEST(CellFlow, WhereToLookFirstDoesNotChangeWhereParticlesGo) {
    const auto swirl = [](const Vec3& p, double t) {
        return Vec3(0.2 + 0.3 * std::sin(5.0 * p.y + t), 0.3 * std::cos(7.0 * p.x - t), 0.1);
    };
    for (const CellMesh& mesh : {block({9, 8, 7}, wavy), refined(8, wavy)}) {
        const auto flow = meshed_flow(mesh, {0.0, 0.1, 0.3}, swirl);
        const auto count = static_cast<std::uint32_t>(mesh.cells.size());
        const std::vector<Vec3> start = curve_seeds(300);
        std::vector<std::vector<Vec3>> ways;
        for (const int guess : {0, 1, 2}) {
            std::vector<Vec3> position = start, s(300, Vec3(1, 0, 0)), t(300, Vec3(0, 1, 0)), way;
            std::vector<double> time(300, 0.0);
            std::vector<CurveEnd> end(300, CurveEnd::Running);
            std::vector<std::uint32_t> cell(guess == 0 ? 0 : 300);
            std::vector<Vec3f> velocity(300);
            for (const double to : {0.05, 0.2, 0.25}) {
                if (guess == 2) // or else where the step before has left them
                    for (std::uint32_t i = 0; i < 300; ++i)
                        cell[i] = i % 7 == 0 ? 0xffffffffu : i * 37 % (count + 2);
                ASSERT_TRUE(
                    flow->advance({position, s, t, time, end, {}, {}, cell}, to, advance(), {}));
                ASSERT_TRUE(flow->sample_at(position, to, velocity, {}, false, cell));
                for (const auto* more : {&position, &s, &t})
                    way.insert(way.end(), more->begin(), more->end());
                way.insert(way.end(), velocity.begin(), velocity.end());
            }
            ways.push_back(way);
        }
        EXPECT_EQ(ways[1], ways[0]);
        EXPECT_EQ(ways[2], ways[0]);
    }
}

TEST(CellFlow, AMovingSurfaceThatIsRestoredGoesOnAsOneThatWasNeverLeft) {
    const auto flow = meshed_flow(refined(10, wavy), {0.0, 1.0, 2.0}, [](const Vec3& p, double) {
        return Vec3(0.5 - p.y, p.x - 0.5, 0.05);
    });
    SurfaceParameters p{.kind = SurfaceKind::Streak, .to = 2.0, .separation = 0.05};
    const Rake rake{Rake::Kind::Line, {{0.6, 0.5, 0.4}, {0.9, 0.5, 0.4}}, 16};
    const SteadyClock clock;
    auto surface = MovingSurface::start(plan_surface(*flow, rake, p).value(), {}, clock);
    ASSERT_TRUE(surface) << surface.error().message;
    ASSERT_TRUE(surface->advance_to(1.2, {}));
    const MovingState left = surface->state();
    ASSERT_TRUE(surface->advance_to(2.0, {}));
    const KeyedMesh never_left = surface->mesh();
    surface->restore(left);
    ASSERT_TRUE(surface->advance_to(2.0, {}));
    EXPECT_EQ(surface->mesh().mesh.position, never_left.mesh.position);
    EXPECT_GT(never_left.mesh.position.size(), 150u);
}

TEST(CellFlow, TheVerticesOfABalancedSurfaceLieWhereItsParticlesGoThroughCellsOfAllSizes) {
    const auto flow = meshed_flow(refined(8, wavy), {0.0, 1.0, 2.0}, [](const Vec3& p, double t) {
        return Vec3(0.3 + 0.2 * std::sin(6.0 * p.y + t), 0.25 * std::cos(5.0 * p.x - t),
                    0.1 * std::sin(4.0 * p.x));
    });
    const Rake rake{Rake::Kind::Line, {{0.1, 0.3, 0.5}, {0.1, 0.7, 0.5}}, 8};
    SurfaceParameters p{.kind = SurfaceKind::Streak, .to = 1.5, .separation = 0.05};
    const SteadyClock clock;
    auto surface = MovingSurface::start(plan_surface(*flow, rake, p).value(), {}, clock);
    ASSERT_TRUE(surface);
    ASSERT_TRUE(surface->advance_to(p.to, {}));
    const MaterialVertices& v = surface->state().mesh.vertices;
    std::vector<Vec3> there, exact;
    std::vector<double> time;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (v.role[i] == VertexRole::Free && v.end[i] == CurveEnd::Running && !v.approximated[i]) {
            there.push_back(v.position[i]);
            exact.push_back(glm::mix(rake.points[0], rake.points[1], v.s[i]));
            time.push_back(v.t[i]);
        }
    ASSERT_GT(there.size(), 50u);
    std::vector<CurveEnd> end(exact.size(), CurveEnd::Running);
    AdvanceOptions options{.method = AdvanceOptions::Method::Dopri5,
                           .tolerance = 1e-9,
                           .longest_step = flow->finest_spacing()};
    ASSERT_TRUE(flow->advance({exact, {}, {}, time, end}, p.to, options, {}));
    for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_LT(glm::length(there[i] - exact[i]), 2e-5) << i;
}

TEST(CellFlow, AParticleThatMeetsAGapEndsThereLikeAtTheDomainsEnd) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto flow =
        meshed_flow(block({20, 4, 4}, [](const Vec3& u) { return u; }), {0.0, 1.0, 2.0},
                    [&](const Vec3& p, double) { return p.x > 0.62 ? Vec3(nan) : Vec3(1, 0, 0); });
    std::vector<Vec3> position{{0.11, 0.4, 0.4}}, none;
    std::vector<double> time{0.0};
    std::vector<CurveEnd> end{CurveEnd::Running};
    AdvanceOptions advance;
    advance.step = 0.3;
    ASSERT_TRUE(flow->advance({position, none, none, time, end}, 2.0, advance, {}));
    EXPECT_EQ(end[0], CurveEnd::Domain);
    EXPECT_NEAR(position[0].x, 0.6, 1e-7);
}

TEST(CellFlow, SamplesTheContinuationOutsideAndTheFieldInside) {
    const auto flow = meshed_flow(block({6, 6, 6}, wavy), {0.0, 2.0},
                                  [](const Vec3& p, double t) { return (1.0 + t) * p; });
    const std::vector<Vec3> positions{{0.25, 0.5, 0.75}, {1.1, 0.5, 0.5}};
    const std::vector<double> times{0.5, 0.5};
    std::vector<Vec3> velocities(2);
    ASSERT_TRUE(flow->sample(positions, times, velocities, {}));
    EXPECT_LT(glm::length(velocities[0] - 1.5 * positions[0]), 1e-6);
    EXPECT_LT(glm::length(velocities[1] - 1.5 * Vec3(1.0, 0.5, 0.5)), 0.1);
    EXPECT_FALSE(flow->obstacle());
    EXPECT_EQ(flow->status({0.5, 0.5, 0.5}), PointStatus::Inside);
    EXPECT_EQ(flow->status({0.5, 1.5, 0.5}), PointStatus::OutsideDomain);
}

} // namespace wakesurf::core::cell_flow_test
