#include "core/field/analytic_flow.hpp"
#include "core/field/generated_bricks.hpp"
#include "core/field/sample_grid.hpp"
#include "tests/support/mask_bytes.hpp"
#include "tests/support/read_bricks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace wakesurf::core::generated_bricks_test {

namespace {

using tests::outcomes_of;

UniformGrid grid_over(std::string_view flow, std::array<std::uint32_t, 3> dimensions) {
    UniformGrid grid;
    const auto domain = (*make_analytic_flow(flow))->domain();
    grid.dimensions = dimensions;
    grid.origin = domain.lo;
    grid.spacing = domain.extent() / Vec3(dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1);
    return grid;
}

} // namespace

TEST(GeneratedBricks, HoldTheNodesOfTheWholeGridToTheBit) {
    for (const std::string_view flow : {"abc", "tornado", "cylinder"}) {
        const auto grid = grid_over(flow, {19, 9, 7});
        const auto made = GeneratedBricks::make(flow, grid, {0.5, 1.5}, 8, 2);
        ASSERT_TRUE(made) << flow;
        const auto& layout = (*made)->layout();
        std::vector<float> whole(3 * grid.nodes());
        ASSERT_TRUE(sample_nodes(**make_analytic_flow(flow), grid, 0, 1.5, std::span(whole), {}));
        std::vector<std::vector<float>> bricks(layout.count(),
                                               std::vector<float>(3 * layout.nodes_per_brick()));
        std::vector<BrickRead> reads;
        for (std::size_t brick = 0; brick < bricks.size(); ++brick)
            reads.push_back({1, brick, bricks[brick]});
        for (const auto& outcome : outcomes_of(**made, reads))
            ASSERT_TRUE(outcome) << outcome.error().message;
        std::vector<std::uint8_t> fluid(grid.nodes());
        sample_mask(**make_analytic_flow(flow), grid, 0, fluid);
        const SolidMask& mask = (*made)->mask();
        EXPECT_EQ(mask.empty(), flow != "cylinder");
        EXPECT_TRUE(mask.empty() || tests::mask_bytes(mask, grid.nodes()) == fluid) << flow;
        const auto nodes = layout.brick_nodes();
        for (std::size_t brick = 0; brick < bricks.size(); ++brick) {
            const auto first = layout.first_node(brick);
            for (std::size_t node = 0; node < layout.nodes_per_brick(); ++node) {
                const std::array<std::size_t, 3> in{node % nodes[0], node / nodes[0] % nodes[1],
                                                    node / nodes[0] / nodes[1]};
                std::size_t flat = 0;
                for (const std::size_t axis : {2u, 1u, 0u})
                    flat = flat * grid.dimensions[axis] +
                           std::min<std::size_t>(first[axis] + in[axis], grid.dimensions[axis] - 1);
                ASSERT_EQ(
                    0, std::memcmp(&bricks[brick][3 * node], &whole[3 * flat], 3 * sizeof(float)))
                    << flow << " brick " << brick << " node " << node;
            }
        }
    }
}

TEST(GeneratedBricks, AreOfGridsThatNoMemoryHolds) {
    const auto grid = grid_over("tornado", {4096, 4096, 4096});
    const auto made = GeneratedBricks::make("tornado", grid, {0.0, 1.0});
    ASSERT_TRUE(made);
    EXPECT_TRUE((*made)->mask().empty());
    EXPECT_EQ((*made)->layout().count(), 128u * 128u * 128u);
    std::vector<float> last(3 * (*made)->layout().nodes_per_brick());
    ASSERT_TRUE(outcomes_of(**made, {{1, (*made)->layout().count() - 1, last}})[0]);
    const Vec3 corner = grid.origin + grid.spacing * Vec3(4095.0);
    const double time = 1.0;
    Vec3 velocity;
    ASSERT_TRUE(
        (*make_analytic_flow("tornado"))->sample({&corner, 1}, {&time, 1}, {&velocity, 1}, {}));
    EXPECT_EQ(last.back(), static_cast<float>(velocity.z));
    EXPECT_EQ((*made)->load(0, {}).error().code, Error::Code::Unsupported);
}

TEST(GeneratedBricks, EndAsCancelledWhereTheyAreNotWantedAnyMore) {
    const auto grid = grid_over("abc", {65, 65, 65});
    const auto made = GeneratedBricks::make("abc", grid, {0.0});
    ASSERT_TRUE(made);
    std::vector<float> values(3 * (*made)->layout().nodes_per_brick());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(outcomes_of(**made, {{0, 0, values}}, stop.get_token())[0].error().code,
              Error::Code::Cancelled);
    std::size_t told = 0;
    auto doomed = *GeneratedBricks::make("abc", grid, {0.0}, 32, 1);
    doomed->read(std::vector<BrickRead>(50, {0, 7, values}), {},
                 [&](std::size_t, const Result<void>&) { ++told; });
    doomed.reset();
    EXPECT_EQ(told, 50u);
}

TEST(GeneratedBricks, RefuseWhatThereIsNot) {
    const auto made = GeneratedBricks::make("abc", grid_over("abc", {5, 5, 5}), {0.0});
    ASSERT_TRUE(made);
    std::vector<float> values(3 * (*made)->layout().nodes_per_brick());
    const auto outcomes =
        outcomes_of(**made, {{1, 0, values}, {0, 1, values}, {0, 0, values, 1}, {0, 0, {}}});
    EXPECT_EQ(outcomes[0].error().message, "there is no brick 0 of time-step 1");
    EXPECT_EQ(outcomes[1].error().message, "there is no brick 1 of time-step 0");
    EXPECT_EQ(outcomes[2].error().code, Error::Code::NotFound);
    EXPECT_EQ(outcomes[3].error().code, Error::Code::InvalidArgument);
    EXPECT_FALSE(GeneratedBricks::make("abc", grid_over("abc", {5, 5, 5}), {1.0, 1.0}));
    EXPECT_FALSE(GeneratedBricks::make("no-flow", {}, {1.0}));
}

} // namespace wakesurf::core::generated_bricks_test
