#include "core/field/rectilinear_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace wakesurf::core::rectilinear_axes_test {
namespace {

std::vector<double> geometric(std::size_t count, double ratio) {
    std::vector<double> x{-1.0};
    for (double step = 1e-6; x.size() < count; step *= ratio)
        x.push_back(x.back() + step);
    return x;
}

/// The definition: the last node that is not beyond x, but the one before the last at the upper border.
std::size_t cell_of(const std::vector<double>& nodes, double x) {
    const auto above = std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(nodes.size()) - 2));
}

TEST(RectilinearAxes, FindTheCellOfEveryCoordinateHoweverStretched) {
    std::vector<double> uneven{0.0};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(1e-9, 1.0);
    for (int i = 0; i < 500; ++i)
        uneven.push_back(uneven.back() + std::pow(unit(random), 6.0));
    const std::vector<double> two{-2.0, 5.0};
    for (const auto& x : {geometric(80, 1.4), geometric(300, 1.01), uneven, two}) {
        const RectilinearGrid grid{{x, two, geometric(5, 2.0)}};
        const RectilinearAxes axes(grid);
        std::vector<double> places;
        for (const double node : x)
            places.insert(places.end(),
                          {node, std::nextafter(node, -1e300), std::nextafter(node, 1e300)});
        for (int i = 0; i < 20'000; ++i)
            places.push_back(x.front() + (x.back() - x.front()) * std::pow(unit(random), i % 9));
        for (const double place : places) {
            const AxisPoint at = along(axes, 0, place);
            ASSERT_EQ(at.cell, cell_of(x, place)) << place;
            const double back = x[at.cell] + at.fraction * (x[at.cell + 1] - x[at.cell]);
            ASSERT_NEAR(back, std::clamp(place, x.front(), x.back()), 1e-15 * (x.back() - x[0]));
        }
    }
}

TEST(RectilinearAxes, ClampWhatLiesBeyondTheBorderAndWhatIsNoNumber) {
    const RectilinearGrid grid{{geometric(9, 1.3), geometric(4, 1.0), {0.0, 1.0, 10.0}}};
    const RectilinearAxes axes(grid);
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double below :
         {-1.0, -1.1, -1e300, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
        const AxisPoint at = along(axes, 0, below);
        EXPECT_EQ(at.cell, 0u) << below;
        EXPECT_EQ(at.fraction, 0.0) << below;
    }
    for (const double above : {grid.coordinates[0].back(), 1e300, infinite}) {
        const AxisPoint at = along(axes, 0, above);
        EXPECT_EQ(at.cell, 7u) << above;
        if (above < infinite) {
            EXPECT_EQ(at.fraction, 1.0) << above;
        }
    }
    EXPECT_EQ(cell_size(axes, {0, 0, 1}).z, 9.0);
    EXPECT_EQ(cell_origin(axes, {0, 0, 1}).z, 1.0);
}

} // namespace
} // namespace wakesurf::core::rectilinear_axes_test
