#include "server/base/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::server::forecast_test {

namespace {

/// After `seconds` of work whose done part grows by that power of the time and that takes 60 s.
std::optional<double> left_after(double seconds, double power) {
    Forecast forecast;
    for (double now = 0.2; now <= seconds + 1e-9; now += 0.2)
        forecast.add(now, std::pow(now / 60.0, power));
    return forecast.left();
}

} // namespace

TEST(Forecast, TellsTheRestOfWorkThatGoesEvenlySlowsDownOrSpeedsUp) {
    for (const double power : {0.5, 1.0, 2.0})
        for (const double seconds : {20.0, 45.0}) {
            const auto left = left_after(seconds, power);
            ASSERT_TRUE(left);
            EXPECT_NEAR(*left, 60.0 - seconds, 0.02 * 60.0) << power;
        }
}

TEST(Forecast, SaysNothingWhereItIsTooEarlyToTell) {
    EXPECT_FALSE(Forecast{}.left());
    EXPECT_FALSE(left_after(0.4, 1.0));
    Forecast waiting;
    waiting.add(30.0, 0.0);
    EXPECT_FALSE(waiting.left());
    waiting.add(31.0, 1.0);
    EXPECT_EQ(waiting.left(), 0.0);
}

TEST(Forecast, SpeaksOfSecondsMinutesAndHours) {
    EXPECT_EQ(words_for_left(0.2), "about 1 s left");
    EXPECT_EQ(words_for_left(42.4), "about 42 s left");
    EXPECT_EQ(words_for_left(180.0), "about 3 min left");
    EXPECT_EQ(words_for_left(7200.0), "about 2 h left");
}

TEST(Forecast, ForgetsOtherWorkWhenTheSecondsBeginAgain) {
    Forecast forecast;
    for (double now = 1.0; now <= 100.0; now += 1.0)
        forecast.add(now, now / 1000.0);
    forecast.add(0.5, 0.1);
    EXPECT_FALSE(forecast.left()) << "too early again";
    for (double now = 1.0; now <= 10.0; now += 1.0)
        forecast.add(now, now / 20.0);
    EXPECT_NEAR(forecast.left().value_or(0.0), 10.0, 0.1);
}

} // namespace wakesurf::server::forecast_test
