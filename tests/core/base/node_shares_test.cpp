// Shares of nodes on every kind of grid: what scalar fields are sampled with is what the velocity is sampled with.
#include "core/field/stored_flow.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::core::node_shares_test {
namespace {

using wakesurf::tests::SampledSource;

Vec3 bent(const Vec3& x, double) {
    return {x.y * x.z, std::sin(3.0 * x.x), x.x * x.x - x.z};
}

// The velocity's own components, put together by shares.
Vec3 by_shares(const NodeShares& shares, const SampledSource& source) {
    Vec3 sum(0.0);
    for (std::size_t i = 0; i < shares.count; ++i)
        sum += shares.share[i] * Vec3(Vec3f(bent(source.position(shares.node[i]), 0.0)));
    return sum;
}

void expect_velocity_by_shares(Grid grid) {
    const auto source = std::make_shared<SampledSource>(std::move(grid), std::vector{0.0}, bent);
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const Box box = flow->domain();
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = part(random), y = part(random), z = part(random);
        const std::vector<Vec3> p{box.lo + box.extent() * Vec3(x, y, z)};
        const NodeShares shares = flow->shares(p[0]);
        EXPECT_EQ(shares.status, flow->status(p[0]));
        if (shares.status != PointStatus::Inside) {
            EXPECT_EQ(shares.count, 0u);
            continue;
        }
        ++inside;
        double sum = 0.0;
        for (std::size_t k = 0; k < shares.count; ++k)
            sum += shares.share[k];
        EXPECT_NEAR(sum, 1.0, 1e-12);
        const std::vector<double> time{0.0};
        std::vector<Vec3> velocity(1);
        ASSERT_TRUE(flow->sample(p, time, velocity, {}).has_value());
        EXPECT_NEAR(glm::length(velocity[0] - by_shares(shares, *source)), 0.0, 1e-12);
    }
    EXPECT_GT(inside, 200); // a tetrahedron is a sixth of its box
}

TEST(NodeShares, GiveTheVelocityOnUniformGrids) {
    expect_velocity_by_shares(UniformGrid{{-1, 0, 2}, {0.5, 0.25, 1.0}, {5, 6, 4}});
}

TEST(NodeShares, GiveTheVelocityInCellsOfEveryShape) {
    for (CellMesh& cell : tests::single_cells())
        expect_velocity_by_shares(std::move(cell));
}

TEST(NodeShares, GiveTheVelocityOnMeshes) {
    expect_velocity_by_shares(tests::block({6, 5, 4}, tests::wavy));
}

} // namespace
} // namespace wakesurf::core::node_shares_test
