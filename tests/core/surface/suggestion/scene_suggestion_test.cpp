#include "core/field/analytic_flow.hpp"
#include "core/field/closed_forms.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/mesh_measures.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/suggested_scene.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace wakesurf::core::scene_suggestion_test {

namespace {

const SurfaceParameters& of_kind(const SceneSuggestion& scene, SurfaceKind kind) {
    return *std::ranges::find(scene.surfaces, kind, &SurfaceParameters::kind);
}

using tests::suggested, tests::times;

/// Potential flow round spheres of radius 1/2, unsteady by a little; solid inside.
struct Spheres {
    Vec3 along{1, 0, 0};
    std::vector<Vec3> centres{Vec3(0.0)};

    bool solid(const Vec3& p) const {
        return std::ranges::any_of(centres,
                                   [&](const Vec3& c) { return glm::length(p - c) < 0.5; });
    }

    Vec3 velocity(const Vec3& p, double t) const {
        Vec3 v = along * (1.0 + 0.1 * std::sin(t));
        for (const Vec3& c : centres) {
            const Vec3 r = p - c;
            const double r2 = std::max(glm::dot(r, r), 0.0625);
            const double ratio = 0.125 / (r2 * std::sqrt(r2));
            v += along * (0.5 * ratio) - r * (1.5 * ratio * glm::dot(r, along) / r2);
        }
        return v;
    }
};

std::unique_ptr<Flow>
masked(const Box& domain, double spacing, const std::vector<double>& at, const Spheres& form) {
    UniformGrid grid;
    grid.origin = domain.lo;
    for (int k = 0; k < 3; ++k) {
        grid.dimensions[static_cast<std::size_t>(k)] =
            static_cast<std::uint32_t>(std::lround(domain.extent()[k] / spacing)) + 1;
        grid.spacing[k] = spacing;
    }
    tests::SampledSource places(grid, {0.0}, nullptr);
    SolidMask mask;
    const std::size_t nodes = node_count(Grid(grid));
    for (std::size_t i = 0; i < nodes; ++i)
        mask.fluid.push_back(form.solid(places.position(i)) ? 0 : 1);
    auto source = std::make_shared<tests::SampledSource>(
        grid, at, [form](const Vec3& p, double t) { return form.velocity(p, t); }, std::move(mask));
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

/// Which part of a surface's area lies where `inside` says.
template <class Inside>
double share(const QuadComplex& mesh, const Inside& inside) {
    double all = 0.0;
    double there = 0.0;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        Vec3 centre(0.0);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            centre += mesh.position[outline.vertex[i]] / static_cast<double>(outline.count);
        double area = 0.0;
        for (std::uint32_t i = 0; i < outline.count; ++i)
            area += 0.5 * glm::length(glm::cross(
                              mesh.position[outline.vertex[i]] - centre,
                              mesh.position[outline.vertex[(i + 1) % outline.count]] - centre));
        all += area;
        there += inside(centre) ? area : 0.0;
    }
    return all > 0.0 ? there / all : 0.0;
}

Surface built(const Flow& flow, const SceneSuggestion& scene, const SurfaceParameters& parameters) {
    auto surface = build_surface(flow, scene.rake, parameters);
    EXPECT_TRUE(surface.has_value()) << (surface ? "" : surface.error().message);
    return surface.value_or(Surface{});
}

const char* name(SurfaceKind kind) {
    constexpr const char* names[] = {"stream", "path", "streak", "time"};
    return names[static_cast<std::size_t>(kind)];
}

/// @param front  along the flow
void shows_the_wake(const Flow& flow,
                    const SceneSuggestion& scene,
                    const Vec3& along,
                    double front) {
    ASSERT_EQ(scene.surfaces.size(), 4U);
    for (const SurfaceParameters& each : scene.surfaces) {
        const Surface surface = built(flow, scene, each);
        EXPECT_GE(share(surface.mesh, [&](const Vec3& p) { return glm::dot(p, along) > front; }),
                  0.5)
            << name(each.kind) << ": " << scene.why;
        EXPECT_FALSE(surface.statistics.coarsened());
        EXPECT_GE(surface.statistics.quads, 20U) << name(each.kind);
        // The time surface behind the hole in a mesh of cells has 62,050 with accuracy exact.
        EXPECT_LE(surface.statistics.quads, 70'000U) << name(each.kind);
    }
}

struct Placed {
    const char* what;
    Box domain;
    double spacing;
    std::size_t steps;
    double step;
    Spheres form;
    double front; ///< along the flow
};

void PrintTo(const Placed& each, std::ostream* out) {
    *out << each.what;
}

const Box long_x{{-4, -3, -3}, {10, 3, 3}};

class WithABody : public testing::TestWithParam<Placed> {};

TEST_P(WithABody, HalfOfEachFirstSurfaceLiesDownstreamOfTheBodysFront) {
    const Placed& placed = GetParam();
    const auto flow =
        masked(placed.domain, placed.spacing, times(placed.steps, placed.step), placed.form);
    const auto scene = suggested(*flow, {times(placed.steps, placed.step), false, 1000});
    EXPECT_TRUE(holds(scene.why, "body"));
    shows_the_wake(*flow, scene, placed.form.along, placed.front);
}

INSTANTIATE_TEST_SUITE_P(
    Cases,
    WithABody,
    testing::Values(
        Placed{"flow along x", long_x, 0.2, 25, 0.5, {}, -0.5},
        Placed{"flow along -x", {{-10, -3, -3}, {4, 3, 3}}, 0.2, 25, 0.5, {{-1, 0, 0}}, -0.5},
        Placed{"flow along y", {{-3, -4, -3}, {3, 10, 3}}, 0.2, 25, 0.5, {{0, 1, 0}}, -0.5},
        Placed{"flow along -z", {{-3, -3, -10}, {3, 3, 4}}, 0.2, 25, 0.5, {{0, 0, -1}}, -0.5},
        Placed{"aslant", long_x, 0.2, 25, 0.5, {glm::normalize(Vec3(1, 0.3, 0.1))}, -0.5},
        Placed{"a domain wider than long", {{-3, -6, -6}, {5, 6, 6}}, 0.2, 17, 0.5, {}, -0.5},
        Placed{"a body far from where the flow enters",
               {{-20, -4, -4}, {10, 4, 4}},
               0.2,
               61,
               0.5,
               {},
               -0.5},
        Placed{"a short series", long_x, 0.125, 5, 0.5, {}, -0.5},
        Placed{"a very short series", long_x, 0.125, 4, 0.25, {}, -0.5},
        Placed{"a body near where the flow enters",
               {{-0.9, -3, -3}, {10, 3, 3}},
               0.125,
               25,
               0.5,
               {},
               -0.5},
        Placed{
            "a body small in the domain", {{-20, -10, -10}, {30, 10, 10}}, 0.25, 51, 1.0, {}, -0.5},
        Placed{"two bodies, one behind the other",
               long_x,
               0.125,
               25,
               0.5,
               {{1, 0, 0}, {{0, 0, 0}, {3, 0.2, 0}}},
               -0.5},
        Placed{"two bodies beside each other",
               long_x,
               0.125,
               25,
               0.5,
               {{1, 0, 0}, {{0, -1, 0}, {0, 1, 0}}},
               -0.5},
        Placed{"a thin slice", {{-4, -3, -0.1}, {10, 3, 0.1}}, 0.1, 25, 0.5, {}, -0.5},
        Placed{"a body on the floor", {{-4, -3, 0}, {10, 3, 4}}, 0.2, 25, 0.5, {}, -0.5}));

TEST(SceneSuggestion, SplitsRoundTheSphere) {
    const auto flow = make_analytic_flow("sphere");
    const auto info = describe_analytic_flow("sphere");
    ASSERT_TRUE(flow && info);
    const auto scene = suggested(**flow, {info->times, info->steady, 0}, (*flow)->walls());
    shows_the_wake(**flow, scene, {1, 0, 0}, -0.5);
    const Vec3 across = glm::normalize(scene.rake.points[1] - scene.rake.points[0]);
    for (const SurfaceParameters& each : scene.surfaces) {
        const Surface surface = built(**flow, scene, each);
        const auto beside = [&](double sign) {
            return share(surface.mesh, [&](const Vec3& p) {
                return p.x > 0.5 && sign * glm::dot(p, across) > 0.0;
            });
        };
        EXPECT_GT(beside(1.0), 0.15) << name(each.kind);
        EXPECT_GT(beside(-1.0), 0.15) << name(each.kind);
    }
}

/// A block with a hole, whose wall is faces of its cells.
TEST(SceneSuggestion, StandsAheadOfAHoleInAMeshOfCells) {
    const Box domain{{-4, -4, -4}, {12, 4, 4}};
    const auto bend = [&](const Vec3& u) { return domain.lo + u * domain.extent(); };
    const Spheres form;
    const auto kind = [&](const Vec3& u) {
        const double r = glm::length(bend(u));
        using Kind = tests::TwoToOne::Kind;
        return r < 0.6 ? Kind::Hole : r < 2.0 ? Kind::Fine : Kind::Coarse;
    };
    const auto flow =
        tests::meshed_flow(tests::TwoToOne(24, kind, bend).take(), times(25, 0.5),
                           [&](const Vec3& p, double t) { return form.velocity(p, t); });
    const auto scene = suggested(*flow, {times(25, 0.5), false, 1000});
    EXPECT_TRUE(holds(scene.why, "body"));
    shows_the_wake(*flow, scene, {1, 0, 0}, -0.67);
}

TEST(SceneSuggestion, FindsAPlateWithoutThicknessByItsWall) {
    const auto flow = value_of(make_analytic_flow("uniform"));
    const WallGeometry plate{{{0, -1, -2}, {0, 1, -2}, {0, 1, 2}, {0, -1, 2}},
                             {{0, 1, 2}, {0, 2, 3}}};
    const auto scene = suggested(*flow, {{0.0}, true, 0}, plate);
    for (const Vec3& end : scene.rake.points) {
        EXPECT_LT(end.x, 0.0);
        EXPECT_GT(end.x, -4.0);
        EXPECT_NEAR(end.y, 0.0, 0.2);
        EXPECT_NEAR(std::abs(end.z), 3.0, 0.01);
    }
}

TEST(SceneSuggestion, TakesTheWallsOfAChannelForNoBody) {
    const auto flow = value_of(make_analytic_flow("uniform"));
    const WallGeometry floor{{{-10, -10, -10}, {10, -10, -10}, {10, 10, -10}, {-10, 10, -10}},
                             {{0, 1, 2}, {0, 2, 3}}};
    EXPECT_FALSE(holds(suggested(*flow, {{0.0}, true, 0}, floor).why, "body"));
    WallGeometry ramp = floor; // not in a side of the domain, but from end to end
    for (Vec3f& point : ramp.points)
        point.z = point.x > 0 ? -8.0F : -9.0F;
    EXPECT_FALSE(holds(suggested(*flow, {{0.0}, true, 0}, ramp).why, "body"));
}

class WithoutABody : public testing::TestWithParam<const char*> {};

TEST_P(WithoutABody, EachFirstSurfaceIsThereAndIsNotSmall) {
    const auto flow = make_analytic_flow(GetParam());
    const auto info = describe_analytic_flow(GetParam());
    ASSERT_TRUE(flow && info);
    const auto scene = suggested(**flow, {info->times, info->steady, 0}, (*flow)->walls());
    ASSERT_EQ(scene.surfaces.size(), 4U);
    const Vec3 extent = info->bounds.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    for (SurfaceParameters each : scene.surfaces) {
        if (each.kind == SurfaceKind::Streak)
            each.separation *= 3.0; // its place is what is tested, and the time of tests is short
        const Surface surface = built(**flow, scene, each);
        EXPECT_GT(tests::area(surface.mesh), 0.002 * longest * longest)
            << name(each.kind) << ": " << scene.why;
        EXPECT_LE(surface.statistics.quads, 200'000U) << name(each.kind);
    }
}

INSTANTIATE_TEST_SUITE_P(Flows,
                         WithoutABody,
                         testing::Values("tornado",
                                         "double-gyre",
                                         "abc",
                                         "lamb-oseen",
                                         "shear",
                                         "rotation",
                                         "hill",
                                         "strain",
                                         "rotating-strain",
                                         "oscillating",
                                         "uniform",
                                         "stagnation"));

/// Of a tornado, whose core winds from the floor to the top, every part is there: at all heights, and on all
/// sides of the core.
void shows_the_tornado(const Flow& flow, const SceneSuggestion& scene) {
    ASSERT_EQ(scene.surfaces.size(), 4U);
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path}) {
        const SurfaceParameters& p = of_kind(scene, kind);
        const Surface surface = built(flow, scene, p);
        for (int third = 0; third < 3; ++third)
            EXPECT_GT(share(surface.mesh, [&](const Vec3& x) { return int(3.0 * x.z) == third; }),
                      0.15)
                << name(kind) << " " << third;
        for (const double side_x : {-1.0, 1.0})
            for (const double side_y : {-1.0, 1.0})
                EXPECT_GT(
                    share(surface.mesh,
                          [&](const Vec3& x) {
                              const double core_x = 0.5 + 0.1 * std::sin(0.04 * p.to + 10.0 * x.z);
                              const double core_y = 0.5 + 0.1 * std::cos(0.03 * p.to + 3.0 * x.z);
                              return side_x * (x.x - core_x) > 0.0 && side_y * (x.y - core_y) > 0.0;
                          }),
                    0.1)
                    << name(kind);
    }
    const SurfaceParameters& streak = of_kind(scene, SurfaceKind::Streak);
    EXPECT_GE(streak.to - streak.from, 5.0) << "as long as it takes to go round once";
}

TEST(SceneSuggestion, ShowsATornadoFromItsFootToItsTop) {
    const auto flow = make_analytic_flow("tornado");
    const auto info = describe_analytic_flow("tornado");
    ASSERT_TRUE(flow && info);
    shows_the_tornado(**flow, suggested(**flow, {info->times, info->steady, 0}));

    UniformGrid grid{.spacing = Vec3(0.02, 0.02, 0.04), .dimensions = {51, 51, 26}};
    const auto at = times(48, 1.0);
    const auto stored = make_stored_flow(std::make_shared<TimeStepCache>(
        std::make_shared<tests::SampledSource>(
            grid, at, [](const Vec3& p, double t) { return TornadoFlow{}.velocity(p, t); }),
        TimeStepCache::Options{}));
    shows_the_tornado(*stored, suggested(*stored, {at, false, 800'000}));
}

TEST(SceneSuggestion, ShowsBothLobesOfTheDoubleGyre) {
    const auto flow = make_analytic_flow("double-gyre");
    const auto info = describe_analytic_flow("double-gyre");
    ASSERT_TRUE(flow && info);
    const auto scene = suggested(**flow, {info->times, info->steady, 0});
    ASSERT_EQ(scene.surfaces.size(), 4U);
    for (SurfaceParameters each : scene.surfaces) {
        if (each.kind == SurfaceKind::Streak)
            each.separation *= 3.0;
        const Surface surface = built(**flow, scene, each);
        const double left = share(surface.mesh, [](const Vec3& p) { return p.x < 1.0; });
        EXPECT_GT(left, 0.25) << name(each.kind);
        EXPECT_LT(left, 0.75) << name(each.kind);
        EXPECT_LE(surface.statistics.quads, 20'000U) << "no wall of layers: " << name(each.kind);
    }
}

TEST(SceneSuggestion, EndsAFewBodiesBehindOneInSteadyFlow) {
    const auto flow = make_analytic_flow("sphere");
    const auto info = describe_analytic_flow("sphere");
    ASSERT_TRUE(flow && info);
    const auto scene = suggested(**flow, {info->times, info->steady, 0}, (*flow)->walls());
    const Surface surface = built(**flow, scene, scene.surfaces.front());
    EXPECT_LT(share(surface.mesh, [](const Vec3& p) { return p.x > 6.0; }), 0.2);
    const auto behind = [](const Vec3& p) { return p.x > 0.5 && p.x < 2.0; };
    const auto closed = [&](const Vec3& p) { return behind(p) && std::abs(p.y) < 0.25; };
    EXPECT_GT(share(surface.mesh, closed), 0.8 * share(surface.mesh, behind))
        << "the sheet has closed behind the body";
}

/// Along a flat plate: slow at the floor.
TEST(SceneSuggestion, StartsInTheSlowFlowAlongAWall) {
    const Box domain{{0, 0, 0}, {10, 2, 4}};
    UniformGrid grid{.origin = domain.lo, .spacing = {0.2, 0.05, 0.2}, .dimensions = {51, 41, 21}};
    const auto at = times(11, 1.0);
    auto source = std::make_shared<tests::SampledSource>(grid, at, [](const Vec3& p, double) {
        return Vec3(std::tanh(3.0 * p.y / (0.2 + 0.05 * p.x)), 0.0, 0.0);
    });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const auto scene = suggested(*flow, {at, false, 1000});
    for (const Vec3& end : scene.rake.points)
        EXPECT_LT(end.y, 0.4);
    EXPECT_GT(std::abs(scene.rake.points[1].z - scene.rake.points[0].z), 2.0);
}

TEST(SceneSuggestion, EndsAllSurfacesAtTheSameTimeAndInTheData) {
    const auto at = times(25, 0.5);
    const auto flow = masked(long_x, 0.25, at, {});
    const auto scene = suggested(*flow, {at, false, 1000});
    ASSERT_EQ(scene.surfaces.size(), 4U);
    for (const SurfaceParameters& each : scene.surfaces) {
        // The field of a stream surface is frozen where the others are shown.
        EXPECT_EQ(each.kind == SurfaceKind::Stream ? each.from : each.to, 12.0);
        EXPECT_GE(each.from, 0.0);
    }
}

TEST(SceneSuggestion, BeginsWithWhatMovesUnlessTheDataAreShortOrLargeOrSteady) {
    const auto first = [](std::size_t steps, bool steady, std::uint64_t bytes) {
        const auto at = times(steps, 0.5);
        return suggested(*masked(long_x, 0.25, at, {}), {at, steady, bytes}).surfaces.front().kind;
    };
    EXPECT_EQ(first(25, false, 1000), SurfaceKind::Streak);
    EXPECT_EQ(first(3, false, 1000), SurfaceKind::Stream) << "a scrap at the rake";
    EXPECT_EQ(first(25, false, std::uint64_t{1} << 30U), SurfaceKind::Stream);
    EXPECT_EQ(first(25, true, 1000), SurfaceKind::Stream);
}

TEST(SceneSuggestion, TakesOnlyTheEndOfALongSeriesOfLargeTimeSteps) {
    const auto at = times(400, 0.05);
    const auto flow = masked(long_x, 0.5, at, {});
    const auto few = suggested(*flow, {at, false, std::uint64_t{1} << 30U});
    EXPECT_EQ(of_kind(few, SurfaceKind::Streak).from, at[400 - 8]);
    const auto long_enough = suggested(*flow, {at, false, 1000});
    EXPECT_LT(of_kind(long_enough, SurfaceKind::Streak).from, 10.0);
}

TEST(SceneSuggestion, OfOneTimeStepIsOfStreamSurfacesAlone) {
    const auto flow = masked(long_x, 0.5, {3.0}, {});
    const auto scene = suggested(*flow, {{3.0}, false, 1000});
    ASSERT_EQ(scene.surfaces.size(), 1U);
    EXPECT_EQ(scene.surfaces[0].kind, SurfaceKind::Stream);
    EXPECT_EQ(scene.surfaces[0].from, 3.0);
}

TEST(SceneSuggestion, LiesInThePlaneOfASlab) {
    UniformGrid grid{.spacing = Vec3(0.1), .dimensions = {11, 11, 2}};
    auto source = std::make_shared<tests::SampledSource>(
        grid, times(3, 1.0), [](const Vec3& p, double) { return Vec3(0.5 - p.y, p.x - 0.5, 0.0); });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const SceneSuggestion scene = suggested(*flow, {times(3, 1.0), false, 1000});
    EXPECT_EQ(scene.rake.points[0].z, scene.rake.points[1].z);
    EXPECT_GT(glm::length(scene.rake.points[1] - scene.rake.points[0]), 0.2);
    for (const SurfaceParameters& surface : scene.surfaces)
        if (surface.sweep) {
            EXPECT_EQ(surface.sweep->z, 0.0);
            EXPECT_GT(glm::length(*surface.sweep), 0.1);
        }
}

TEST(SceneSuggestion, SaysThatTheFlowIsAtRest) {
    UniformGrid grid{.spacing = Vec3(0.125), .dimensions = {9, 9, 9}};
    auto source = std::make_shared<tests::SampledSource>(
        grid, times(3, 1.0), [](const Vec3&, double) { return Vec3(0.0); });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const auto unsteady = suggested(*flow, {times(3, 1.0), false, 1000});
    EXPECT_TRUE(holds(unsteady.why, "at rest"));
    for (const SurfaceParameters& each : unsteady.surfaces)
        EXPECT_LT(each.from, each.to);
}

TEST(SceneSuggestion, CostsOneTimeStep) {
    UniformGrid grid{.spacing = Vec3(0.125), .dimensions = {33, 17, 17}};
    const auto at = times(100, 0.5);
    auto source = std::make_shared<tests::SampledSource>(
        grid, at, [](const Vec3& p, double) { return Vec3(1.0 + p.y, 0.0, 0.0); });
    TimeStepCache::Options options;
    const auto flow = make_stored_flow(std::make_shared<TimeStepCache>(source, options));
    suggested(*flow, {at, false, 1000});
    EXPECT_LE(source->loads.load(), 3U); // and what the cache reads ahead
}

} // namespace

} // namespace wakesurf::core::scene_suggestion_test
