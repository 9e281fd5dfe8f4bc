#include "core/field/cell_mask.hpp"
#include "tests/support/mask_bytes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::core::cell_mask_test {

namespace {

using Nodes = std::array<std::uint32_t, 3>;

/// Solid boxes, which may reach beyond the grid; some grids have none, some no fluid.
SolidMask random_boxes(const Nodes& n, std::mt19937& random) {
    const auto below = [&](std::uint32_t end) {
        return static_cast<std::uint32_t>(random() % end);
    };
    SolidMask mask;
    mask.fluid.assign(std::size_t{n[0]} * n[1] * n[2], 1);
    for (std::uint32_t box = below(4); box > 0; --box) {
        std::array<std::uint32_t, 3> low, high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = below(n[axis]);
            high[axis] = low[axis] + 1 + below(n[axis]);
        }
        std::size_t node = 0;
        for (std::uint32_t z = 0; z < n[2]; ++z)
            for (std::uint32_t y = 0; y < n[1]; ++y)
                for (std::uint32_t x = 0; x < n[0]; ++x, ++node)
                    if (x >= low[0] && x < high[0] && y >= low[1] && y < high[1] && z >= low[2] &&
                        z < high[2])
                        mask.fluid[node] = 0;
    }
    return mask;
}

} // namespace

TEST(CellMask, InBricksSaysOfEachCellWhatItSaysInOnePiece) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const Nodes n{2 + static_cast<std::uint32_t>(random() % 20),
                      2 + static_cast<std::uint32_t>(random() % 12),
                      2 + static_cast<std::uint32_t>(random() % 9)};
        const SolidMask whole = random_boxes(n, random);
        const SolidMask bricks =
            tests::mask_in_bricks(whole, BrickLayout(n, std::uint32_t{1} << random() % 5));
        ASSERT_EQ(tests::mask_bytes(bricks, whole.fluid.size()), whole.fluid);
        const CellMask cells(n, whole);
        const CellMask cells_in_bricks(n, bricks);
        const CellMask near = CellMask::round_cells(n, whole);
        const CellMask near_in_bricks = CellMask::round_cells(n, bricks);
        for (std::size_t z = 0; z + 1 < n[2]; ++z)
            for (std::size_t y = 0; y + 1 < n[1]; ++y)
                for (std::size_t x = 0; x + 1 < n[0]; ++x) {
                    const std::size_t node = x + n[0] * (y + n[1] * z);
                    ASSERT_EQ(cells_in_bricks.state({x, y, z}, node), cells.state({x, y, z}, node))
                        << "round " << round << ": " << x << " " << y << " " << z;
                    ASSERT_EQ(near_in_bricks.state({x, y, z}, node), near.state({x, y, z}, node))
                        << "round " << round << ": " << x << " " << y << " " << z;
                }
    }
}

TEST(CellMask, InBricksTakesTheMemoryOfTheBricksThatWallsGoThrough) {
    const Nodes n{65, 65, 65};
    SolidMask whole;
    whole.fluid.assign(std::size_t{n[0]} * n[1] * n[2], 1);
    whole.fluid[32 + 65 * (32 + 65 * 32)] = 0; // the node where eight bricks meet
    const SolidMask bricks = tests::mask_in_bricks(whole, BrickLayout(n, 4));
    const std::size_t pointers = 4096 * sizeof(void*);
    EXPECT_EQ(bricks.bytes(), pointers + 125 * (8 + 2));
    EXPECT_EQ(CellMask(n, bricks).bricks()->bytes(), pointers + 125 * (8 + 1));
    EXPECT_EQ(CellMask::round_cells(n, bricks).bricks()->bytes(), pointers + 125 * (8 + 1));
}

TEST(CellMask, HasNothingWhereThereIsNoObstacle) {
    const CellMask none({3, 3, 3}, {});
    EXPECT_EQ(none.state({1, 1, 1}, 13), CellMask::Fluid);
    EXPECT_EQ(none.whole(), nullptr);
    EXPECT_EQ(none.bricks(), nullptr);
}

} // namespace wakesurf::core::cell_mask_test
