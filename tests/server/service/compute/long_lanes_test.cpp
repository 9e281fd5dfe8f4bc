// Who gets the threads that are kept for light sessions, by hand.
#include "server/service/compute/long_lanes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::server::long_lanes_test {

namespace {

using Lane = LongLanes::Lane;
using std::chrono::milliseconds;

const LongLanes::Time start = LongLanes::Time{} + std::chrono::hours(1);

std::string next(LongLanes& lanes, Lane lane, LongLanes::Time now) {
    const bool ready = lanes.ready(lane, now);
    const auto turn = lanes.pop(lane, now);
    EXPECT_EQ(ready, turn.has_value());
    return turn ? turn->session : "";
}

} // namespace

TEST(LongLanes, KeepThreadsForSessionsThatHaveTakenLittle) {
    LongLanes lanes;
    lanes.push("heavy", [] {});
    EXPECT_EQ(next(lanes, Lane::Any, start), "heavy");
    lanes.done("heavy", 3.0, start); // of the last 4 s
    lanes.push("heavy", [] {});
    lanes.push("light", [] {});
    EXPECT_EQ(next(lanes, Lane::Light, start), "light");
    EXPECT_EQ(next(lanes, Lane::Light, start), "") << "heavy has its turn on the other threads";
    EXPECT_EQ(next(lanes, Lane::Any, start), "heavy");
}

TEST(LongLanes, ForgetWhatASessionTookLongAgo) {
    LongLanes lanes;
    lanes.push("rested", [] {});
    next(lanes, Lane::Any, start);
    lanes.done("rested", 4.0, start);
    lanes.push("rested", [] {});
    EXPECT_EQ(next(lanes, Lane::Light, start + milliseconds(100)), "");
    EXPECT_EQ(next(lanes, Lane::Light, start + LongLanes::memory), "rested");
}

TEST(LongLanes, DoNotLetNewSessionsKeepTheNextOneWaiting) {
    LongLanes lanes;
    for (const char* session : {"new 1", "new 2", "new 3"})
        lanes.push(session, [] {});
    EXPECT_EQ(next(lanes, Lane::Light, start), "new 1");
    EXPECT_EQ(next(lanes, Lane::Light, start), "new 2");
    EXPECT_EQ(next(lanes, Lane::Light, start), "") << "two are not settled yet";
    EXPECT_EQ(next(lanes, Lane::Light, start + LongLanes::settling), "new 3")
        << "they turned out to be long, and no longer count";
    lanes.push("light", [] {});
    EXPECT_EQ(next(lanes, Lane::Light, start + LongLanes::settling), "light");
}

TEST(LongLanes, TakeJobsOfNoSessionOnlyInTheirTurn) {
    LongLanes lanes;
    lanes.push_lone([] {});
    EXPECT_EQ(next(lanes, Lane::Light, start), "");
    const std::string lone = next(lanes, Lane::Any, start);
    EXPECT_NE(lone, "");
    lanes.done(lone, 1.0, start);
    EXPECT_EQ(lanes.waiting(), 0U);
}

} // namespace wakesurf::server::long_lanes_test
