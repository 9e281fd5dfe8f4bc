#include "core/base/rounding.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace wakesurf::core::rounding_test {

namespace {

/// As a solver that writes 32 bits has it.
double in_32_bits(double x) {
    return static_cast<float>(x);
}

} // namespace

TEST(Rounding, ADecimalNumberIsWithinARangeThatBeginsOrEndsThereIn32Bits) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> tenths(-1000, 1000);
    std::uniform_int_distribution<int> power(-7, 7);
    for (int i = 0; i < 10'000; ++i) {
        const double scale = std::pow(10.0, power(random));
        const double a = 0.1 * tenths(random) * scale;
        const double b = a + 0.1 * (10 + std::abs(tenths(random))) * scale;
        ASSERT_TRUE(within_rounding(a, in_32_bits(a), in_32_bits(b))) << a << " " << b;
        ASSERT_TRUE(within_rounding(b, in_32_bits(a), in_32_bits(b))) << a << " " << b;
    }
}

TEST(Rounding, WhatIsOutsideByMoreIsOutside) {
    EXPECT_FALSE(within_rounding(0.1 - 1e-6, in_32_bits(0.1), 2.1));
    EXPECT_FALSE(within_rounding(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0));
    EXPECT_FALSE(within_rounding(std::numeric_limits<double>::infinity(), 0.0, 1.0));
    // Metres from a far origin, seconds since 1970: a rounding of 32 bits would be a metre, and four minutes.
    EXPECT_FALSE(within_rounding(5'420'000.0 - 0.2, 5'420'000.0, 5'430'000.0));
    EXPECT_FALSE(within_rounding(1.7e9 - 10.0, 1.7e9, 1.7e9 + 3600.0));
    EXPECT_TRUE(within_rounding(1.7e9 - 1e-6, 1.7e9, 1.7e9 + 3600.0));
    // A range that is one number, as the times of one time-step.
    EXPECT_TRUE(within_rounding(0.1, in_32_bits(0.1), in_32_bits(0.1)));
    EXPECT_FALSE(within_rounding(0.2, in_32_bits(0.1), in_32_bits(0.1)));
}

TEST(Rounding, APointBeyondAFaceByRoundingComesToLieInItAndAnyOtherStays) {
    const Box box{Vec3(in_32_bits(0.1), in_32_bits(-0.3), 0.0), Vec3(2.1, 1.7, 2.0)};
    EXPECT_EQ(onto_faces({0.1, -0.3, 1.0}, box), Vec3(box.lo.x, -0.3, 1.0));
    EXPECT_EQ(onto_faces({0.1, 0.5, 5.0}, box), Vec3(box.lo.x, 0.5, 5.0));
    EXPECT_EQ(onto_faces({0.09, 0.5, 1.0}, box), Vec3(0.09, 0.5, 1.0));
    EXPECT_EQ(onto_faces({1.0, 0.5, 2.0 + 1e-7}, box), Vec3(1.0, 0.5, 2.0));
}

} // namespace wakesurf::core::rounding_test
