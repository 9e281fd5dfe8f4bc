#include "core/surface/family/plane_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::plane_curve_test {
namespace {

using Kind = Rake::Kind;

TEST(PlaneCurve, MeasuresALineThatGoesOnBeyondItsEnds) {
    const PlaneCurve line({Kind::Line, {{1, 0, 0}, {2, 0, 0}}}, {0, 0, 1});
    const double side = line.distance({1.5, 0.5, 0}) > 0.0 ? 1.0 : -1.0;
    for (const double x : {-100.0, 0.0, 1.0, 1.7, 2.0, 50.0})
        for (const double y : {-3.0, -0.25, 0.25, 7.0})
            EXPECT_DOUBLE_EQ(line.distance({x, y, 0}), side * y);
}

TEST(PlaneCurve, MeasuresACircleFromItsRim) {
    const PlaneCurve circle({Kind::Circle, {{1, 2, 3}, {1, 4, 3}, {1, 2, 5}}}, {1, 0, 0});
    EXPECT_DOUBLE_EQ(circle.distance({1, 2, 3}), -2.0);
    EXPECT_NEAR(circle.distance({1, 5, 7}), 3.0, 1e-15);
}

TEST(PlaneCurve, HasTwoSidesRoundTheCornersOfAPolyline) {
    const PlaneCurve bent({Kind::Polyline, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {0, 0, 1});
    const double inside = bent.distance({0.9, 0.5, 0});
    EXPECT_NEAR(std::abs(inside), 0.1, 1e-15);
    EXPECT_NEAR(bent.distance({0.5, 0.2, 0}), std::copysign(0.2, inside), 1e-15);
    EXPECT_NEAR(bent.distance({1.3, -0.4, 0}), std::copysign(0.5, -inside),
                1e-15); // from the corner
    EXPECT_NEAR(bent.distance({0.5, -9, 0}), std::copysign(9.0, -inside), 1e-14);
    EXPECT_NEAR(bent.distance({3, 5, 0}), std::copysign(2.0, -inside), 1e-14); // beyond its end
}

TEST(PlaneCurve, ClosesAPolylineThatReturnsToItsBeginning) {
    const PlaneCurve square(
        {Kind::Polyline, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1});
    const double inside = square.distance({0.5, 0.5, 0}) > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(square.distance({0.25, 0.5, 0}), inside * 0.25, 1e-15);
    EXPECT_NEAR(square.distance({-3, -4, 0}), -inside * 5.0, 1e-14);
    EXPECT_NEAR(square.distance({0.5, -2, 0}), -inside * 2.0, 1e-14);
}

TEST(PlaneCurve, FindsThePlaneOfACurveAndRefusesOneThatLiesInNone) {
    const auto line = PlaneCurve::plane_of({Kind::Polyline, {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}});
    ASSERT_TRUE(line);
    EXPECT_FALSE(*line);
    const auto flat = PlaneCurve::plane_of({Kind::Polyline, {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}}});
    ASSERT_TRUE(flat && *flat);
    EXPECT_NEAR(std::abs((**flat).z), 1.0, 1e-15);
    const auto bent =
        PlaneCurve::plane_of({Kind::Polyline, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0.1}}});
    ASSERT_FALSE(bent);
    EXPECT_EQ(bent.error().code, Error::Code::InvalidArgument);
    EXPECT_NE(bent.error().message.find("not planar"), std::string::npos);
    EXPECT_FALSE(PlaneCurve::plane_of({Kind::Points, {{0, 0, 0}, {1, 0, 0}}}));
}

} // namespace
} // namespace wakesurf::core::plane_curve_test
