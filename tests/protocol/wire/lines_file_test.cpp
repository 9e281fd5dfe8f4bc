#include "protocol/wire/lines_file.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::protocol::lines_file_test {

namespace {

core::StreamLines two_lines() {
    core::StreamLines lines;
    lines.points = {{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 2, 3}};
    lines.times = {0, 1, 0};
    lines.values = {1.5F, std::numeric_limits<float>::quiet_NaN(), -2.0F};
    lines.offsets = {0, 2, 3};
    lines.seed = {0, 4};
    lines.seeds = 6;
    lines.outside = 4;
    lines.ends = {1, 2, 3, 4, 5};
    lines.range = {-2.0F, 1.5F};
    return lines;
}

} // namespace

TEST(LinesFile, ComesBackAsItWas) {
    const core::StreamLines lines = two_lines();
    const std::string bytes = lines_file(lines, 2.5);
    EXPECT_EQ(bytes.size(), lines_file_bytes(2, 3));
    const auto back = value_of(read_lines_file(std::as_bytes(std::span(bytes))));
    EXPECT_EQ(back.time, 2.5);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(back.lines.points[i], lines.points[i]), 1e-6);
    EXPECT_EQ(back.lines.offsets, lines.offsets);
    EXPECT_EQ(back.lines.seed, lines.seed);
    EXPECT_EQ(back.lines.values[2], -2.0F);
    EXPECT_TRUE(std::isnan(back.lines.values[1]));
    EXPECT_EQ(back.lines.range, lines.range);
    EXPECT_EQ(back.lines.seeds, 6u);
    EXPECT_EQ(back.lines.outside, 4u);
    EXPECT_EQ(back.lines.ends.cut, 5u);
}

TEST(LinesFile, ThatIsCutOrOfAnotherKindIsRefused) {
    const std::string good = lines_file(two_lines(), 0.0);
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(read_lines_file(std::as_bytes(std::span(good.data(), size)))) << size;
    for (const std::size_t at : {0u, 3u, 4u, 8u, 88u, 92u, 96u}) { // the last three are offsets
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x05);
        EXPECT_FALSE(read_lines_file(std::as_bytes(std::span(bad)))) << at;
    }
}

} // namespace wakesurf::protocol::lines_file_test
