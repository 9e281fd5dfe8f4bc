// Stored data on rectilinear grids: closed forms, and the uniform grid as their twin.
#include "core/field/analytic_flow.hpp"
#include "core/field/grid_sampling.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core::rectilinear_sampling_test {
namespace {

using namespace tests;

const Box box{{-1.0, 0.0, 2.0}, {2.0, 2.5, 4.0}};

/// Finer in the middle by a factor of about 4 for `stretch` 0.6, even for 0.
RectilinearGrid stretched(const std::array<std::size_t, 3>& nodes, double stretch) {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        for (std::size_t k = 0; k < nodes[axis]; ++k) {
            const double u = static_cast<double>(k) / static_cast<double>(nodes[axis] - 1);
            const double bent = u + stretch * std::sin(2.0 * M_PI * u) / (2.0 * M_PI);
            grid.coordinates[axis].push_back(box.lo[i] + bent * box.extent()[i]);
        }
        grid.coordinates[axis].back() = box.hi[i];
    }
    return grid;
}

UniformGrid even(const std::array<std::size_t, 3>& nodes) {
    UniformGrid grid;
    grid.origin = box.lo;
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.dimensions[axis] = static_cast<std::uint32_t>(nodes[axis]);
    grid.spacing = box.extent() / Vec3(nodes[0] - 1, nodes[1] - 1, nodes[2] - 1);
    return grid;
}

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * t;
    return {a * std::sin(p.z) + std::cos(p.y), 1.4 * std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + 1.4 * std::cos(p.x)};
}

/// Trilinear everywhere: what is between nodes is known however they lie.
Vec3 trilinear(const Vec3& p, double t) {
    return {1.0 + p.x * p.y * p.z + t, p.x * p.y - 2.0 * p.z, 3.0 + p.y * p.z - p.x * (1.0 + t)};
}

Vec3 trilinear_slope(const Vec3& p, double t, const Vec3& w) {
    return {p.y * p.z * w.x + p.x * p.z * w.y + p.x * p.y * w.z, p.y * w.x + p.x * w.y - 2.0 * w.z,
            p.z * w.y + p.y * w.z - (1.0 + t) * w.x};
}

SolidMask ball(const Grid& grid) {
    SolidMask mask;
    const SampledSource where(grid, {0.0}, swirling);
    for (std::size_t node = 0; node < node_count(grid); ++node)
        mask.fluid.push_back(glm::length(where.position(node) - Vec3(0.5, 1.2, 3.0)) > 0.45);
    return mask;
}

std::unique_ptr<Flow>
flow_on(const Grid& grid, SampledSource::Velocity velocity = swirling, SolidMask mask = {}) {
    auto source = std::make_shared<SampledSource>(grid, std::vector<double>{0.0, 0.7, 1.1, 2.0},
                                                  std::move(velocity), std::move(mask));
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}));
}

std::vector<Curve> curves_from(const std::vector<Vec3>& seeds, double duration) {
    std::vector<Curve> curves(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        curves[i].seed = seeds[i];
        curves[i].release = duration < 0.0 ? 1.9 : 0.1;
        curves[i].duration = duration;
    }
    return curves;
}

TEST(RectilinearSampling, GivesAFieldThatIsTrilinearEverywhereExactly) {
    const RectilinearGrid grid = stretched({17, 12, 9}, 0.6);
    const SampledSource source(grid, {0.5, 1.5}, trilinear);
    const auto first = source.load(0, {}).value();
    const auto second = source.load(1, {}).value();
    const RectilinearAxes axes(grid);
    const SolidMask none;
    const CellMask cells(axes.dimensions(), none);
    const auto field = linear_sampler(axes, cells, none, {nullptr, first, second, nullptr});
    const Vec3 w(0.3, -0.7, 0.5);
    for (const Vec3& p : random_points(box, 2000, 5)) {
        EXPECT_LT(glm::length(field.velocity(p, 0.8) - trilinear(p, 0.8)), 3e-6);
        EXPECT_LT(glm::length(field.derivative(p, 0.8, w) - trilinear_slope(p, 0.8, w)), 2e-4)
            << "floats over a cell of 0.03";
    }
    EXPECT_EQ(field.status(box.hi), PointStatus::Inside);
    EXPECT_EQ(field.status(box.hi + Vec3(1e-9, 0, 0)), PointStatus::OutsideDomain);
    EXPECT_EQ(field.status(Vec3(std::nan(""))), PointStatus::OutsideDomain);
}

TEST(RectilinearSampling, ErrorsFallWithTheSquareOfTheSpacing) {
    const auto points = random_points(box, 3000, 8);
    const auto error = [&](std::size_t nodes) {
        const auto flow = flow_on(stretched({nodes, nodes, nodes}, 0.6));
        std::vector<Vec3> velocity(points.size());
        const std::vector<double> times(points.size(), 0.7);
        EXPECT_TRUE(flow->sample(points, times, velocity, {}));
        double worst = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            worst = std::max(worst, glm::length(velocity[i] - swirling(points[i], 0.7)));
        return worst;
    };
    EXPECT_NEAR(std::log2(error(13) / error(25)), 2.0, 0.2);
}

TEST(RectilinearSampling, EvenlySpacedNodesCarryParticlesAsTheUniformGridDoes) {
    const std::array<std::size_t, 3> nodes{31, 26, 21};
    for (const bool obstacle : {false, true}) {
        const Grid uniform = even(nodes);
        const auto mask = obstacle ? ball(uniform) : SolidMask{};
        const auto one = flow_on(uniform, swirling, mask);
        const auto two = flow_on(stretched(nodes, 0.0), swirling, mask);
        EXPECT_NEAR(one->finest_spacing(), two->finest_spacing(), 1e-12);
        EXPECT_EQ(one->obstacle(), two->obstacle());
        const auto points = random_points(box, 400, 7);
        for (const Vec3& p : points)
            EXPECT_EQ(one->status(p), two->status(p));
        for (const bool frozen : {false, true}) {
            auto a = curves_from(points, 1.5);
            auto b = a;
            const TraceOptions options{.frozen = frozen, .tolerance = 1e-9, .longest_step = 0.05};
            ASSERT_TRUE(one->trace(a, options, {}));
            ASSERT_TRUE(two->trace(b, options, {}));
            for (std::size_t i = 0; i < a.size(); ++i) {
                EXPECT_EQ(a[i].end, b[i].end) << i;
                EXPECT_LT(glm::length(a[i].last.position - b[i].last.position), 1e-6) << i;
            }
        }
        for (const auto method : {AdvanceOptions::Method::Rk4, AdvanceOptions::Method::Dopri5}) {
            PlainSwarm a(points, 0.1);
            PlainSwarm b = a;
            const AdvanceOptions options{
                .method = method, .step = 0.02, .tolerance = 1e-9, .longest_step = 0.05};
            ASSERT_TRUE(one->advance(a.particles(), 1.6, options, {}));
            ASSERT_TRUE(two->advance(b.particles(), 1.6, options, {}));
            for (std::size_t i = 0; i < points.size(); ++i) {
                EXPECT_EQ(a.end[i], b.end[i]) << i;
                // The uniform grid's RK4 samples in float.
                EXPECT_LT(glm::length(a.position[i] - b.position[i]), 2e-5) << i;
            }
        }
    }
}

TEST(RectilinearSampling, CurvesEqualTinyRungeKuttaStepsThroughTheSameData) {
    for (const Grid& grid : {Grid(stretched({31, 26, 21}, 0.6)), Grid(even({31, 26, 21}))})
        for (const double duration : {+1.5, -1.5})
            for (const bool frozen : {false, true}) { // between two stored times
                const auto flow = flow_on(grid);
                auto exact = curves_from(random_points(box, 60, 9), duration);
                auto tiny = exact;
                TraceOptions options{.frozen = frozen, .tolerance = 1e-9, .longest_step = 0.05};
                ASSERT_TRUE(flow->trace(exact, options, {}));
                options.method = TraceOptions::Method::Rk4;
                options.step = 2e-4;
                ASSERT_TRUE(flow->trace(tiny, options, {}));
                for (std::size_t i = 0; i < exact.size(); ++i) {
                    EXPECT_EQ(exact[i].end, tiny[i].end);
                    EXPECT_LT(glm::length(exact[i].last.position - tiny[i].last.position), 2e-7)
                        << i;
                }
            }
}

TEST(RectilinearSampling, ParticlesEndAtTheWallOfAnObstacle) {
    const RectilinearGrid grid = stretched({31, 26, 21}, 0.6);
    const auto mask = ball(grid);
    const auto flow = flow_on(
        grid, [](const Vec3&, double) { return Vec3(1, 0, 0); }, mask);
    auto curves = curves_from({{-0.9, 1.2, 3.0}, {-0.9, 0.2, 3.0}}, 1.8);
    ASSERT_TRUE(flow->trace(curves, {.tolerance = 1e-9, .longest_step = 0.02}, {}));
    EXPECT_EQ(curves[0].end, CurveEnd::Obstacle);
    EXPECT_NEAR(curves[0].last.position.x, 0.5 - 0.45, 0.1) << "within a cell of the ball";
    EXPECT_EQ(flow->status(curves[0].last.position), PointStatus::Inside);
    EXPECT_EQ(flow->status(curves[0].last.position + Vec3(1e-6, 0, 0)), PointStatus::InObstacle);
    EXPECT_EQ(curves[1].end, CurveEnd::Time);
}

TEST(RectilinearSampling, SurfacesOfEveryKindAreBuiltOnIt) {
    const RectilinearGrid grid = stretched({31, 26, 21}, 0.6);
    const auto flow = flow_on(grid, swirling, ball(grid));
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const Rake rake{Rake::Kind::Line, {{0.5, 0.3, 2.2}, {0.5, 0.6, 2.8}}, 16};
        SurfaceParameters parameters{.kind = kind, .to = 0.3, .separation = 0.04};
        if (kind == SurfaceKind::Time)
            parameters.sweep = Vec3(0.3, 0.0, 0.0);
        const auto surface = build_surface(*flow, rake, parameters);
        ASSERT_TRUE(surface.has_value()) << surface.error().message;
        EXPECT_GT(surface->mesh.cells.size(), 50u);
        for (const Vec3& p : surface->mesh.position)
            EXPECT_TRUE(finite(p));
    }
}

} // namespace
} // namespace wakesurf::core::rectilinear_sampling_test
