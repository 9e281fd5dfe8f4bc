#include "core/field/analytic_flow.hpp"
#include "core/field/sample_grid.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <bit>
#include <cmath>

namespace wakesurf::core::sample_grid_test {

namespace {

/// Over the flow's domain, more nodes than one task takes.
UniformGrid grid_over(const Flow& flow) {
    return {.origin = flow.domain().lo,
            .spacing = flow.domain().extent() / Vec3(32, 16, 20),
            .dimensions = {33, 17, 21}};
}

std::vector<float>
sampled(const Flow& flow, const UniformGrid& grid, double time, std::size_t piece) {
    std::vector<float> all(3 * grid.nodes());
    for (std::size_t first = 0; first < grid.nodes(); first += piece) {
        const auto count = std::min(piece, grid.nodes() - first);
        EXPECT_TRUE(sample_nodes(flow, grid, first, time,
                                 std::span(all).subspan(3 * first, 3 * count), {}));
    }
    return all;
}

} // namespace

TEST(SampleGrid, GivesWhatTheFlowGivesRoundedToFloat) {
    for (const std::string& name : analytic_flow_names()) {
        const auto flow = *make_analytic_flow(name);
        const auto grid = grid_over(*flow);
        const double time = 1.3;
        const auto all = sampled(*flow, grid, time, grid.nodes());
        std::size_t node = 0;
        for (std::uint32_t k = 0; k < grid.dimensions[2]; ++k)
            for (std::uint32_t j = 0; j < grid.dimensions[1]; ++j)
                for (std::uint32_t i = 0; i < grid.dimensions[0]; ++i, ++node) {
                    const Vec3 p = grid.origin + grid.spacing * Vec3(i, j, k);
                    Vec3 v;
                    ASSERT_TRUE(flow->sample({&p, 1}, {&time, 1}, {&v, 1}, {}));
                    if (flow->status(p) == PointStatus::InObstacle)
                        v = Vec3(0.0);
                    for (int axis = 0; axis < 3; ++axis)
                        ASSERT_EQ(std::bit_cast<std::uint32_t>(all[3 * node + std::size_t(axis)]),
                                  std::bit_cast<std::uint32_t>(static_cast<float>(v[axis])))
                            << name << " node " << node;
                }
    }
}

TEST(SampleGrid, DoesNotDependOnPiecesOrThreads) {
    const auto flow = *make_analytic_flow("abc");
    const auto grid = grid_over(*flow);
    const auto whole = sampled(*flow, grid, 0.0, grid.nodes());
    EXPECT_EQ(sampled(*flow, grid, 0.0, 1000), whole);
    for (const int threads : {1, 3}) {
        tbb::task_arena arena(threads);
        arena.execute([&] { EXPECT_EQ(sampled(*flow, grid, 0.0, 5000), whole) << threads; });
    }
}

TEST(SampleGrid, MarksTheNodesInsideTheObstacleAndStopsTheFlowThere) {
    const auto flow = *make_analytic_flow("sphere?a=2");
    const auto grid = grid_over(*flow);
    std::vector<std::uint8_t> fluid(grid.nodes());
    sample_mask(*flow, grid, 0, fluid);
    const auto all = sampled(*flow, grid, 0.0, grid.nodes());
    std::size_t solid = 0;
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        const bool inside = glm::length(node_position(grid, node)) < 2.0;
        ASSERT_EQ(fluid[node], inside ? 0 : 1) << node;
        solid += inside;
        if (inside) {
            ASSERT_EQ(all[3 * node], 0.0F);
        }
    }
    EXPECT_GT(solid, 100U);
}

TEST(SampleGrid, TellsTheRangeOfTheSpeedOutsideTheObstacle) {
    const auto flow = *make_analytic_flow("cylinder?u=3,w=4");
    const auto grid = grid_over(*flow);
    std::vector<float> all(3 * grid.nodes());
    const auto range = sample_nodes(*flow, grid, 0, 0.0, all, {});
    double lo = 1e300;
    double hi = 0.0;
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        if (flow->status(node_position(grid, node)) == PointStatus::InObstacle)
            continue;
        const double speed = std::hypot(all[3 * node], all[3 * node + 1], all[3 * node + 2]);
        lo = std::min(lo, speed);
        hi = std::max(hi, speed);
    }
    EXPECT_EQ((*range)[0], lo);
    EXPECT_EQ((*range)[1], hi);
    EXPECT_GT(lo, 3.9) << "the zeros inside the cylinder are no speeds";
}

TEST(SampleGrid, RefusesVelocitiesThatNoFloatHolds) {
    const auto flow = *make_analytic_flow("uniform?u=1e39");
    const auto grid = grid_over(*flow);
    std::vector<float> all(3 * grid.nodes());
    const auto range = sample_nodes(*flow, grid, 0, 0.0, all, {});
    ASSERT_FALSE(range);
    EXPECT_EQ(range.error().code, Error::Code::InvalidArgument);
}

TEST(SampleGrid, StopsWhenAsked) {
    const auto flow = *make_analytic_flow("abc");
    const auto grid = grid_over(*flow);
    std::vector<float> all(3 * grid.nodes());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(sample_nodes(*flow, grid, 0, 0.0, all, stop.get_token()).error().code,
              Error::Code::Cancelled);
}

} // namespace wakesurf::core::sample_grid_test
