// The patches that are chosen of a boundary: each with its own triangles, wherever they stand in the list.
#include "server/data/obstacle_mesh.hpp"
#include "tests/support/patched_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::server::obstacle_mesh_test {

namespace {

using core::BoundaryPatch;
using core::Vec3;
using Kind = BoundaryPatch::Kind;

LoadedDataset data() {
    LoadedDataset out;
    out.flow = std::make_shared<tests::PatchedFlow>();
    out.info.velocity = "U";
    return out;
}

Obstacle chosen(const PatchChoice& choice) {
    auto found = obstacle_of(data(), choice);
    EXPECT_TRUE(found) << found.error().message;
    return found ? *std::move(found) : Obstacle{};
}

/// The corners of all cells, sorted.
std::vector<std::vector<double>> corners(const Obstacle& obstacle) {
    std::set<std::vector<double>> out;
    for (const core::Cell& cell : obstacle.mesh.cells)
        for (const core::VertexId corner : cell.corner) {
            const Vec3& p = obstacle.mesh.position[corner];
            out.insert({p.x, p.y, p.z});
        }
    return {out.begin(), out.end()};
}

using Of = PatchChoice::Of;

} // namespace

TEST(ObstacleMesh, IsTheBodyAloneUnlessOtherPatchesAreChosen) {
    const Obstacle body = chosen({});
    EXPECT_EQ(body.mesh.cells.size(), 2u);
    EXPECT_EQ(body.mesh.vertices(), 4u);
    EXPECT_EQ(body.patches, (std::vector<BoundaryPatch>{{"hull", Kind::Wall, 2}}));
    const Obstacle all = chosen({Of::All, {}});
    EXPECT_EQ(all.mesh.cells.size(), 5u);
    EXPECT_EQ(all.patches.size(), 3u);
}

TEST(ObstacleMesh, HasTheTrianglesOfThePatchesThatAreNamedInTheOrderOfTheData) {
    const Obstacle inlet = chosen({Of::Named, {"inlet"}});
    EXPECT_EQ(corners(inlet),
              (std::vector<std::vector<double>>{{-1, 0, 0}, {-1, 0, 1}, {-1, 1, 0}}));
    const Obstacle two = chosen({Of::Named, {"floor", "hull"}});
    EXPECT_EQ(two.patches,
              (std::vector<BoundaryPatch>{{"hull", Kind::Wall, 2}, {"floor", Kind::Side, 2}}));
    EXPECT_EQ(two.mesh.cells.size(), 4u);
    EXPECT_EQ(corners(two).size(), 8u);
    const auto none = obstacle_of(data(), {Of::Named, {"outlet"}});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "there is no patch outlet");
    EXPECT_EQ(none.error().hint, "they are hull, inlet, floor");
}

TEST(ObstacleMesh, HasTheSpeedAndEachComponentOfTheVelocityBesideIt) {
    const Obstacle body = chosen({});
    const auto at = [&](const char* field) {
        const auto found = values_beside(data(), body, 0.0, field, {});
        EXPECT_TRUE(found) << found.error().message;
        return found ? found->front() : 0.0F;
    };
    EXPECT_FLOAT_EQ(at("U"), 5.0F);
    EXPECT_FLOAT_EQ(at("velocity_x"), 3.0F);
    EXPECT_FLOAT_EQ(at("velocity_y"), 4.0F);
}

} // namespace wakesurf::server::obstacle_mesh_test
