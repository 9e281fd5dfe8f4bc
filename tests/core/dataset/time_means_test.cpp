#include "core/dataset/time_means.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace wakesurf::core::time_means_test {
namespace {

constexpr double pi = std::numbers::pi;

// The means of what a function of time is at times, at one place.
template <class Function>
TimeMeans means_of(const std::vector<double>& times, const Function& function) {
    const auto weights = trapezoidal_weights(times);
    TimeMeans means(1, 1);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::array<float, 1> value{static_cast<float>(function(times[i]))};
        means.add(value, weights[i]);
    }
    return means;
}

// Times that come closer and closer, from 0 to 1.
std::vector<double> uneven(std::size_t steps) {
    std::vector<double> times;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(steps);
        times.push_back(x * (2.0 - x));
    }
    return times;
}

TEST(TimeMeans, OfASineOverItsPeriodAreZeroAndTheAmplitudeOverRootTwo) {
    std::vector<double> times;
    for (int i = 0; i <= 24; ++i)
        times.push_back(i / 24.0);
    const auto means = means_of(times, [](double t) { return 3.0 * std::sin(2.0 * pi * t); });
    EXPECT_NEAR(means.mean(0), 0.0, 1e-7);
    EXPECT_NEAR(std::sqrt(means.variance(0)), 3.0 / std::numbers::sqrt2, 1e-6);
}

TEST(TimeMeans, OfUnevenTimesConvergeInTheOrderOfTheTrapezoidalRule) {
    const auto error = [](std::size_t steps) {
        const auto means =
            means_of(uneven(steps), [](double t) { return std::sin(2.0 * pi * t) + t; });
        // Of sin + t over 0 to 1: 1/2; of its square 1/2 + 1/3 - 1/pi.
        const double variance = 0.5 + 1.0 / 3.0 - 1.0 / pi - 0.25;
        return std::array{std::abs(means.mean(0) - 0.5), std::abs(means.variance(0) - variance)};
    };
    const auto coarse = error(40), fine = error(80);
    EXPECT_NEAR(coarse[0] / fine[0], 4.0, 0.2);
    EXPECT_NEAR(coarse[1] / fine[1], 4.0, 0.2);
}

TEST(TimeMeans, KeepTheDigitsOfASmallChangeOfALargeValue) {
    std::vector<double> times(101);
    std::iota(times.begin(), times.end(), 0.0);
    const auto means =
        means_of(times, [](double t) { return 101325.0 + (std::fmod(t, 2.0) < 1.0 ? 1 : -1); });
    EXPECT_NEAR(means.mean(0), 101325.0, 1e-6);
    EXPECT_NEAR(means.variance(0), 1.0, 1e-9);
}

TEST(TimeMeans, OfTwoHalvesCombineToThoseOfTheWhole) {
    const auto times = uneven(30);
    const auto weights = trapezoidal_weights(times);
    TimeMeans whole(2, 3), first(2, 3), second(2, 3);
    for (std::size_t i = 0; i < times.size(); ++i) {
        std::vector<float> values;
        for (int k = 0; k < 6; ++k)
            values.push_back(static_cast<float>(k + std::sin((k + 1) * times[i])));
        whole.add(values, weights[i]);
        (i < 11 ? first : second).add(values, weights[i]);
    }
    first.add(second);
    for (std::size_t place = 0; place < 2; ++place)
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(first.mean(place, i), whole.mean(place, i), 1e-12);
            EXPECT_NEAR(first.variance(place, i), whole.variance(place, i), 1e-12);
        }
}

TEST(TimeMeans, CountThePlacesThatHaveAValueAndNoOthers) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    TimeMeans means(3, 2);
    means.add(std::array{1.0f, 2.0f, 5.0f, none, none, none}, 1.0);
    means.add(std::array{3.0f, 2.0f, 7.0f, 8.0f, none, none}, 1.0);
    EXPECT_EQ(means.mean(0, 0), 2.0);
    EXPECT_EQ(means.variance(0, 0), 1.0);
    EXPECT_EQ(means.mean(1, 0), 7.0) << "where a component is missing the others do not count";
    EXPECT_EQ(means.variance(1, 1), 0.0);
    EXPECT_TRUE(std::isnan(means.mean(2, 0)));
    EXPECT_TRUE(std::isnan(means.variance(2, 1)));
}

TEST(TimeMeans, HavePhasesRoundTheMultiplesOfThePeriod) {
    EXPECT_EQ(phase_of(0.0, 0.4, 4), 0u);
    EXPECT_EQ(phase_of(0.3, 0.1, 4), 0u) << "three periods, but for rounding";
    EXPECT_EQ(phase_of(0.149, 0.4, 4), 1u);
    EXPECT_EQ(phase_of(0.151, 0.4, 4), 2u);
    EXPECT_EQ(phase_of(0.39, 0.4, 4), 0u);
    EXPECT_EQ(phase_of(-0.1, 0.4, 4), 3u);
    EXPECT_EQ(phase_of(7.0, 1e-320, 4), 0u) << "a period that is nothing beside the time";
}

} // namespace
} // namespace wakesurf::core::time_means_test
