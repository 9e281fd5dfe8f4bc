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

namespace {

std::vector<std::size_t> order_of(const BrickLayout& layout) {
    std::vector<std::size_t> bricks;
    for (std::size_t place = 0; place < layout.count(); ++place)
        bricks.push_back(layout.brick_on_disk(place));
    return bricks;
}

/// The bits of the places on the three axes in turn, x in the lowest.
std::uint64_t morton_code(const BrickLayout& layout, std::size_t brick) {
    const auto first = layout.first_node(brick);
    std::uint64_t code = 0;
    for (std::size_t bit = 0; bit < 21; ++bit)
        for (std::size_t axis = 0; axis < 3; ++axis)
            code |= (first[axis] >> layout.shift() >> bit & 1) << (3 * bit + axis);
    return code;
}

} // namespace

TEST(BrickLayout, OrdersBricksSoThatNeighboursAreNearEachOther) {
    EXPECT_EQ(order_of(BrickLayout({65, 65, 65}, 32)),
              (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(order_of(BrickLayout({129, 65, 2}, 32)),
              (std::vector<std::size_t>{0, 1, 4, 5, 2, 3, 6, 7}));
}

TEST(BrickLayout, HasEachBrickOnceInTheOrderOfItsMortonCodes) {
    for (const auto& dimensions : std::vector<std::array<std::uint32_t, 3>>{
             {2, 2, 2}, {100, 37, 61}, {9, 10, 200}, {130, 2, 17}, {65, 65, 65}, {2, 2, 90}}) {
        const BrickLayout layout(dimensions, 8);
        std::vector<std::size_t> sorted(layout.count());
        std::iota(sorted.begin(), sorted.end(), std::size_t{0});
        std::ranges::sort(sorted, {}, [&](auto brick) { return morton_code(layout, brick); });
        EXPECT_EQ(order_of(layout), sorted) << dimensions[0];
        for (std::size_t place = 0; place < layout.count(); ++place)
            ASSERT_EQ(layout.place_on_disk(sorted[place]), place) << dimensions[0];
    }
}

TEST(BrickLayout, FindsThePlaceOfABrickAmongThousandsOfMillions) {
    const BrickLayout layout({40000, 40000, 40000});
    EXPECT_EQ(layout.count(), std::size_t{1250} * 1250 * 1250);
    for (std::size_t brick = 0; brick < layout.count(); brick += 19'531'259)
        ASSERT_EQ(layout.brick_on_disk(layout.place_on_disk(brick)), brick);
    EXPECT_EQ(layout.place_on_disk(layout.count() - 1), layout.count() - 1);
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
