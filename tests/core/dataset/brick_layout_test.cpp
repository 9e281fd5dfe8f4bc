#include "core/dataset/brick_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace wakesurf::core::brick_layout_test {

TEST(BrickLayout, CoversEveryCellOnceAndSharesTheNodesBetweenBricks) {
    for (const std::uint32_t nodes : {2u, 3u, 8u, 9u, 10u, 16u, 17u, 18u}) {
        const BrickLayout layout({nodes, 3, 17}, 8);
        EXPECT_EQ(layout.bricks()[0], (nodes - 1 + 7) / 8) << nodes;
        EXPECT_EQ(layout.brick_nodes(), (std::array<std::uint32_t, 3>{std::min(nodes, 9u), 3, 9}));
        for (std::size_t x = 0; x + 1 < nodes; ++x)
            for (std::size_t z = 0; z < 16; ++z) {
                const auto brick = layout.brick_of({x, 1, z});
                ASSERT_LT(brick, layout.count());
                const auto first = layout.first_node(brick);
                EXPECT_LE(first[0], x);
                EXPECT_LE(x + 1, first[0] + layout.brick_nodes()[0] - 1);
                EXPECT_EQ(first[1], 0u);
                EXPECT_EQ(first[2], z / 8 * 8);
            }
    }
}

TEST(BrickLayout, OrdersBricksSoThatNeighboursAreNearEachOther) {
    EXPECT_EQ(BrickLayout({65, 65, 65}, 32).morton_order(),
              (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(BrickLayout({129, 65, 2}, 32).morton_order(),
              (std::vector<std::uint32_t>{0, 1, 4, 5, 2, 3, 6, 7}));
}

TEST(BrickLayout, HasEachBrickOnceInThatOrder) {
    auto order = BrickLayout({100, 37, 61}, 8).morton_order();
    std::vector<std::uint32_t> all(order.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_NE(order, all);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
}

TEST(BrickLayout, HoldsGridsBeyondAnyMemory) {
    const BrickLayout layout({4096, 4096, 4096});
    EXPECT_EQ(layout.count(), std::size_t{128} * 128 * 128);
    EXPECT_EQ(layout.nodes_per_brick(), std::size_t{33} * 33 * 33);
    EXPECT_EQ(layout.first_node(layout.brick_of({4094, 4094, 4094})),
              (std::array<std::size_t, 3>{4064, 4064, 4064}));
}

TEST(BrickLayout, RefusesWhatIsNoGridInBricks) {
    EXPECT_THROW(BrickLayout({4, 4, 4}, 24), std::invalid_argument);
    EXPECT_THROW(BrickLayout({4, 4, 1}, 8), std::invalid_argument);
}

} // namespace wakesurf::core::brick_layout_test
