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

TEST(Holes, BesideABodyAndNearTheBorderAreOpenedToIt) {
    struct Case {
        int row;
        bool body, attached, opened;
    };

    for (const Case& each :
         {Case{1, true, false, true}, Case{2, true, false, true}, Case{8, true, false, false},
          Case{1, false, false, false}, Case{1, true, true, false}}) {
        MovingMesh mesh = flat_patch(20, 20);
        const auto there = mesh.triangles.find(static_cast<VertexId>(21 * each.row + 10),
                                               static_cast<VertexId>(21 * each.row + 11));
        ASSERT_NE(there.triangle, no_triangle);
        const Triangle half = mesh.triangles[there.triangle];
        mesh.triangles.remove(half.across[half.mate]);
        mesh.triangles.remove(there.triangle);
        for (Vec3& position : mesh.vertices.position) // the body is in the hole
            position -= Vec3(10.5, each.row + (each.body ? 0.5 : 9.0), 0.0);
        for (VertexId v = 0; each.attached && v < 21; ++v)
            mesh.vertices.role[v] = VertexRole::Attached;
        RefinementRules rules;
        rules.separation = 3.0;
        rules.obstacle = true;
        const auto flow = *make_analytic_flow("cylinder");
        const std::size_t before = mesh.triangles.live();
        const std::size_t torn = open_holes({mesh, *flow, rules});
        EXPECT_EQ(mesh.triangles.live(), before - torn);
        EXPECT_EQ(torn > 0, each.opened) << each.row;
        EXPECT_LE(torn, 4u);
        EXPECT_EQ(mesh.triangles.violation(), "");
        EXPECT_EQ(open_holes({mesh, *flow, rules}), 0u) << "what is open is no hole";
    }
}

} // namespace wakesurf::core::holes_test
