#include "core/surface/rake.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

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

TEST(Rake, InAFaceThatIsRoundedTo32BitsLiesInThatFaceWithAllItsSeeds) {
    const Box box{Vec3(0.1f, -0.3f, 0.7f), Vec3(2.1f, 1.7f, 2.7f)};
    const Rake circle{Rake::Kind::Circle, {{0.1, 0.5, 1.5}, {0.1, 0.9, 1.5}, {0.1, 0.5, 1.9}}, 16};
    for (const Rake& rake : {line({0.1, 0.1, 1.1}, {0.1, 0.5, 1.3}), circle}) {
        const auto clipped = clip_rake(rake, box);
        ASSERT_TRUE(clipped);
        EXPECT_FALSE(clipped->clipped);
        const SeedingCurve seeding(clipped->rake);
        for (int i = 0; i <= 1000; ++i)
            ASSERT_EQ(seeding.at(i / 1000.0).x, box.lo.x) << i;
    }
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

TEST(SeedingCurve, ACirclesPointsAreAtItsRadiusToRounding) {
    const Vec3 centre(1, 1, 1);
    const SeedingCurve curve({Rake::Kind::Circle, {centre, {3, 1, 1}, {1.5, 5, 1}}, 8});
    EXPECT_EQ(curve.at(0.0), Vec3(3, 1, 1));
    EXPECT_EQ(curve.at(0.0), curve.at(1.0));
    EXPECT_NEAR(curve.length(), 4.0 * std::numbers::pi, 1e-14);
    EXPECT_TRUE(curve.corners().empty());
    for (double s = 0.0; s < 1.0; s += 0.00037) {
        EXPECT_NEAR(glm::length(curve.at(s) - centre), 2.0, 1e-15 * 4);
        EXPECT_NEAR(glm::dot(curve.tangent(s), curve.at(s) - centre), 0.0, 1e-13);
        EXPECT_NEAR(glm::length(curve.tangent(s)), curve.length(), 1e-13);
    }
    EXPECT_LT(glm::length(curve.at(0.25) - Vec3(1, 3, 1)), 1e-15);
}

TEST(Rake, ACirclePartlyOutsideReleasesFromItsLongestArcInside) {
    // Two sides of the box cut a quarter and more off; what is left are two arcs of different lengths.
    const Rake rake{Rake::Kind::Circle, {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}}, 8};
    const Box box{{-0.6, -2, 0}, {0.8, 0.9, 1}};
    const auto clipped = clip_rake(rake, box);
    ASSERT_TRUE(clipped) << clipped.error().message;
    EXPECT_TRUE(clipped->clipped);
    EXPECT_EQ(clipped->rake.kind, Rake::Kind::Circle);
    EXPECT_EQ(clipped->rake.points, rake.points);
    EXPECT_FALSE(clipped->rake.closed());
    const SeedingCurve curve(clipped->rake);
    // The lower one, from x = -0.6 to 0.8.
    EXPECT_NEAR(curve.length(), std::asin(0.6) + std::asin(0.8), 1e-14);
    EXPECT_LT(glm::length(curve.at(0.0) - Vec3(-0.6, -0.8, 0.5)), 1e-14);
    EXPECT_LT(glm::length(curve.at(1.0) - Vec3(0.8, -0.6, 0.5)), 1e-14);
    for (int i = 0; i <= 100; ++i) {
        const Vec3 p = curve.at(i / 100.0);
        EXPECT_TRUE(box.contains(p)) << i;
        EXPECT_NEAR(glm::length(p - rake.points[0]), 1.0, 1e-15 * 4);
        EXPECT_NEAR(glm::length(curve.tangent(i / 100.0)), curve.length(), 1e-13);
    }
    // Cut again by the same box it is the same, and by one that holds all of it the whole circle.
    EXPECT_EQ(clip_rake(clipped->rake, box)->rake, clipped->rake);
    EXPECT_EQ(clip_rake(clipped->rake, {Vec3(-2), Vec3(2)})->rake, rake);
}

TEST(Rake, RandomCirclesKeepAllThatIsInside) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto point = [&] { return Vec3(any(random), any(random), any(random)); };
    const Box box{Vec3(-0.6, -0.5, -0.7), Vec3(0.4, 0.8, 0.5)};
    for (int i = 0; i < 300; ++i) {
        const Rake rake{Rake::Kind::Circle, {point(), point(), point()}, 8};
        const Circle circle(rake.points[0], rake.points[1], rake.points[2]);
        constexpr int samples = 2000;
        int run = 0, longest = 0; // of samples inside that follow one another, going round twice
        for (int k = 0; k < 2 * samples; ++k) {
            run = box.contains(circle.at(static_cast<double>(k) / samples)) ? run + 1 : 0;
            longest = std::max(longest, std::min(run, samples));
        }
        const auto clipped = clip_rake(rake, box);
        if (!clipped) {
            EXPECT_EQ(longest, 0) << i;
            continue;
        }
        const Arc arc = clipped->rake.arc;
        EXPECT_NEAR((arc[1] - arc[0]) * samples, longest, 1.01) << i;
        EXPECT_EQ(clipped->rake.closed(), longest == samples) << i;
        EXPECT_TRUE(clipped->rake.closed() ||
                    (box.contains(circle.at(arc[0])) && box.contains(circle.at(arc[1]))))
            << i;
    }
}

} // namespace wakesurf::core::rake_test
