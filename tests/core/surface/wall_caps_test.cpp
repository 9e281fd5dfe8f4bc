// Bodies that go on beyond a side of the domain: closed there, unless the fluid is behind the loop.
#include "core/field/analytic_flow.hpp"
#include "core/surface/wall_caps.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wakesurf::core::wall_caps_test {

using namespace tests;

namespace {

/// The side of a prism along z through all of a box, without its ends.
WallGeometry tube(const std::vector<std::array<double, 2>>& outline, const Box& box) {
    WallGeometry walls;
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const double z : {box.lo.z, box.hi.z})
        for (const auto& [x, y] : outline)
            walls.points.emplace_back(Vec3(x, y, z));
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        walls.triangles.push_back({i, next, n + next});
        walls.triangles.push_back({i, n + next, n + i});
    }
    return walls;
}

double area(const WallGeometry& walls, std::size_t first) {
    double sum = 0.0;
    for (std::size_t i = first; i < walls.triangles.size(); ++i) {
        const auto& [a, b, c] = walls.triangles[i];
        const auto at = [&](std::uint32_t point) { return Vec3(walls.points[point]); };
        sum += 0.5 * glm::length(glm::cross(at(b) - at(a), at(c) - at(a)));
    }
    return sum;
}

} // namespace

TEST(WallCaps, CloseARoundBodyAtBothSidesByTheAreaOfItsSection) {
    const auto flow = make_analytic_flow("cylinder").value();
    constexpr int sides = 60;
    std::vector<std::array<double, 2>> circle;
    for (int i = 0; i < sides; ++i)
        circle.push_back({0.49 * std::cos(2 * std::numbers::pi * i / sides),
                          0.49 * std::sin(2 * std::numbers::pi * i / sides)});
    WallGeometry walls = tube(circle, flow->domain());
    close_at_sides(walls, *flow);
    ASSERT_EQ(walls.triangles.size(), 2U * sides + 2U * (sides - 2U));
    EXPECT_NEAR(area(walls, 2 * sides),
                2 * 0.5 * sides * 0.49 * 0.49 * std::sin(2 * std::numbers::pi / sides), 1e-5);
    const std::size_t closed = walls.triangles.size();
    close_at_sides(walls, *flow); // has points of its own, but the same places
    EXPECT_EQ(walls.triangles.size(), closed);
}

TEST(WallCaps, CloseABodyWhoseSectionIsNotConvex) {
    const auto flow = make_analytic_flow("cylinder").value();
    WallGeometry walls =
        tube({{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.0}, {0.0, 0.0}, {0.0, 0.3}, {-0.3, 0.3}},
             flow->domain());
    close_at_sides(walls, *flow);
    EXPECT_NEAR(area(walls, 12), 2 * 0.27, 1e-6);
}

TEST(WallCaps, LeaveADuctOpenAndLoopsThatLieInNoSide) {
    const auto duct = meshed_flow(block({4, 4, 4}, [](const Vec3& u) { return u; }), {0.0},
                                  [](const Vec3&, double) { return Vec3(0, 0, 1); });
    WallGeometry walls = tube({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, duct->domain());
    close_at_sides(walls, *duct);
    EXPECT_EQ(walls.triangles.size(), 8U);
    const auto flow = make_analytic_flow("cylinder").value();
    Box inner = flow->domain();
    inner.lo.z = 0.5 * (inner.lo.z + inner.hi.z);
    inner.hi.z -= 0.01;
    walls = tube({{-0.3, -0.3}, {0.3, -0.3}, {0.0, 0.3}}, inner);
    close_at_sides(walls, *flow);
    EXPECT_EQ(walls.triangles.size(), 6U);
}

TEST(WallCaps, LeaveARingOpenRoundTheLoopInIt) {
    const auto flow = make_analytic_flow("cylinder").value();
    WallGeometry walls = tube({{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}, flow->domain());
    const WallGeometry inner = tube({{-0.1, -0.1}, {0.1, -0.1}, {0.0, 0.1}}, flow->domain());
    const auto first = static_cast<std::uint32_t>(walls.points.size());
    walls.points.insert(walls.points.end(), inner.points.begin(), inner.points.end());
    for (const auto& [a, b, c] : inner.triangles)
        walls.triangles.push_back({first + a, first + b, first + c});
    close_at_sides(walls, *flow);
    EXPECT_NEAR(area(walls, 14), 2 * 0.02, 1e-6); // the inner one alone
}

} // namespace wakesurf::core::wall_caps_test
