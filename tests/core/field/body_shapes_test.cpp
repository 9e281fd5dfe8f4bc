#include "core/field/analytic_flow.hpp"
#include "core/field/closed_forms.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <utility>

namespace wakesurf::core::body_shapes_test {
namespace {

constexpr double pi = std::numbers::pi;
const Box box{Vec3(-5), Vec3(10, 5, 5)};

/// Every side of a triangle is, in the other sense, one of its neighbour's, and no two triangles have it in the same sense.
void expect_closed(const WallGeometry& wall) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& triangle : wall.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++sides[{triangle[i], triangle[(i + 1) % 3]}];
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(sides.contains({side.second, side.first})) << "an open side";
    }
}

/// Positive where the triangles are counter-clockwise seen from outside.
double volume(const WallGeometry& wall) {
    double six = 0.0;
    for (const auto& [a, b, c] : wall.triangles)
        six +=
            glm::dot(Vec3(wall.points[a]), glm::cross(Vec3(wall.points[b]), Vec3(wall.points[c])));
    return six / 6.0;
}

double radius_of(const Vec3f& p, double z_counts) {
    return glm::length(Vec3(p.x, p.y, z_counts * p.z));
}

TEST(BodyShapes, TheSphereHasItsPointsAtItsRadiusAndItsTrianglesOutward) {
    for (const double a : {0.5, 2.0}) {
        const WallGeometry wall = sphere_wall(a, box);
        for (const Vec3f& p : wall.points)
            EXPECT_NEAR(radius_of(p, 1), a, 1e-6 * a);
        expect_closed(wall);
        for (const auto& [i, j, k] : wall.triangles) {
            const Vec3 p(wall.points[i]);
            const Vec3 q(wall.points[j]);
            const Vec3 r(wall.points[k]);
            EXPECT_GT(glm::dot(glm::cross(q - p, r - p), p + q + r), 0.0);
        }
        const double whole = 4.0 / 3.0 * pi * a * a * a;
        EXPECT_LT(volume(wall), whole);
        EXPECT_GT(volume(wall), 0.998 * whole);
    }
}

TEST(BodyShapes, TheCylinderReachesFromEndToEndOfTheDomainAndIsCappedThere) {
    const WallGeometry wall = cylinder_wall(0.5, box);
    float lowest = 0.0F;
    float highest = 0.0F;
    for (const Vec3f& p : wall.points) {
        lowest = std::min(lowest, p.z);
        highest = std::max(highest, p.z);
        if (p.x != 0.0F || p.y != 0.0F) { // the middles of the caps
            EXPECT_NEAR(radius_of(p, 0), 0.5, 1e-6);
        }
    }
    EXPECT_EQ(lowest, -5.0F);
    EXPECT_EQ(highest, 5.0F);
    expect_closed(wall);
    const double whole = pi * 0.25 * 10.0;
    EXPECT_LT(volume(wall), whole);
    EXPECT_GT(volume(wall), 0.998 * whole);
}

TEST(BodyShapes, StayInTheDomainThatCutsThemAndStayClosed) {
    for (const WallGeometry& wall : {sphere_wall(7.0, box), cylinder_wall(7.0, box)}) {
        for (const Vec3f& p : wall.points)
            EXPECT_TRUE(box.contains(Vec3(p)));
        expect_closed(wall);
        EXPECT_GT(volume(wall), 0.0);
    }
}

TEST(BodyShapes, AreThoseThatTheFlowIsSolidIn) {
    for (const char* name : {"sphere", "cylinder?a=1.5", "sphere?a=-2"}) {
        const auto flow = make_analytic_flow(name).value();
        const WallGeometry wall = flow->walls();
        ASSERT_FALSE(wall.triangles.empty()) << name;
        EXPECT_TRUE(flow->obstacle());
        EXPECT_TRUE(describe_analytic_flow(name)->obstacle);
        for (const Vec3f& p : wall.points) {
            const Vec3 across(p.x, p.y, name[0] == 's' ? p.z : 0.0F);
            if (across == Vec3(0.0))
                continue; // the middle of a cap
            EXPECT_EQ(flow->status(Vec3(p) - 1e-4 * across), PointStatus::InObstacle);
            EXPECT_NE(flow->status(Vec3(p) + 1e-4 * across), PointStatus::InObstacle);
        }
    }
    for (const char* name : {"uniform", "tornado", "sphere?a=0", "cylinder?a=0"}) {
        EXPECT_TRUE(make_analytic_flow(name).value()->walls().triangles.empty()) << name;
        EXPECT_FALSE(describe_analytic_flow(name)->obstacle) << name;
    }
}

} // namespace
} // namespace wakesurf::core::body_shapes_test
