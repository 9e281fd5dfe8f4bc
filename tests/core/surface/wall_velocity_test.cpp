// The flow along a wall: against potential flow past a cylinder and a sphere, above a floor that holds the fluid, and round solid nodes.
#include "core/field/analytic_flow.hpp"
#include "core/surface/obstacle_surface.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace wakesurf::core::wall_velocity_test {

using namespace tests;

namespace {

QuadComplex wall_of(const Flow& flow, double time = 0.0) {
    QuadComplex wall = wall_surface(flow.walls());
    EXPECT_TRUE(add_wall_velocity(wall, flow, time, {}));
    return wall;
}

Vec3 along(const Vec3& velocity, const Vec3& normal) {
    return velocity - glm::dot(velocity, normal) * normal;
}

/// Degrees.
double between(const Vec3& a, const Vec3& b) {
    const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

/// A floor of two triangles over 0..1 at height z.
QuadComplex floor_at(double z) {
    QuadComplex floor;
    floor.position = {{0.2, 0.2, z}, {0.8, 0.2, z}, {0.8, 0.8, z}, {0.2, 0.8, z}};
    floor.cells = {{{0, 1, 2, 2}, Cell{}.mid}, {{0, 2, 3, 3}, Cell{}.mid}};
    return floor;
}

/// Fluid that a floor at z = 0 holds, over hexahedra.
std::unique_ptr<Flow> held_by_floor(std::vector<double> times, MeshedSource::Velocity velocity) {
    CellMesh mesh = block({6, 6, 6}, [](const Vec3& u) { return u; });
    mark_walls(mesh, [](const Vec3& centre) { return centre.z < 1e-9; });
    return meshed_flow(std::move(mesh), std::move(times), std::move(velocity));
}

constexpr std::uint32_t n = 24;

/// A ball of solid nodes; the velocity of the others is what it is without it.
struct SolidBall {
    explicit SolidBall(bool rectilinear, const Vec3& velocity) {
        const UniformGrid uniform{Vec3(-1.0), Vec3(2.0 / (n - 1)), {n, n, n}};
        std::vector<double> axis;
        for (std::uint32_t i = 0; i < n; ++i)
            axis.push_back(-1.0 + 2.0 * i / (n - 1));
        const Grid grid = rectilinear ? Grid(RectilinearGrid{{axis, axis, axis}}) : Grid(uniform);
        SolidMask mask;
        for (std::uint32_t i = 0; i < n * n * n; ++i) {
            const Vec3 at(axis[i % n], axis[i / n % n], axis[i / (n * n)]);
            mask.fluid.push_back(glm::length(at) < 0.5 ? 0 : 1);
        }
        wall = obstacle_surface(grid, mask);
        fluid = mask.fluid;
        flow = make_stored_flow(std::make_shared<TimeStepCache>(
            std::make_shared<SampledSource>(
                grid, std::vector{0.0}, [velocity](const Vec3&, double) { return velocity; }, mask),
            TimeStepCache::Options{}));
    }

    QuadComplex wall;
    std::vector<std::uint8_t> fluid; ///< by nodes
    std::unique_ptr<Flow> flow;
};

} // namespace

TEST(WallVelocity, OnASphereHasTheDirectionOfPotentialFlow) {
    const auto flow = make_analytic_flow("sphere").value();
    const QuadComplex wall = wall_of(*flow);
    ASSERT_GT(wall.vertices(), 1000u);
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < wall.vertices(); ++i) {
        const Vec3 normal = wall.position[i] / glm::length(wall.position[i]);
        // On the wall the velocity is 3/2 of the far one's part along it.
        const Vec3 exact = 1.5 * along(Vec3(1, 0, 0), normal);
        if (glm::length(exact) < 0.05)
            continue; // where it stands still
        ++looked_at;
        const Vec3 found = along(Vec3(wall.velocity[i]), normal);
        EXPECT_LT(between(found, exact), 1.0) << i;
        EXPECT_NEAR(glm::length(found) / glm::length(exact), 1.0, 0.1) << i;
    }
    EXPECT_GT(looked_at, wall.vertices() * 9 / 10);
}

TEST(WallVelocity, OnACylinderThatEndsAtTheDomainsBorderHasTheDirectionOfPotentialFlow) {
    const auto flow = make_analytic_flow("cylinder").value();
    const QuadComplex wall = wall_of(*flow);
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < wall.vertices(); ++i) {
        const Vec3 p = wall.position[i];
        const double radius = std::hypot(p.x, p.y);
        if (radius < 0.4) { // within a face of the domain there is no fluid
            EXPECT_EQ(wall.velocity[i], Vec3f(0.0F));
            continue;
        }
        ++looked_at;
        const Vec3 normal(p.x / radius, p.y / radius, 0.0);
        const Vec3 exact = 2.0 * along(Vec3(1, 0, 0), normal) + Vec3(0, 0, 0.2);
        EXPECT_LT(between(along(Vec3(wall.velocity[i]), normal), exact), 3.0) << i;
    }
    EXPECT_EQ(looked_at, 192u);
}

TEST(WallVelocity, IsTakenOffAFloorThatHoldsTheFluidWhicheverWayItsTrianglesAreTurned) {
    const auto flow =
        held_by_floor({0.0}, [](const Vec3& p, double) { return p.z * Vec3(1.0, 2.0, 0.0); });
    QuadComplex turned = floor_at(0.0);
    for (Cell& cell : turned.cells)
        std::swap(cell.corner[0], cell.corner[1]);
    QuadComplex mixed = floor_at(0.0);
    std::swap(mixed.cells[1].corner[0], mixed.cells[1].corner[1]);
    for (QuadComplex& wall : std::array{floor_at(0.0), turned, mixed}) {
        ASSERT_TRUE(add_wall_velocity(wall, *flow, 0.0, {}));
        for (const Vec3f& found : wall.velocity)
            EXPECT_NEAR(glm::length(Vec3(found) - Vec3(1, 2, 0) * (0.25 / 6.0)), 0.0, 1e-6);
    }
}

TEST(WallVelocity, OfAWallALittleOutsideOfTheCellsIsThatOfTheNearestFluid) {
    const auto flow =
        held_by_floor({0.0}, [](const Vec3& p, double) { return p.z * Vec3(1.0, 2.0, 0.0); });
    QuadComplex wall = floor_at(-0.6 / 6.0);
    ASSERT_TRUE(add_wall_velocity(wall, *flow, 0.0, {}));
    for (const Vec3f& found : wall.velocity)
        EXPECT_LT(between(Vec3(found), Vec3(1, 2, 0)), 1e-3);
    QuadComplex far = floor_at(-2.0);
    ASSERT_TRUE(add_wall_velocity(far, *flow, 0.0, {}));
    for (const Vec3f& found : far.velocity)
        EXPECT_EQ(found, Vec3f(0.0F));
}

TEST(WallVelocity, IsThatOfItsTimeBetweenTimeSteps) {
    const auto flow = held_by_floor(
        {0.0, 2.0}, [](const Vec3& p, double t) { return p.z * Vec3(1.0, 2.0 * t, 0.0); });
    QuadComplex wall = floor_at(0.0);
    ASSERT_TRUE(add_wall_velocity(wall, *flow, 0.5, {}));
    for (const Vec3f& found : wall.velocity)
        EXPECT_LT(between(Vec3(found), Vec3(1, 1, 0)), 1e-3);
}

TEST(WallVelocity, IsNothingWhereTheDataHaveNoValue) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto flow = held_by_floor({0.0}, [none](const Vec3& p, double) {
        return p.x < 0.4 ? Vec3(none) : p.z * Vec3(1.0, 0.0, 0.0);
    });
    QuadComplex wall = floor_at(0.0);
    ASSERT_TRUE(add_wall_velocity(wall, *flow, 0.0, {}));
    for (std::size_t i = 0; i < wall.vertices(); ++i)
        EXPECT_EQ(wall.velocity[i].x > 0.0F, wall.position[i].x > 0.5) << i;
}

TEST(WallVelocity, RoundSolidNodesHasTheDirectionOfTheFluidBesideThem) {
    const Vec3 velocity(1.0, 0.5, -0.2);
    for (const bool rectilinear : {false, true}) {
        SolidBall ball(rectilinear, velocity);
        ASSERT_GT(ball.wall.vertices(), 200u);
        ASSERT_TRUE(add_wall_velocity(ball.wall, *ball.flow, 0.0, {}));
        for (const Vec3f& found : ball.wall.velocity)
            EXPECT_LT(between(Vec3(found), velocity), 1e-3);
    }
}

TEST(WallVelocity, PlacesAWholeSpacingOffSolidNodesHaveTheirValuesFromTheFluid) {
    for (const bool rectilinear : {false, true}) {
        const SolidBall ball(rectilinear, {1, 0, 0});
        const auto places = places_off_wall(ball.wall, *ball.flow, mask_distances, {});
        ASSERT_TRUE(places);
        double most = 0.0;
        std::size_t some = 0;
        for (const Vec3& place : *places) {
            const NodeShares shares = ball.flow->shares(place);
            ASSERT_EQ(shares.status, PointStatus::Inside);
            double solid = 0.0;
            for (std::size_t i = 0; i < shares.count; ++i)
                solid += ball.fluid[shares.node[i]] == 0 ? shares.share[i] : 0.0;
            most = std::max(most, solid);
            some += solid > 1e-9 ? 1 : 0;
        }
        EXPECT_LT(some, places->size() / 10); // in corners that face in
        EXPECT_LT(most, 0.05);
    }
}

TEST(WallVelocity, EndsWhenItIsStopped) {
    const auto flow = make_analytic_flow("sphere").value();
    QuadComplex wall = wall_surface(flow->walls());
    std::stop_source stop;
    stop.request_stop();
    const auto ended = add_wall_velocity(wall, *flow, 0.0, stop.get_token());
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::wall_velocity_test
