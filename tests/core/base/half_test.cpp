#include "core/base/half.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace wakesurf::core::half_test {
namespace {

std::vector<std::uint16_t> all_halves() {
    std::vector<std::uint16_t> halves(65536);
    std::iota(halves.begin(), halves.end(), std::uint16_t{0});
    return halves;
}

/// The definition.
double value_of(std::uint16_t half) {
    const int exponent = half >> 10 & 0x1f;
    const double mantissa = half & 0x3ff;
    const double sign = (half & 0x8000) != 0 ? -1.0 : 1.0;
    if (exponent == 0)
        return sign * std::ldexp(mantissa, -24);
    return sign * std::ldexp(1024.0 + mantissa, exponent - 25);
}

bool special(std::uint16_t half) {
    return (half & 0x7c00) == 0x7c00;
}

std::uint16_t rounded(float value) {
    std::uint16_t half = 0;
    to_half({&value, 1}, {&half, 1});
    return half;
}

TEST(Half, EveryHalfWidensToItsValueAndComesBack) {
    const auto halves = all_halves();
    std::vector<float> values(halves.size());
    from_half(halves, values);
    std::vector<std::uint16_t> back(halves.size());
    to_half(values, back);
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const bool number = !special(halves[i]);
        if (number) {
            ASSERT_EQ(values[i], value_of(halves[i])) << i;
            ASSERT_EQ(std::signbit(values[i]), (halves[i] & 0x8000) != 0) << i;
        } else if ((halves[i] & 0x3ff) == 0) {
            ASSERT_TRUE(std::isinf(values[i])) << i;
        } else {
            ASSERT_TRUE(std::isnan(values[i])) << i;
        }
        if (number || std::isinf(values[i]))
            ASSERT_EQ(back[i], halves[i]);
        else
            ASSERT_TRUE(special(back[i]) && (back[i] & 0x3ff) != 0) << i;
    }
}

TEST(Half, RoundsToTheNearestAndTiesToEven) {
    for (std::uint16_t half = 0; half < 0x7bff; ++half) { // and its neighbour above
        const double low = value_of(half);
        const double high = value_of(static_cast<std::uint16_t>(half + 1));
        const auto middle = static_cast<float>(0.5 * (low + high)); // exact: one bit more
        const auto even = static_cast<std::uint16_t>(half % 2 == 0 ? half : half + 1);
        ASSERT_EQ(rounded(middle), even) << half;
        ASSERT_EQ(rounded(std::nextafterf(middle, 0.0f)), half);
        ASSERT_EQ(rounded(std::nextafterf(middle, 1e9f)), half + 1);
        ASSERT_EQ(rounded(-middle), even | 0x8000);
    }
}

TEST(Half, ProcessorsWithAndWithoutInstructionsForItGiveTheSameBits) {
    const auto halves = all_halves();
    std::vector<float> values(halves.size());
    std::vector<float> twin(halves.size());
    from_half(halves, values);
    from_half_portable(halves, twin);
    for (std::size_t i = 0; i < halves.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(values[i]), std::bit_cast<std::uint32_t>(twin[i]))
            << i;
    std::mt19937 random(17);
    std::vector<float> floats;
    for (int i = 0; i < 1'000'003; ++i) // not a multiple of eight
        floats.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    for (std::uint32_t bits = 0x33000000u; bits < 0x48000000u; bits += 797) // what halves can hold
        floats.push_back(std::bit_cast<float>(bits));
    std::vector<std::uint16_t> rounded_one(floats.size());
    std::vector<std::uint16_t> rounded_two(floats.size());
    to_half(floats, rounded_one);
    to_half_portable(floats, rounded_two);
    for (std::size_t i = 0; i < floats.size(); ++i)
        ASSERT_EQ(rounded_one[i], rounded_two[i]) << std::bit_cast<std::uint32_t>(floats[i]);
}

TEST(Half, WhatIsTooLargeBecomesInfinite) {
    EXPECT_EQ(rounded(65504.0f), 0x7bff);
    EXPECT_EQ(rounded(std::nextafterf(65520.0f, 0.0f)), 0x7bff);
    EXPECT_EQ(rounded(65520.0f), 0x7c00);
    EXPECT_EQ(rounded(-1e30f), 0xfc00);
    EXPECT_EQ(rounded(std::numeric_limits<float>::denorm_min()), 0);
}

} // namespace
} // namespace wakesurf::core::half_test
