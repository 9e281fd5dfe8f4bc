#include "core/surface/carried_error.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wakesurf::core::carried_distance_test {

namespace {

constexpr SurfaceTangents square{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

} // namespace

TEST(CarriedDistance, GrowsAsTheSurfaceIsStretched) {
    CarriedDistance error;
    error.add(square, 1e-3);
    const double before = error.length(square);
    EXPECT_GE(before, 1e-3);
    EXPECT_LE(before, 2e-3);
    const SurfaceTangents stretched{{100.0, 0.0, 0.0}, {0.0, 0.01, 0.0}};
    EXPECT_NEAR(error.length(stretched), 100.0 * 1e-3, 0.02 * 0.1);
}

TEST(CarriedDistance, IsLargerThanTheSumOfErrorsOfAnyDirections) {
    // Shear in between: the second is added to what the first has become.
    const SurfaceTangents sheared{{1.0, 0.0, 0.0}, {40.0, 1.0, 0.0}};
    CarriedDistance error;
    error.add(square, 1e-3);
    error.add(sheared, 2e-3);
    for (int i = 0; i < 64; ++i)
        for (int k = 0; k < 64; ++k) {
            const double first = 2.0 * std::numbers::pi * i / 64;
            const double second = 2.0 * std::numbers::pi * k / 64;
            const Vec3 was = 1e-3 * Vec3(std::cos(first), std::sin(first), 0.0);
            const Vec3 moved = was.x * sheared.s + was.y * sheared.t;
            const Vec3 sum = moved + 2e-3 * Vec3(std::cos(second), std::sin(second), 0.0);
            EXPECT_GE(error.length(sheared), glm::length(sum));
        }
    EXPECT_LT(error.length(sheared), 2.0 * (40.0 * 1e-3 + 2e-3));
}

TEST(CarriedDistance, WithoutTangentsThereIsNone) {
    CarriedDistance error;
    error.add({Vec3(0.0), Vec3(0.0)}, 1e-3);
    EXPECT_EQ(error, CarriedDistance());
    EXPECT_EQ(error.length(square), 0.0);
}

} // namespace wakesurf::core::carried_distance_test
