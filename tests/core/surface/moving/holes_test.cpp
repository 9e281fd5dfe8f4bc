#include "core/surface/moving/holes.hpp"
#include "tests/support/flat_patch.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::holes_test {

namespace {

using namespace tests;

/// A patch of 8 x 8 cells without those round a vertex in its middle.
MovingMesh torn_patch(bool closed) {
    MovingMesh mesh = flat_patch(8, 8, closed);
    std::vector<TriangleId> round;
    mesh.triangles.fan(4 * (closed ? 8 : 9) + 4, round);
    for (const TriangleId t : round)
        mesh.triangles.remove(t);
    return mesh;
}

std::size_t close(MovingMesh& mesh, double separation, const char* flow = "uniform") {
    RefinementRules rules;
    rules.separation = separation;
    rules.obstacle = std::string_view(flow) != "uniform";
    return close_holes({mesh, **make_analytic_flow(flow), rules});
}

} // namespace

TEST(Holes, AreClosedByTrianglesThatFaceTheRightWay) {
    for (const bool closed : {false, true}) {
        MovingMesh mesh = torn_patch(closed);
        const std::size_t before = mesh.triangles.live();
        EXPECT_EQ(close(mesh, 3.0), 4u);
        EXPECT_EQ(mesh.triangles.live(), before + 4);
        EXPECT_EQ(mesh.triangles.violation(), "");
        if (!closed) {
            EXPECT_DOUBLE_EQ(area(mesh), 64.0);
        }
        EXPECT_EQ(close(mesh, 3.0), 0u); // the outer borders stay
    }
}

TEST(Holes, StayWhereEdgesAcrossThemWouldBeLongerThanTheSeparation) {
    MovingMesh mesh = torn_patch(false);
    EXPECT_EQ(close(mesh, 1.0), 0u);
    EXPECT_DOUBLE_EQ(area(mesh), 61.0);
}

TEST(Holes, StayWhereABodyIsInThem) {
    MovingMesh mesh = torn_patch(false);
    for (Vec3& position : mesh.vertices.position)
        position -= Vec3(4.0, 4.0, 0.0); // the body is in its middle
    EXPECT_EQ(close(mesh, 3.0, "cylinder"), 0u);
}

} // namespace wakesurf::core::holes_test
