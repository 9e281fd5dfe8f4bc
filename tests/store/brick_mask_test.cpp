#include "store/brick_mask.hpp"
#include "tests/support/brick_store.hpp"
#include "tests/support/mask_bytes.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

namespace wakesurf::store::brick_mask_test {

namespace {

using namespace core;

using namespace tests;

/// Three bricks of 4 cells in a row: the first solid, the second mixed, the last fluid.
StoreValues three_bricks() {
    StoreValues what{UniformGrid{{0, 0, 0}, {1, 1, 1}, {13, 5, 5}}, Precision::Single, {}, {}};
    for (std::size_t node = 0; node < 13 * 25; ++node)
        what.fluid.push_back(node % 13 > 4 ? 1 : 0);
    what.values.push_back({std::vector<float>(3 * 13 * 25)});
    return what;
}

std::string open_message(const StoreLayout& layout) {
    const auto opened = open_layout(layout);
    return opened ? "it was opened" : opened.error().message;
}

} // namespace

TEST(BrickMask, HasTheNodesOfMixedBricksOnly) {
    const TemporaryFolder folder;
    const auto layout = write_store(folder / "store", three_bricks(), 4);
    const std::string file = read_file(folder / "store/mask.u8");
    ASSERT_EQ(file.size(), 3u + 125u);
    EXPECT_EQ(file.substr(0, 3), std::string("\0\2\1", 3));
    EXPECT_EQ(file.substr(3, 10), std::string("\0\1\1\1\1\0\1\1\1\1", 10));
    const auto reader = open_bricks(layout);
    const SolidMask& mask = reader->mask();
    EXPECT_EQ(mask_bytes(mask, 13 * 25), three_bricks().fluid);
    EXPECT_EQ(mask.bricks->only_value(0), 0);
    EXPECT_EQ(mask.bricks->only_value(1), std::nullopt);
    EXPECT_EQ(mask.bricks->only_value(2), 1);
}

TEST(BrickMask, TakesTheMemoryOfTheBricksThatWallsGoThrough) {
    const TemporaryFolder folder;
    StoreValues what{UniformGrid{{0, 0, 0}, {1, 1, 1}, {65, 65, 65}}, Precision::Single, {}, {}};
    const std::size_t nodes = std::size_t{65} * 65 * 65;
    what.fluid.assign(nodes, 1);
    what.fluid[nodes / 2 + 3] = 0;
    what.values.push_back({std::vector<float>(3 * nodes)});
    const auto reader = open_bricks(write_store(folder / "store", what, 4));
    const SolidMask& mask = reader->mask();
    EXPECT_EQ(mask_bytes(mask, nodes), what.fluid);
    EXPECT_LT(mask.bytes(), nodes / 4);
}

TEST(BrickMask, IsRefusedWhereItIsNotOneOfTheGrid) {
    const TemporaryFolder folder;
    auto layout = write_store(folder / "store", three_bricks(), 4);
    const std::string name(mask_file_name);
    const std::string good = read_file(folder / "store" / name);
    const auto refusal = [&](const std::string& bytes) {
        put_fixed(layout, name, bytes);
        return open_message(layout);
    };
    EXPECT_EQ(refusal(good), "it was opened");
    EXPECT_EQ(refusal(good.substr(0, 2)), "mask.u8 has fewer bytes than the grid has bricks");
    EXPECT_EQ(refusal(good.substr(0, 127)), "mask.u8 has 127 bytes instead of 128");
    EXPECT_EQ(refusal(good + good), "mask.u8 has 256 bytes instead of 128");
    EXPECT_EQ(refusal(good + std::string(1000, '\0')),
              "mask.u8 has more bytes than all of the grid's bricks");
    EXPECT_EQ(refusal("\3" + good.substr(1)),
              "mask.u8 holds bricks that are neither solid, fluid nor mixed");
    EXPECT_EQ(refusal(good.substr(0, 127) + "\2"), "mask.u8 holds values other than 0 and 1");
    put_fixed(layout, name, good);
    flip_bit(folder / "store" / name, 300);
    EXPECT_NE(open_message(layout), "it was opened") << "its checksum differs";
    std::filesystem::remove(folder / "store" / name);
    EXPECT_NE(open_message(layout), "it was opened");
}

} // namespace wakesurf::store::brick_mask_test
