#include "core/surface/value_range.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace wakesurf::core::value_range_test {

namespace {

/// 0, 1, ... n - 1, each n-th part of it.
std::vector<double> steps(std::size_t n, double from, double to) {
    std::vector<double> out(n);
    for (std::size_t i = 0; i < n; ++i)
        out[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(n - 1);
    return out;
}

ValueRange of(const std::vector<double>& values, const std::vector<float>& areas = {}) {
    return value_range(values, areas).value();
}

} // namespace

TEST(ValueRange, HoldsAllWhereTheLastPerCentTakesNoMoreThanItsShare) {
    EXPECT_EQ(of(steps(1000, 0.2, 1.8)), (ValueRange{0.2, 1.8, 0.2, 1.8}));
    EXPECT_EQ(of(steps(1000, -3.0, 1.0)), (ValueRange{-3.0, 1.0, -3.0, 1.0}));
    EXPECT_EQ(of({4.0}), (ValueRange{4.0, 4.0, 4.0, 4.0}));
}

TEST(ValueRange, LeavesOutAThousandTimesLargerValuesOnOneInTwoHundred) {
    auto values = steps(995, 0.0, 1.0);
    values.insert(values.end(), 5, 1000.0);
    const ValueRange range = of(values);
    EXPECT_NEAR(range.high, 0.995, 0.001);
    EXPECT_EQ(range.low, 0.0);
    EXPECT_EQ(range.greatest, 1000.0);
}

TEST(ValueRange, LeavesOutAtBothEndsWhereTheValuesHaveASign) {
    auto values = steps(980, -1.0, 1.0);
    values.insert(values.end(), 9, 500.0);
    values.insert(values.end(), 9, -400.0);
    const ValueRange range = of(values);
    EXPECT_NEAR(range.low, -1.0, 0.01);
    EXPECT_NEAR(range.high, 1.0, 0.01);
    EXPECT_EQ(range.least, -400.0);
}

TEST(ValueRange, KeepsTheLowerEndOfValuesWithoutASign) {
    auto values = steps(995, 100.0, 101.0);
    values.insert(values.end(), 5, 1.0);
    EXPECT_EQ(of(values).low, 1.0);
}

TEST(ValueRange, CountsTheAreaAndNotTheVertices) {
    // Half of the vertices crowd beside a wall, on a thousandth of the area.
    auto values = steps(500, 0.0, 1.0);
    values.insert(values.end(), 500, 50.0);
    std::vector<float> areas(500, 1.0F);
    areas.insert(areas.end(), 500, 1e-3F);
    EXPECT_LT(of(values, areas).high, 1.0);
    EXPECT_EQ(of(values).high, 50.0);
}

TEST(ValueRange, OfManyVerticesIsThatOfAFew) {
    auto few = steps(1'000, 0.0, 1.0);
    auto many = steps(1'000'000, 0.0, 1.0);
    few.insert(few.end(), 5, 300.0);
    many.insert(many.end(), 5'000, 300.0);
    EXPECT_NEAR(of(many).high, of(few).high, 2e-3);
    EXPECT_EQ(of(many).greatest, 300.0);
}

TEST(ValueRange, LooksPastWhatIsNoNumber) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(of({nan, 1.0, infinite, 3.0, -infinite}), (ValueRange{1.0, 3.0, 1.0, 3.0}));
    EXPECT_FALSE(value_range(std::vector<double>{nan}, {}).has_value());
    EXPECT_FALSE(value_range({}, {}).has_value());
    EXPECT_EQ(of({1.0, 2.0}, {0.0F, 0.0F}), (ValueRange{1.0, 2.0, 1.0, 2.0}));
}

TEST(ValueRange, AQuarterOfACellGoesToEachOfItsCorners) {
    QuadComplex mesh;
    mesh.position = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {5, 0, 0}, {5, 3, 0}};
    mesh.cells = {{{0, 1, 2, 3}}, {{1, 4, 5, 2}}};
    EXPECT_EQ(vertex_areas(mesh), (std::vector<float>{1.5F, 3.75F, 3.75F, 1.5F, 2.25F, 2.25F}));
}

} // namespace wakesurf::core::value_range_test
