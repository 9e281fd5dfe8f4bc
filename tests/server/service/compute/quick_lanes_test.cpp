// Who gets the threads of full priority, by hand.
#include "server/service/compute/quick_lanes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

namespace wakesurf::server::quick_lanes_test {

namespace {

using Lane = QuickLanes::Lane;
using std::chrono::milliseconds;

/// Queues a job of a session and lets it take so many seconds.
Lane one_job(QuickLanes& lanes, const std::string& session, double seconds, QuickLanes::Time now) {
    const Lane lane = lanes.push(
        session, [] {}, now);
    EXPECT_EQ(lanes.pop(lane, now)->session, session);
    lanes.done(lane, session, seconds, now);
    return lane;
}

} // namespace

TEST(QuickLanes, NeverGivesOneSessionAllThreadsOfFullPriority) {
    QuickLanes lanes(4);
    const QuickLanes::Time now{};
    for (int i = 0; i < 64; ++i)
        EXPECT_EQ(lanes.push(
                      "heavy", [] {}, now),
                  i < 3 ? Lane::Upper : Lane::Lower);
    EXPECT_EQ(lanes.push(
                  "light", [] {}, now),
              Lane::Upper);
    lanes.pop(Lane::Upper, now);
    EXPECT_EQ(lanes.push(
                  "heavy", [] {}, now),
              Lane::Lower)
        << "one runs, two wait";
    lanes.done(Lane::Upper, "heavy", 0.0, now);
    EXPECT_EQ(lanes.push(
                  "heavy", [] {}, now),
              Lane::Upper);
}

TEST(QuickLanes, LowersASessionThatUsesMoreThanItsShareUntilItHasRested) {
    QuickLanes lanes(2);
    QuickLanes::Time now{};
    for (int i = 0; i < 200; ++i, now += milliseconds(16)) // a drag: a fifth of a processor
        EXPECT_EQ(one_job(lanes, "one drags", 0.0035, now), Lane::Upper);
    for (int i = 0; i < 200; ++i, now += milliseconds(4)) // one pass after the other
        one_job(lanes, "busy", 0.0035, now);
    EXPECT_EQ(one_job(lanes, "busy", 0.0035, now), Lane::Lower);
    EXPECT_EQ(one_job(lanes, "other", 0.0035, now), Lane::Upper);
    now += milliseconds(500);
    EXPECT_EQ(one_job(lanes, "busy", 0.0035, now), Lane::Upper);
}

TEST(QuickLanes, SharesTheUpperThreadsAmongManyBusySessionsSoThatTheyLeaveRoom) {
    QuickLanes lanes(2);
    QuickLanes::Time now{};
    const auto busy = [](int i) { return "busy " + std::to_string(i); };
    for (int round = 0; round < 50; ++round, now += milliseconds(20))
        for (int i = 0; i < 6; ++i) // each a quarter of a processor: less than it may have alone
            one_job(lanes, busy(i), 0.005, now);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(one_job(lanes, busy(i), 0.0, now), Lane::Lower);
    EXPECT_EQ(one_job(lanes, "light", 0.005, now), Lane::Upper);
}

TEST(QuickLanes, LetsTheSessionThatHasUsedLeastGoFirst) {
    QuickLanes lanes(2);
    const QuickLanes::Time now{};
    one_job(lanes, "drags", 0.02, now);
    lanes.push(
        "drags", [] {}, now);
    lanes.push(
        "light", [] {}, now);
    EXPECT_EQ(lanes.pop(Lane::Upper, now)->session, "light");
    EXPECT_EQ(lanes.pop(Lane::Upper, now)->session, "drags");
}

TEST(QuickLanes, KeepsAThreadFromSessionsThatAreAboutToBeLowered) {
    QuickLanes lanes(2);
    QuickLanes::Time now{};
    for (int i = 0; i < 100; ++i, now += milliseconds(20)) // two fifths of a processor
        one_job(lanes, "drags", 0.008, now);
    EXPECT_EQ(lanes.push(
                  "drags", [] {}, now),
              Lane::Upper);
    EXPECT_FALSE(lanes.pop_light(now));
    lanes.push(
        "light", [] {}, now);
    EXPECT_EQ(lanes.pop_light(now)->session, "light");
    EXPECT_EQ(lanes.pop(Lane::Upper, now)->session, "drags");
}

TEST(QuickLanes, LosesNoJobAndHoldsItsBoundsUnderRandomUse) {
    std::mt19937 random(11);
    constexpr std::size_t upper = 3;
    QuickLanes lanes(upper);
    QuickLanes::Time now{};
    std::map<std::string, int> held; ///< waiting or running in the upper lane
    std::vector<std::pair<Lane, std::string>> running;
    std::size_t pushed = 0, popped = 0, ran = 0;
    for (int step = 0; step < 20'000; ++step, now += milliseconds(random() % 5)) {
        const std::string session(1, static_cast<char>('a' + random() % 5));
        const Lane lane = random() % 2 == 0 ? Lane::Upper : Lane::Lower;
        if (random() % 2 == 0) {
            ++pushed;
            if (lanes.push(
                    session, [&ran] { ++ran; }, now) == Lane::Upper)
                ++held[session];
        } else if (auto turn = lanes.pop(lane, now)) {
            ++popped;
            turn->job();
            running.emplace_back(lane, turn->session);
        }
        if (!running.empty() && random() % 2 == 0) {
            const auto [from, whose] = running.back();
            running.pop_back();
            lanes.done(from, whose, 0.001 * static_cast<double>(random() % 8), now);
            held[whose] -= from == Lane::Upper ? 1 : 0;
        }
        for (const auto& [name, count] : held)
            ASSERT_LE(count, upper - 1) << name;
        ASSERT_EQ(pushed, popped + lanes.waiting(Lane::Upper) + lanes.waiting(Lane::Lower));
        ASSERT_EQ(ran, popped);
    }
}

} // namespace wakesurf::server::quick_lanes_test
