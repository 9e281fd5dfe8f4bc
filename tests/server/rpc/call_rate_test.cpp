#include "server/limits.hpp"
#include "server/rpc/call_rate.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

using std::chrono::milliseconds;

namespace {

/// How many of `calls`, one every `gap`, are let through.
int let_through(CallRate& rate, bool edits, int calls, milliseconds gap, CallRate::Time& now) {
    int through = 0;
    for (int i = 0; i < calls; ++i, now += gap)
        through += rate.take(edits, now) ? 0 : 1;
    return through;
}

} // namespace

TEST(CallRate, GrantsABurstOfEditsAndThenSoManyASecond) {
    CallRate rate;
    CallRate::Time now{};
    EXPECT_EQ(let_through(rate, true, 1000, milliseconds(0), now), limits::edits_at_once);
    EXPECT_NEAR(let_through(rate, true, 10'000, milliseconds(1), now),
                10 * limits::edits_per_second, 1);
    now += std::chrono::hours(1);
    EXPECT_EQ(let_through(rate, true, 1000, milliseconds(0), now), limits::edits_at_once);
}

TEST(CallRate, NeverHoldsUpADragOfThirtyEditsASecond) {
    CallRate rate;
    CallRate::Time now{};
    EXPECT_EQ(let_through(rate, true, 1800, milliseconds(33), now), 1800);
}

TEST(CallRate, LetsReadersReadWhenEditsAreUsedUp) {
    CallRate rate;
    CallRate::Time now{};
    let_through(rate, true, 1000, milliseconds(0), now);
    EXPECT_FALSE(rate.take(false, now));
    let_through(rate, false, 10'000, milliseconds(0), now);
    EXPECT_TRUE(rate.take(false, now)) << "which has its bound as well";
}

TEST(CallRate, SaysHowLongToWaitAndKeepsItsWord) {
    CallRate rate;
    CallRate::Time now{};
    let_through(rate, true, 400, milliseconds(0), now);
    const auto wait = rate.take(true, now);
    ASSERT_TRUE(wait);
    EXPECT_EQ(*wait, milliseconds(5));
    EXPECT_TRUE(rate.take(true, now + *wait - milliseconds(1)));
    EXPECT_FALSE(rate.take(true, now + *wait));
}

} // namespace wakesurf::server
