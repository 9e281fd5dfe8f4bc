#include "core/surface/slice/plane_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::core::plane_window_test {

namespace {

const Box box{{-1, -2, -3}, {3, 2, 1}};

void expect_near(const Vec3& is, const Vec3& should) {
    EXPECT_LT(glm::length(is - should), 1e-12) << is.x << " " << is.y << " " << is.z;
}

/// The area of a polygon in space.
double area(const std::vector<Vec3>& corners) {
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < corners.size(); ++k)
        sum += glm::cross(corners[k] - corners[0], corners[(k + 1) % corners.size()] - corners[0]);
    return 0.5 * glm::length(sum);
}

} // namespace

TEST(PlaneWindow, AcrossAnAxisIsTheFaceOfTheDomainTurnedAsPeopleDrawIt) {
    for (const double sign : {1.0, -1.0}) {
        const auto z = plane_window({{0, 0, -1}, {0, 0, 2.0 * sign}}, box).value();
        expect_near(z.corner, {-1, -2, -1});
        expect_near(z.across, {4, 0, 0});
        expect_near(z.up, {0, 4, 0});
        const auto y = plane_window({{0, 0.5, 0}, {0, sign, 0}}, box).value();
        expect_near(y.corner, {-1, 0.5, -3});
        expect_near(y.across, {4, 0, 0});
        expect_near(y.up, {0, 0, 4});
        const auto x = plane_window({{0.5, 0, 0}, {1e-200 * sign, 0, 0}}, box).value();
        expect_near(x.corner, {0.5, -2, -3});
        expect_near(x.across, {0, 4, 0});
        expect_near(x.up, {0, 0, 4});
    }
}

TEST(PlaneWindow, OfAnObliquePlaneIsTheSmallestRectangleRoundWhereItCutsTheDomain) {
    const Plane plane{{1, 0, -1}, {1, 1, 1}};
    const auto section = plane_section(plane, box);
    ASSERT_EQ(section.size(), 6u);
    // A regular hexagon, its sides half the diagonal of a face of this cube.
    EXPECT_NEAR(area(section), 1.5 * std::sqrt(3.0) * 8.0, 1e-12);
    const auto window = plane_window(plane, box).value();
    EXPECT_NEAR(glm::dot(window.across, window.up), 0.0, 1e-12);
    double least_s = 1.0, most_s = 0.0, least_t = 1.0, most_t = 0.0;
    for (const Vec3& corner : section) {
        EXPECT_NEAR(plane.height(corner), 0.0, 1e-12);
        const double s = glm::dot(corner - window.corner, window.across) /
                         glm::dot(window.across, window.across);
        const double t =
            glm::dot(corner - window.corner, window.up) / glm::dot(window.up, window.up);
        least_s = std::min(least_s, s), most_s = std::max(most_s, s);
        least_t = std::min(least_t, t), most_t = std::max(most_t, t);
    }
    EXPECT_NEAR(least_s, 0.0, 1e-12);
    EXPECT_NEAR(most_s, 1.0, 1e-12);
    EXPECT_NEAR(least_t, 0.0, 1e-12);
    EXPECT_NEAR(most_t, 1.0, 1e-12);
}

TEST(PlaneWindow, BeyondAFaceByRoundingIsThatFaceAndFurtherOffSaysByHowMuch) {
    EXPECT_EQ(plane_section({{3.0000001, 0, 0}, {1, 0, 0}}, box).size(), 4u);
    const auto off = plane_window({{0, 0, 1.5}, {0, 0, -1}}, box);
    ASSERT_FALSE(off);
    EXPECT_EQ(off.error().code, Error::Code::OutOfDomain);
    EXPECT_EQ(off.error().message, "the plane misses the domain by 0.5");
}

TEST(PlaneWindow, WithoutADirectionOrAPlaceIsRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Plane& plane : {Plane{{0, 0, 0}, {0, 0, 0}}, Plane{{0, 0, 0}, {0, nan, 1}},
                               Plane{{0, nan, 0}, {0, 0, 1}}}) {
        const auto window = plane_window(plane, box);
        ASSERT_FALSE(window);
        EXPECT_EQ(window.error().code, Error::Code::InvalidArgument);
        EXPECT_TRUE(plane_section(plane, box).empty());
    }
}

} // namespace wakesurf::core::plane_window_test
