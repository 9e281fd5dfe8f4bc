#include "core/field/analytic_flow.hpp"
#include "core/surface/columns/zip.hpp"
#include "tests/support/straight_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::zip_test {

using tests::straight_curve;

namespace {

const std::unique_ptr<Flow>& free_flow() {
    static const std::unique_ptr<Flow> flow = *make_analytic_flow("uniform");
    return flow;
}

Column column(Vec3 a, Vec3 b, double spacing) {
    return make_column(0.0, straight_curve(a, b), 0.0, {spacing});
}

/// Zips as far as it goes; returns where the front ends and how many quads had a hanging node.
struct Zipped {
    StripFront end;
    int quads = 0;
    int hanging = 0;
};

Zipped zip_all(const Column& left,
               const Column& right,
               double separation,
               ZipMode mode,
               const Flow& flow = *free_flow()) {
    const ZipRules rules{&flow, separation};
    Zipped result;
    while (const auto step = next_quad(rules, left.position, right.position, result.end, mode)) {
        result.end.left += step->left;
        result.end.right += step->right;
        ++result.quads;
        result.hanging += step->left != step->right;
        if (result.end.left == left.segments() && result.end.right == right.segments())
            break;
    }
    return result;
}

} // namespace

TEST(Zip, EqualColumnsGiveOneQuadASegment) {
    const Column left = column({0, 0, 0}, {5, 0, 0}, 0.5);
    const Column right = column({0, 1, 0}, {5, 1, 0}, 0.5);
    const Zipped zipped = zip_all(left, right, 1.0, ZipMode::ToBothEnds);
    EXPECT_EQ(zipped.quads, 10);
    EXPECT_EQ(zipped.hanging, 0);
}

TEST(Zip, UsesUpBothColumnsOfAnyJoinableLengths) {
    for (int a = 1; a <= 24; ++a)
        for (int b = 1; b <= 24; ++b) {
            const Column left = column({0, 0, 0}, {0.1 * a, 0, 0}, 0.1);
            const Column right = column({0, 1, 0}, {0.1 * b, 1, 0}, 0.1);
            const Zipped zipped = zip_all(left, right, 10.0, ZipMode::ToBothEnds);
            const bool whole =
                zipped.end.left == left.segments() && zipped.end.right == right.segments();
            EXPECT_EQ(whole, joinable(left.segments(), right.segments())) << a << " and " << b;
        }
}

TEST(Zip, ShearedColumnsKeepTheFrontSquareByHangingNodes) {
    const Column left = column({0, 0, 0}, {8, 0, 0}, 0.1);
    const Column right = column({-3, 0.15, 0}, {8, 0.15, 0}, 0.1); // its start lies 3 upstream
    const Zipped zipped = zip_all(left, right, 4.0, ZipMode::ToBothEnds);
    EXPECT_GT(zipped.hanging, 10);
    EXPECT_EQ(zipped.end.left, left.segments());
    EXPECT_EQ(zipped.end.right, right.segments());
}

TEST(Zip, StopsBeforeAFrontLongerThanTheSeparation) {
    const Column left = column({0, 0, 0}, {5, -1, 0}, 0.1);
    const Column right = column({0, 0.2, 0}, {5, 1.2, 0}, 0.1);
    const Zipped zipped = zip_all(left, right, 1.0, ZipMode::ToBothEnds);
    const double width =
        glm::length(left.position[zipped.end.left] - right.position[zipped.end.right]);
    EXPECT_LE(width, 1.0);
    EXPECT_GT(width, 0.9);
}

TEST(Zip, NoFrontCrossesAnObstacle) {
    const auto sphere = *make_analytic_flow("sphere");
    const Column left = column({-2, -0.4, 0}, {2, -0.4, 0}, 0.1);
    const Column right = column({-2, 0.4, 0}, {2, 0.4, 0}, 0.1);
    const Zipped zipped = zip_all(left, right, 1.0, ZipMode::Free, *sphere);
    EXPECT_LT(left.position[zipped.end.left].x, -0.49);
    EXPECT_GT(left.position[zipped.end.left].x, -0.7);
}

TEST(Zip, FrontWidthIsMeasuredSquareToTheColumns) {
    const Column left = column({0, 0, 0}, {5, 0, 0}, 0.5);
    const Column right = column({2, 0.3, 0}, {5, 0.3, 0}, 0.5);
    EXPECT_NEAR(front_width(left, right, {0, 0}), 0.3, 1e-12);
}

} // namespace wakesurf::core::zip_test
