#include "protocol/wire/slice_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace wakesurf::protocol::slice_file_test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

core::SliceRaster raster_of(std::size_t columns, std::vector<float> values) {
    core::SliceRaster raster;
    raster.window = {{1, 2, 3}, {0, 4, 0}, {0, 0, 5}};
    raster.columns = columns;
    raster.rows = values.size() / columns;
    raster.values = std::move(values);
    for (const float value : raster.values) {
        if (!std::isfinite(value))
            continue;
        const auto [lo, hi] = raster.range.value_or(std::array{value, value});
        raster.range = {std::min(lo, value), std::max(hi, value)};
        ++raster.in_flow;
    }
    return raster;
}

SliceFile there_and_back(const core::SliceRaster& raster, double time = 0.0) {
    const std::string bytes = slice_file(raster, time);
    return read_slice_file(std::as_bytes(std::span(bytes))).value();
}

} // namespace

TEST(SliceFile, ComesBackToHalfAStepOfItsRangeWithItsGaps) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-3.0F, 40.0F);
    std::vector<float> values(60);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = i % 7 == 0 ? nan : number(random);
    const auto raster = raster_of(12, values);
    const auto back = there_and_back(raster, 2.5);
    EXPECT_EQ(back.time, 2.5);
    EXPECT_EQ(back.raster.columns, 12u);
    EXPECT_EQ(back.raster.rows, 5u);
    EXPECT_EQ(back.raster.in_flow, raster.in_flow);
    EXPECT_EQ(back.raster.range, raster.range);
    EXPECT_EQ(back.raster.window.corner, raster.window.corner);
    EXPECT_EQ(back.raster.window.across, raster.window.across);
    EXPECT_EQ(back.raster.window.up, raster.window.up);
    const double step = ((*raster.range)[1] - (*raster.range)[0]) / slice_codes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_EQ(std::isnan(back.raster.values[i]), std::isnan(values[i])) << i;
        if (!std::isnan(values[i])) {
            EXPECT_NEAR(back.raster.values[i], values[i], 0.51 * step) << i;
        }
    }
}

TEST(SliceFile, OfOneValueOrNoneComesBack) {
    const auto same = there_and_back(raster_of(2, {7.0F, 7.0F, nan, 7.0F}));
    EXPECT_EQ(same.raster.values[3], 7.0F);
    const auto none = there_and_back(raster_of(2, {nan, nan}));
    EXPECT_FALSE(none.raster.range);
    EXPECT_TRUE(std::isnan(none.raster.values[0]));
}

TEST(SliceFile, ThatIsCutOrOfAnotherKindIsRefused) {
    const std::string good = slice_file(raster_of(2, {1.0F, 2.0F}), 0.0);
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(read_slice_file(std::as_bytes(std::span(good.data(), size)))) << size;
    for (const std::size_t at : {0u, 3u, 4u, 8u, 103u}) { // the last is the sign of lo: above hi
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ (at == 103 ? 0x40 : 0x01));
        EXPECT_FALSE(read_slice_file(std::as_bytes(std::span(bad)))) << at;
    }
}

} // namespace wakesurf::protocol::slice_file_test
