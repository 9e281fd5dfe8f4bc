#include "core/surface/moving/clipping.hpp"
#include "tests/support/flat_patch.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace wakesurf::core::clipping_test {

namespace {

using namespace tests;

/// Whether a triangle is left that is alone at a vertex inside a patch which is stretched along x, the smallest of its angles there.
bool keeps_tooth(double stretched) {
    MovingMesh mesh = flat_patch(8, 8);
    for (VertexId v = 0; v < mesh.vertices.slots(); ++v) {
        mesh.vertices.position[v].x *= stretched;
        mesh.vertices.along_s[v] *= stretched;
    }
    constexpr VertexId tip = 4 * 9 + 4;
    std::vector<TriangleId> fan;
    mesh.triangles.fan(tip, fan);
    const auto cosine = [&](TriangleId t) {
        const unsigned k = mesh.triangles[t].edge_from(tip);
        return cosine_between(mesh.edge(tip, mesh.triangles[t].end(k)),
                              mesh.edge(tip, mesh.triangles[t].opposite(k)), -1.0);
    };
    const TriangleId tooth = *std::max_element(
        fan.begin(), fan.end(), [&](TriangleId a, TriangleId b) { return cosine(a) < cosine(b); });
    for (const TriangleId t : fan)
        if (t != tooth)
            mesh.triangles.remove(t);
    std::vector<TriangleId> all(mesh.triangles.slots().size());
    std::iota(all.begin(), all.end(), 0u);
    RefinementRules rules;
    rules.separation = 2.0 * stretched;
    const auto flow = *make_analytic_flow("uniform");
    erode({mesh, *flow, rules}, all);
    return mesh.triangles[tooth].live;
}

} // namespace

TEST(Clipping, TakesSharpTeethOffATornBorderAndLeavesBluntOnes) {
    EXPECT_TRUE(keeps_tooth(1.0));  // 45 degrees
    EXPECT_FALSE(keeps_tooth(3.0)); // 18 degrees
}

} // namespace wakesurf::core::clipping_test
