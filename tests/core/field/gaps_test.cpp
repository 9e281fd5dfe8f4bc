// Nodes without a velocity: there the domain ends, at that time.
#include "core/field/advance_stored.hpp"
#include "core/field/stored_flow.hpp"
#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/swarm.hpp"
#include "tests/support/value_of.hpp"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace wakesurf::core::gaps_test {
namespace {

using namespace tests;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

const UniformGrid uniform{{0, 0, 0}, {0.1, 0.1, 0.1}, {31, 21, 21}};

RectilinearGrid rectilinear() {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < uniform.dimensions[axis]; ++i)
            grid.coordinates[axis].push_back(0.1 * i + 0.02 * std::sin(i));
    for (auto& along : grid.coordinates)
        along.front() = 0.0;
    return grid;
}

std::unique_ptr<Flow>
flow_on(const Grid& grid, SampledSource::Velocity velocity, Simd simd = Simd::Best) {
    return make_stored_flow(
        std::make_shared<TimeStepCache>(
            std::make_shared<SampledSource>(grid, std::vector<double>{0.0, 1.0, 2.0, 3.0},
                                            std::move(velocity)),
            TimeStepCache::Options{}),
        std::make_shared<SteadyClock>(), simd);
}

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * t;
    return 0.15 * Vec3(a * std::sin(3.0 * p.z) + std::cos(3.0 * p.y),
                       1.4 * std::sin(3.0 * p.x) + a * std::cos(3.0 * p.z),
                       std::sin(3.0 * p.y) + 1.4 * std::cos(3.0 * p.x));
}

/// A third of a percent of the nodes, others at each time, are holes of every kind.
Vec3 swirling_with_holes(const Vec3& p, double t) {
    const double noise = std::abs(std::sin(p.x * 1291.7 + p.y * 7817.3 + p.z * 3571.9 + t * 17.0));
    const Vec3 v = swirling(p, t);
    if (noise < 0.0025)
        return {nan, nan, nan};
    if (noise < 0.0035)
        return {v.x, infinite, v.z};
    return noise < 0.005 ? Vec3(v.x, v.y, -infinite) : v;
}

/// A step that leaves the domain is cut along its chord, which bulges by less than a tenth of a cell.
double beyond(const Box& box, const Vec3& p) {
    return glm::length(p - glm::clamp(p, box.lo, box.hi));
}

struct Way {
    const char* name;
    AdvanceOptions options;
};

std::vector<Way> ways() {
    using Method = AdvanceOptions::Method;
    return {{"rk4", {.method = Method::Rk4, .step = 0.03}},
            {"dopri5", {.method = Method::Dopri5, .tolerance = 1e-7, .longest_step = 0.1}},
            {"smooth", {.method = Method::Rk4, .step = 0.03, .smooth = true}}};
}

TEST(Gaps, AParticleEndsAtTheFaceOfTheFirstCellWithoutVelocity) {
    // The last nodes with a velocity are those below 1.45.
    const auto blowing = [](const Vec3& p, double) {
        return p.x > 1.45 ? Vec3(nan) : Vec3(1.0, 0.1, 0.05);
    };
    for (const Grid& grid : {Grid(uniform), Grid(rectilinear())}) {
        const auto* stretched = std::get_if<RectilinearGrid>(&grid);
        const double wall = stretched ? stretched->coordinates[0][14] : 1.4;
        const auto flow = flow_on(grid, blowing);
        for (const bool smooth : {false, true})
            for (const bool frozen : {false, true}) {
                std::vector<Curve> curve(1);
                curve[0].seed = {0.5, 1.0, 1.0};
                curve[0].duration = 2.5;
                ASSERT_TRUE(flow->trace(
                    curve,
                    {.frozen = frozen, .tolerance = 1e-8, .longest_step = 0.05, .smooth = smooth},
                    {}));
                EXPECT_EQ(curve[0].end, CurveEnd::Domain);
                EXPECT_NEAR(curve[0].last.position.x, wall, 1e-6);
                EXPECT_NEAR(curve[0].last.position.y, 1.0 + 0.1 * (wall - 0.5), 1e-6);
                EXPECT_NEAR(curve[0].last.time, wall - 0.5, 1e-6);
            }
        for (const Way& way : ways()) {
            PlainSwarm swarm({{0.5, 1.0, 1.0}}, 0.0);
            ASSERT_TRUE(flow->advance(swarm.particles(), 2.5, way.options, {}));
            EXPECT_EQ(swarm.end[0], CurveEnd::Domain) << way.name;
            EXPECT_NEAR(swarm.position[0].x, wall, 1e-6) << way.name;
            EXPECT_NEAR(swarm.time[0], wall - 0.5, 1e-6) << way.name;
        }
    }
}

TEST(Gaps, AGapThatAppearsEndsWhatIsInItWhenItsIntervalBegins) {
    const auto closing = [](const Vec3& p, double t) {
        return t > 1.5 && p.x > 0.95 ? Vec3(nan) : Vec3(0.1, 0.0, 0.0);
    };
    for (const Grid& grid : {Grid(uniform), Grid(rectilinear())}) {
        const auto flow = flow_on(grid, closing);
        const std::vector<Vec3> seeds{{1.5, 1.0, 1.0}, {0.3, 1.0, 1.0}};
        std::vector<Curve> curves(2);
        for (std::size_t i = 0; i < 2; ++i) {
            curves[i].seed = seeds[i];
            curves[i].duration = 2.5;
        }
        ASSERT_TRUE(flow->trace(curves, {.tolerance = 1e-8, .longest_step = 0.05}, {}));
        EXPECT_EQ(curves[0].end, CurveEnd::Domain);
        EXPECT_NEAR(curves[0].last.time, 1.0, 1e-9);
        EXPECT_NEAR(curves[0].last.position.x, 1.6, 1e-6);
        EXPECT_EQ(curves[1].end, CurveEnd::Time) << "it does not get there";
        for (const Way& way : ways()) {
            PlainSwarm swarm(seeds, 0.0);
            ASSERT_TRUE(flow->advance(swarm.particles(), 2.5, way.options, {}));
            EXPECT_EQ(swarm.end[0], CurveEnd::Domain) << way.name;
            EXPECT_NEAR(swarm.time[0], 1.0, 1e-9) << way.name;
            EXPECT_EQ(swarm.end[1], CurveEnd::Running) << way.name;
        }
    }
}

TEST(Gaps, NoParticleEverGetsAPositionThatIsNoNumber) {
    for (const Grid& grid : {Grid(uniform), Grid(rectilinear())}) {
        const auto flow = flow_on(grid, swirling_with_holes);
        const auto whole = flow_on(grid, swirling);
        const auto points = random_points(bounds(grid), 2000, 21);
        for (const Way& way : ways())
            for (const double to : {2.9, 0.1}) {
                PlainSwarm swarm(points, 3.0 - to);
                ASSERT_TRUE(flow->advance(swarm.particles(), to, way.options, {}));
                PlainSwarm unbroken(points, 3.0 - to);
                ASSERT_TRUE(whole->advance(unbroken.particles(), to, way.options, {}));
                std::size_t stopped = 0;
                for (std::size_t i = 0; i < points.size(); ++i) {
                    ASSERT_TRUE(finite(swarm.position[i])) << way.name << i;
                    ASSERT_LT(beyond(bounds(grid), swarm.position[i]), 0.01) << way.name << i;
                    ASSERT_NE(swarm.end[i], CurveEnd::Stagnation) << way.name << i;
                    stopped +=
                        swarm.end[i] == CurveEnd::Domain && unbroken.end[i] == CurveEnd::Running;
                }
                EXPECT_GT(stopped, 100u) << way.name << " meets holes";
            }
        for (const bool smooth : {false, true}) {
            std::vector<Curve> curves(400);
            for (std::size_t i = 0; i < curves.size(); ++i) {
                curves[i].seed = points[i];
                curves[i].duration = 2.9;
                curves[i].seed_tangent = {1, 0, 0};
            }
            ASSERT_TRUE(flow->trace(
                curves, {.tolerance = 1e-5, .longest_step = 0.1, .stretch = true, .smooth = smooth},
                {}));
            for (const Curve& curve : curves) {
                ASSERT_TRUE(finite(curve.last.position));
                ASSERT_TRUE(finite(curve.last.stretch));
                ASSERT_LT(beyond(bounds(grid), curve.last.position), 1e-6);
                ASSERT_NE(curve.end, CurveEnd::Stagnation);
            }
        }
        std::vector<Vec3> velocity(points.size());
        const std::vector<double> times(points.size(), 1.4);
        for (const bool smooth : {false, true}) {
            ASSERT_TRUE(flow->sample(points, times, velocity, {}, smooth));
            for (const Vec3& v : velocity)
                ASSERT_TRUE(finite(v));
        }
    }
}

TEST(Gaps, BothKernelsGiveTheSameBits) {
    const auto best = flow_on(uniform, swirling_with_holes, Simd::Best);
    const auto portable = flow_on(uniform, swirling_with_holes, Simd::Portable);
    const auto points = random_points(uniform.bounds(), 3000, 22);
    PlainSwarm a(points, 0.0);
    PlainSwarm b(points, 0.0);
    ASSERT_TRUE(best->advance(a.particles(), 2.9, ways()[0].options, {}));
    ASSERT_TRUE(portable->advance(b.particles(), 2.9, ways()[0].options, {}));
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(a.end[i], b.end[i]) << i;
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(a.position[i][axis]),
                      std::bit_cast<std::uint64_t>(b.position[i][axis]))
                << i;
    }
}

TEST(Gaps, AFieldWithoutAnyVelocityEndsEverythingAtOnce) {
    for (const Grid& grid : {Grid(uniform), Grid(rectilinear())}) {
        const auto flow = flow_on(grid, [](const Vec3&, double) { return Vec3(nan); });
        const auto points = random_points(bounds(grid), 50, 23);
        for (const Way& way : ways()) {
            PlainSwarm swarm(points, 0.0);
            ASSERT_TRUE(flow->advance(swarm.particles(), 2.5, way.options, {}));
            for (std::size_t i = 0; i < points.size(); ++i) {
                EXPECT_EQ(swarm.end[i], CurveEnd::Domain) << way.name;
                EXPECT_EQ(swarm.position[i], points[i]) << way.name;
            }
        }
    }
}

TEST(Gaps, SurfacesGoRoundThem) {
    const Rake rake{Rake::Kind::Line, {{0.6, 0.4, 0.5}, {0.6, 1.6, 1.5}}, 16};
    for (const Grid& grid : {Grid(uniform), Grid(rectilinear())})
        for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
            const auto flow = flow_on(grid, swirling_with_holes);
            const auto surface = value_of(build_surface(
                *flow, rake, {.kind = kind, .from = 0.1, .to = 1.6, .separation = 0.15}));
            EXPECT_GT(surface.mesh.cells.size(), 20u);
            for (const Vec3& p : surface.mesh.position)
                ASSERT_TRUE(finite(p));
        }
}

/// 8 x 8 x 8 hexahedra, or the same cube as a grid.
std::vector<Grid> cubes() {
    RectilinearGrid graded;
    for (auto& along : graded.coordinates)
        for (int i = 0; i <= 8; ++i)
            along.push_back(i == 3 ? 0.76 : 0.25 * i);
    return {Grid(UniformGrid{{0, 0, 0}, Vec3(0.25), {9, 9, 9}}), Grid(graded),
            Grid(tests::block({8, 8, 8}, [](const Vec3& u) { return 2.0 * u; }))};
}

/// Known up to z = 1.75; from t = 2 on only up to z = 1.25.
Vec3 rising(const Vec3& p, double t) {
    return p.z > (t > 1.5 ? 1.3 : 1.8) ? Vec3(nan) : Vec3(1.0, 0.3 * p.z, 0.2);
}

TEST(Gaps, VerticesAtTheBorderHaveTheVelocityOfTheFluid) {
    const Rake rake{Rake::Kind::Line, {{0.1, 0.3, 1.57}, {0.1, 0.9, 1.71}}, 9};
    for (const Grid& grid : cubes())
        for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
            const auto flow = flow_on(grid, rising);
            const auto surface = value_of(build_surface(
                *flow, rake, {.kind = kind, .from = 0.0, .to = 0.95, .separation = 0.11}));
            const QuadComplex& mesh = surface.mesh;
            ASSERT_GT(mesh.cells.size(), 10u);
            for (std::size_t i = 0; i < mesh.vertices(); ++i)
                ASSERT_LT(
                    glm::length(Vec3(mesh.velocity[i]) - Vec3(1.0, 0.3 * mesh.position[i].z, 0.2)),
                    1e-4)
                    << int(kind) << " at z " << mesh.position[i].z << " of grid " << grid.index();
        }
}

TEST(Gaps, AreMarkedAtTheTimesAtWhichTheyAre) {
    const std::vector<Vec3> points{{1, 1, 1}, {1, 1, 1.25}, {1, 1, 1.4}, {1, 1, 1.75}, {1, 1, 1.9}};
    const auto marked = [&](const Grid& grid, double time) {
        std::vector<std::uint8_t> gap(points.size());
        const auto flow = flow_on(grid, rising);
        EXPECT_TRUE(flow->mark_gaps(points, std::vector(points.size(), time), gap, {}));
        return gap;
    };
    using Gap = std::vector<std::uint8_t>;
    for (const Grid& grid : cubes()) {
        // The border itself has a velocity. Between two times both count, at a stored time that one alone.
        EXPECT_EQ(marked(grid, 0.5), (Gap{0, 0, 0, 0, 1})) << grid.index();
        EXPECT_EQ(marked(grid, 1.0), (Gap{0, 0, 0, 0, 1})) << grid.index();
        EXPECT_EQ(marked(grid, 1.1), (Gap{0, 0, 1, 1, 1})) << grid.index();
        EXPECT_EQ(marked(grid, 3.0), (Gap{0, 0, 1, 1, 1})) << grid.index();
    }
}

TEST(Gaps, AVelocityAtAStoredTimeIsThatOfItsTimeStepAlone) {
    const std::vector<Vec3> points{{1, 1, 1.6}, {1, 1, 0.5}};
    const std::vector<double> times{1.0, 1.5};
    for (const Grid& grid : cubes()) {
        std::vector<Vec3> velocity(2);
        ASSERT_TRUE(flow_on(grid, rising)->sample(points, times, velocity, {}));
        EXPECT_LT(glm::length(velocity[0] - Vec3(1.0, 0.48, 0.2)), 1e-6) << grid.index();
    }
}

TEST(Gaps, VorticityBesideThemIsMadeOfTheFluidAlone) {
    const std::vector<Vec3> points{{1, 1, 1.7}, {1, 1, 1.0}, {1, 1, 1.9}};
    for (const Grid& grid : cubes()) {
        const auto found = value_of(sample_gradient_fields(std::vector{GradientField::Vorticity},
                                                           *flow_on(grid, rising), points,
                                                           std::vector(3, 0.0), {}));
        EXPECT_NEAR(found[0][0], 0.3, 1e-4) << grid.index();
        EXPECT_NEAR(found[0][1], 0.3, 1e-4) << grid.index();
        EXPECT_TRUE(std::isnan(found[0][2])) << grid.index();
    }
}

} // namespace
} // namespace wakesurf::core::gaps_test
