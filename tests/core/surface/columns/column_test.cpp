#include "core/surface/columns/column.hpp"
#include "tests/support/straight_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wakesurf::core::column_test {

using tests::straight_curve;

TEST(Column, VerticesAreEvenlySpacedAndReachBothEnds) {
    const Column column = make_column(0.5, straight_curve({0, 0, 0}, {10, 0, 0}), 2.0, {3.0});
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
    const Column column = make_column(0.0, curve, 0.0, {1.0});
    EXPECT_EQ(column.segments(), 0u);
    EXPECT_EQ(column.position[0], curve.seed);
}

TEST(Column, NoSegmentIsShorterThanHalfTheSpacingUnlessTheCurveIs) {
    for (double length = 0.6; length < 5.0; length += 0.0371) {
        const Column column =
            make_column(0.0, straight_curve({0, 0, 0}, {length, 0, 0}), 0.0, {1.0});
        EXPECT_GE(length / static_cast<double>(column.segments()), 0.5) << length;
        EXPECT_LE(length / static_cast<double>(column.segments()), 1.0 + 1e-5) << length;
    }
}

TEST(Column, VerticesAreCloserWhereTheCurveTurnsDownToAnEighth) {
    // A quarter of a circle of radius 1, in steps of 1 degree, between straight ends of length 1.
    const double quarter = 0.5 * std::numbers::pi;
    Curve curve;
    const auto step = [&](const Vec3& from, const Vec3& to, double length, const Vec3& direction) {
        CurveStep one{.time = curve.last.arc,
                      .dt = length,
                      .c = {glm::dvec4(from, curve.last.arc), glm::dvec4(to - from, length),
                            glm::dvec4(length * direction - (to - from), 0.0)}};
        curve.steps.push_back(one);
        curve.last.arc += length;
        curve.last.position = to;
    };
    const auto on_arc = [&](double turn) { return Vec3(std::sin(turn), 1.0 - std::cos(turn), 0); };
    step({-1, 0, 0}, {0, 0, 0}, 1.0, {1, 0, 0});
    for (int i = 0; i < 90; ++i) {
        const double turn = quarter * i / 90;
        step(on_arc(turn), on_arc(quarter * (i + 1) / 90), quarter / 90,
             {std::cos(turn), std::sin(turn), 0});
    }
    step({1, 1, 0}, {1, 2, 0}, 1.0, {0, 1, 0});
    const auto spacing_at = [&](const Column& column, double arc) {
        std::size_t i = 0;
        while (column.arc[i + 1] < arc)
            ++i;
        return column.arc[i + 1] - column.arc[i];
    };
    const Column fine = make_column(0.0, curve, 0.0, {0.5, 0.1});
    EXPECT_NEAR(spacing_at(fine, 1.0 + 0.5 * quarter), 0.1, 0.005); // radius times turn
    EXPECT_NEAR(spacing_at(fine, 0.3), 0.5, 0.05);
    EXPECT_EQ(fine.arc.front(), 0.0);
    EXPECT_EQ(fine.arc.back(), curve.last.arc);
    const Column floor = make_column(0.0, curve, 0.0, {0.5, 0.001});
    EXPECT_NEAR(spacing_at(floor, 1.0 + 0.5 * quarter), 0.5 / 8.0, 0.002);
    EXPECT_EQ(make_column(0.0, curve, 0.0, {0.5, 0.51}).arc,
              make_column(0.0, curve, 0.0, {0.5}).arc);
}

TEST(NearestArc, FindsTheFootOfAPerpendicularWithinReach) {
    const Curve curve = straight_curve({0, 0, 0}, {10, 0, 0});
    EXPECT_NEAR(nearest_arc(curve, {4.3, 2.0, 0}, 4.0, 1.0), 4.3, 1e-9);
    EXPECT_NEAR(nearest_arc(curve, {9.0, 2.0, 0}, 4.0, 1.0), 5.0, 1e-9); // beyond reach
    EXPECT_NEAR(nearest_arc(curve, {12.0, 0, 0}, 9.8, 1.0), 10.0, 1e-9); // beyond the end
}

} // namespace wakesurf::core::column_test
