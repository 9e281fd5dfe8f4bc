#include "core/surface/moving/pairing.hpp"
#include "tests/support/flat_patch.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::pairing_test {

namespace {

using namespace tests;

/// A strip of cells, of which the first and the last have lost their outer halves.
MovingMesh strip(int cells) {
    MovingMesh mesh = flat_patch(cells, 1);
    const auto columns = static_cast<VertexId>(cells + 1);
    for (const auto& [from, to] :
         {std::pair{VertexId{1}, columns + 1}, std::pair{2 * columns - 2, columns - 2}}) {
        const Triangle& half = mesh.triangles[mesh.triangles.find(from, to).triangle];
        mesh.triangles.remove(half.across[half.mate]);
    }
    return mesh;
}

std::size_t odd_after(MovingMesh mesh, InsertionPolicy policy) {
    RefinementRules rules;
    rules.separation = 1e9;
    rules.policy = policy;
    const std::vector<TriangleId> loose = mesh.triangles.loose();
    return pair_all({mesh, **make_analytic_flow("uniform"), rules}, loose).size();
}

} // namespace

TEST(Pairing, SearchesFartherForAnotherHalfWhereAnOddTrianglesVertexIsTraced) {
    for (const int cells : {3, 20, 60, 200})
        for (const auto policy : {InsertionPolicy::Hermite, InsertionPolicy::Exact}) {
            const int reach = policy == InsertionPolicy::Exact ? 100 : 25;
            EXPECT_EQ(odd_after(strip(cells), policy), cells < reach ? 0u : 2u) << cells;
        }
}

} // namespace wakesurf::core::pairing_test
