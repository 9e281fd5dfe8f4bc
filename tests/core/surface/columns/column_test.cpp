#include "core/surface/columns/column.hpp"
#include "tests/support/straight_curve.hpp"

#include <gtest/gtest.h>

using namespace wakesurf::core;
using wakesurf::test::straight_curve;

TEST(Column, VerticesAreEvenlySpacedAndReachBothEnds) {
    const Column column = make_column(0.5, straight_curve({0, 0, 0}, {10, 0, 0}), 2.0, 3.0);
    ASSERT_EQ(column.segments(), 3u);
    EXPECT_NEAR(column.position.front().x, 2.0, 1e-12);
    EXPECT_EQ(column.position.back().x, 10.0);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(column.arc[i + 1] - column.arc[i], 8.0 / 3.0, 1e-12);
}

TEST(Column, ACurveThatGoesNowhereIsOneVertex) {
    Curve curve;
    curve.seed = Vec3(1, 2, 3);
    curve.last.position = curve.seed;
    const Column column = make_column(0.0, curve, 0.0, 1.0);
    EXPECT_EQ(column.segments(), 0u);
    EXPECT_EQ(column.position[0], curve.seed);
}

TEST(Column, NoSegmentIsShorterThanHalfTheSpacingUnlessTheCurveIs) {
    for (double length = 0.6; length < 5.0; length += 0.0371) {
        const Column column = make_column(0.0, straight_curve({0, 0, 0}, {length, 0, 0}), 0.0, 1.0);
        EXPECT_GE(length / static_cast<double>(column.segments()), 0.5) << length;
        EXPECT_LE(length / static_cast<double>(column.segments()), 1.0 + 1e-5) << length;
    }
}

TEST(NearestArc, FindsTheFootOfAPerpendicularWithinReach) {
    const Curve curve = straight_curve({0, 0, 0}, {10, 0, 0});
    EXPECT_NEAR(nearest_arc(curve, {4.3, 2.0, 0}, 4.0, 1.0), 4.3, 1e-9);
    EXPECT_NEAR(nearest_arc(curve, {9.0, 2.0, 0}, 4.0, 1.0), 5.0, 1e-9); // beyond reach
    EXPECT_NEAR(nearest_arc(curve, {12.0, 0, 0}, 9.8, 1.0), 10.0, 1e-9); // beyond the end
}
