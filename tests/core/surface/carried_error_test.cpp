#include "core/surface/carried_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::carried_error_test {

namespace {

constexpr SurfaceTangents square{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

} // namespace

TEST(CarriedError, GrowsAsTheSurfaceShrinksAndNotAsItIsStretched) {
    CarriedError error;
    error.add(square, 1e-3);
    EXPECT_NEAR(error.across(square), 1e-3, 1e-9);
    // An incompressible flow that stretches the surface along itself presses what is beside it against it.
    EXPECT_NEAR(error.across({{100.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}), 1e-5, 1e-11);
    EXPECT_NEAR(error.across({{0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}}), 0.1, 1e-7);
    // Shear slides it along.
    EXPECT_NEAR(error.across({{1.0, 0.0, 0.0}, {40.0, 1.0, 0.0}}), 1e-3, 1e-9);
}

TEST(CarriedError, GrowsAsTheFluidExpandsThoughTheSurfaceIsNot) {
    CarriedError error;
    error.add(square, 1e-3);
    SurfaceTangents later = square;
    later.expansion = std::log(7.0);
    EXPECT_NEAR(error.across(later), 7e-3, 1e-9);
    // What arises there has to be carried back to add to it.
    error.add(later, 7e-3);
    EXPECT_NEAR(error.across(square), 2e-3, 1e-9);
    // Data whose divergence makes no sense lose no error.
    later.expansion = 1e3;
    EXPECT_GT(error.across(later), 1.0);
    error.add(later, 1e-3);
    EXPECT_NEAR(error.across(square), 2e-3, 1e-9);
    later.expansion = NAN;
    error.add(later, 1e-3);
    EXPECT_TRUE(std::isnan(error.across(square)));
}

TEST(CarriedError, AddsUpAsIfAllWereOnOneSide) {
    CarriedError error;
    error.add(square, 1e-3);
    error.add({{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, 1e-3);
    EXPECT_NEAR(error.across(square), 3e-3, 1e-9);
}

TEST(CarriedError, WithoutTangentsThereIsNone) {
    CarriedError error;
    error.add({Vec3(0.0), Vec3(0.0)}, 1e-3);
    EXPECT_EQ(error, CarriedError());
    EXPECT_EQ(error.across(square), 0.0);
}

TEST(SurfaceTangents, TellWhatOfAVectorPointsAcrossTheSurface) {
    EXPECT_NEAR(square.across(Vec3(3.0, 4.0, -2.0)), 2.0, 1e-12);
    const SurfaceTangents parallel{{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    EXPECT_NEAR(parallel.across(Vec3(3.0, 4.0, 0.0)), 5.0, 1e-12);
}

} // namespace wakesurf::core::carried_error_test
