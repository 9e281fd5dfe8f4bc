#include "core/surface/rake.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wakesurf::core::rake_test {

namespace {

const Box unit{Vec3(0.0), Vec3(1.0)};

Rake line(Vec3 a, Vec3 b) {
    return {Rake::Kind::Line, {a, b}, 8};
}

} // namespace

TEST(Rake, InsideTheDomainIsKeptAsItIs) {
    const auto clipped = clip_rake(line({0.1, 0.2, 0.3}, {0.9, 0.8, 0.7}), unit);
    ASSERT_TRUE(clipped);
    EXPECT_FALSE(clipped->clipped);
    EXPECT_EQ(clipped->rake, line({0.1, 0.2, 0.3}, {0.9, 0.8, 0.7}));
}

TEST(Rake, PartlyOutsideIsCutAtTheDomainsBorder) {
    const auto clipped = clip_rake(line({-1, 0.5, 0.5}, {0.5, 0.5, 0.5}), unit);
    ASSERT_TRUE(clipped);
    EXPECT_TRUE(clipped->clipped);
    EXPECT_NEAR(clipped->rake.points[0].x, 0.0, 1e-15);
    EXPECT_NEAR(clipped->rake.points[1].x, 0.5, 1e-15);
}

TEST(Rake, OutsideSaysByHowMuch) {
    const auto clipped = clip_rake(line({3, 0, 0}, {3, 1, 0}), unit);
    ASSERT_FALSE(clipped);
    EXPECT_EQ(clipped.error().code, Error::Code::OutOfDomain);
    EXPECT_NE(clipped.error().message.find("by 2"), std::string::npos) << clipped.error().message;
}

TEST(Rake, PolylineKeepsItsLongestPartInside) {
    const Rake rake{
        Rake::Kind::Polyline, {{0.9, 0.1, 0}, {1.5, 0.1, 0}, {1.5, 0.5, 0}, {0.2, 0.5, 0}}, 8};
    const auto clipped = clip_rake(rake, unit);
    ASSERT_TRUE(clipped);
    EXPECT_NEAR(SeedingCurve(clipped->rake).length(), 0.8, 1e-12);
}

TEST(Rake, NonFiniteOrCoincidingPointsAreRefused) {
    EXPECT_FALSE(clip_rake(line({0, 0, 0}, {0, 0, 0}), unit));
    EXPECT_FALSE(
        clip_rake(line({0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}), unit));
    EXPECT_FALSE(clip_rake(line({0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}), unit));
    EXPECT_FALSE(clip_rake({Rake::Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 1}, unit));
    EXPECT_FALSE(clip_rake({Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, 8}, unit));
}

TEST(SeedingCurve, RunsByArcLengthAlongAPolyline) {
    const SeedingCurve curve({Rake::Kind::Polyline, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}}, 8});
    EXPECT_EQ(curve.length(), 4.0);
    EXPECT_EQ(curve.at(0.5), Vec3(2, 0, 0));
    EXPECT_EQ(curve.at(0.875), Vec3(3, 0.5, 0));
    EXPECT_EQ(curve.at(1.0), Vec3(3, 1, 0));
    EXPECT_EQ(curve.tangent(0.9), Vec3(0, 4, 0));
}

TEST(SeedingCurve, ACircleIsRoundAndClosed) {
    const SeedingCurve curve({Rake::Kind::Circle, {{1, 1, 1}, {3, 1, 1}, {1, 5, 1}}, 8});
    EXPECT_LT(glm::length(curve.at(0.0) - curve.at(1.0)), 1e-12);
    for (double s = 0.0; s < 1.0; s += 0.01)
        EXPECT_NEAR(glm::length(curve.at(s) - Vec3(1, 1, 1)), 2.0, 5e-5);
}

} // namespace wakesurf::core::rake_test
