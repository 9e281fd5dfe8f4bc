// The clock of a session against a wall clock turned by hand.
#include "server/base/limits.hpp"
#include "server/sessions/session_clock.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wakesurf::server::session_clock_test {

namespace {

using std::chrono::milliseconds;

class ClockTest : public testing::Test {
  protected:
    void play(double speed, bool again = false) {
        ASSERT_TRUE(clock.play({{}, speed, again, {}, {}}, std::array{10.0, 20.0}));
    }

    HandClock wall;
    HandLoop loop{wall};
    std::vector<protocol::ClockRecord> told;
    std::vector<double> shown;
    int jumps = 0;
    SessionClock clock{loop,
                       wall,
                       {[this] { told.push_back(clock.record()); },
                        [this](bool jumped) {
                            shown.push_back(clock.time().value_or(-1.0));
                            jumps += jumped ? 1 : 0;
                        }}};
};

} // namespace

TEST_F(ClockTest, HasNoTimeUntilSomebodySetsOne) {
    EXPECT_FALSE(clock.time());
    EXPECT_EQ(clock.record(), protocol::ClockRecord{});
    clock.set(3.5);
    EXPECT_EQ(clock.time(), 3.5);
    loop.advance(milliseconds(5000));
    EXPECT_EQ(clock.time(), 3.5) << "it stands";
    clock.set(std::nullopt);
    EXPECT_FALSE(clock.time());
    EXPECT_EQ(told.size(), 2U);
}

TEST_F(ClockTest, RunsAtItsSpeedFromTheStartOfWhatIsPlayed) {
    play(2.0);
    EXPECT_EQ(clock.time(), 10.0);
    loop.advance(milliseconds(1500));
    EXPECT_DOUBLE_EQ(*clock.time(), 13.0);
    clock.pause();
    loop.advance(milliseconds(1000));
    EXPECT_DOUBLE_EQ(*clock.time(), 13.0);
    play(1.0);
    loop.advance(milliseconds(250));
    EXPECT_DOUBLE_EQ(*clock.time(), 13.25) << "on from where it stood";
}

TEST_F(ClockTest, TellsItsRecordWhenSomebodyActsAndItsTimeThirtyTimesASecond) {
    play(1.0);
    loop.advance(milliseconds(1000));
    EXPECT_EQ(told.size(), 1U);
    EXPECT_GE(shown.size(), 29U);
    EXPECT_LE(shown.size(), 32U);
    EXPECT_EQ(jumps, 1);
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
}

TEST_F(ClockTest, StopsAtTheEndAndBeginsAgainWhenPlayedFromThere) {
    play(4.0);
    loop.advance(milliseconds(10'000));
    EXPECT_EQ(clock.time(), 20.0);
    EXPECT_FALSE(clock.playing());
    ASSERT_EQ(told.size(), 2U);
    EXPECT_FALSE(told[1].playing);
    EXPECT_EQ(told[1].time, 20.0);
    play(4.0);
    EXPECT_EQ(clock.time(), 10.0);
}

TEST_F(ClockTest, GoesRoundAndRoundInALoop) {
    play(4.0, true);
    loop.advance(milliseconds(6'000)); // 24 units: twice round and 4
    EXPECT_TRUE(clock.playing());
    EXPECT_NEAR(*clock.time(), 14.0, 1e-9);
    EXPECT_EQ(told.size(), 1U);
    EXPECT_EQ(jumps, 3) << "the start and two rounds";
}

TEST_F(ClockTest, GoesOnRunningFromATimeSomebodyJumpsTo) {
    play(1.0);
    clock.set(15.0);
    EXPECT_TRUE(clock.playing());
    loop.advance(milliseconds(500));
    EXPECT_DOUBLE_EQ(*clock.time(), 15.5);
    clock.set(25.0);
    EXPECT_FALSE(clock.playing()) << "beyond what is played";
    EXPECT_EQ(clock.time(), 25.0);
}

TEST_F(ClockTest, IsToldWhatToPlayOrKnowsItFromTheSurfaces) {
    const auto nothing = clock.play({}, std::nullopt);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().code, core::Error::Code::InvalidArgument);
    EXPECT_TRUE(told.empty());
    ASSERT_TRUE(clock.play({{}, {}, {}, 1.0, 2.0}, std::nullopt));
    ASSERT_TRUE(clock.play({}, std::array{10.0, 20.0}));
    EXPECT_EQ(clock.record().from, 1.0) << "what was said stays";
    EXPECT_FALSE(clock.play({{}, {}, {}, 3.0, {}}, std::nullopt)) << "3 to 2";
}

} // namespace wakesurf::server::session_clock_test
