// Turns between sessions, by hand.
#include "server/live/compute/fair_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::server::fair_queue_test {

namespace {

using Takes = FairQueue::Takes;
using std::chrono::milliseconds;

constexpr auto no_limit = std::numeric_limits<std::size_t>::max();
const FairQueue::Time start = FairQueue::Time{} + std::chrono::hours(1);

/// Light sessions have used less than half a thread over the last second, less where more than two are busy.
FairQueue::Rules rules(std::size_t at_once = no_limit, std::size_t light_at_once = no_limit) {
    return {at_once, light_at_once, 0.5, 0.05, milliseconds(1000)};
}

std::string next(FairQueue& queue, Takes which, FairQueue::Time now = start) {
    const auto turn = queue.pop(which, now);
    return turn ? turn->session : "";
}

/// Lets a session run a job that uses so many seconds.
void use(FairQueue& queue, const std::string& session, double seconds, FairQueue::Time now) {
    queue.push(session, [] {});
    EXPECT_EQ(next(queue, Takes::Any, now), session);
    queue.done(session, seconds, now);
}

/// The sessions in the order of their turns, each job done at once.
std::vector<std::string> turns(FairQueue& queue) {
    std::vector<std::string> order;
    while (const auto turn = queue.pop(Takes::Any, start)) {
        turn->job();
        order.push_back(turn->session);
        queue.done(turn->session, 0.0, start);
    }
    return order;
}

} // namespace

TEST(FairQueue, GivesSessionsTurnsHoweverManyJobsOneHas) {
    FairQueue queue(rules());
    std::vector<int> ran;
    for (int i = 0; i < 4; ++i)
        queue.push("heavy", [&ran, i] { ran.push_back(i); });
    queue.push("light", [&ran] { ran.push_back(100); });
    EXPECT_EQ(turns(queue),
              (std::vector<std::string>{"heavy", "light", "heavy", "heavy", "heavy"}));
    EXPECT_EQ(ran, (std::vector<int>{0, 100, 1, 2, 3})) << "within a session the oldest first";
}

TEST(FairQueue, HoldsASessionsNextLongJobUntilTheOneBeforeIsDone) {
    FairQueue queue(rules(1));
    queue.push("a", [] {});
    queue.push("a", [] {});
    queue.push("b", [] {});
    EXPECT_EQ(next(queue, Takes::Any), "a");
    EXPECT_EQ(next(queue, Takes::Any), "b");
    EXPECT_EQ(next(queue, Takes::Any), "") << "a's first still runs";
    EXPECT_EQ(queue.waiting(), 1U);
    queue.done("a", 0.0, start);
    EXPECT_EQ(next(queue, Takes::Any), "a");
    EXPECT_EQ(queue.waiting(), 0U);
}

TEST(FairQueue, LetsTheLightSessionThatHasUsedLeastGoFirst) {
    FairQueue queue(rules());
    use(queue, "drags", 0.02, start);
    queue.push("drags", [] {});
    queue.push("light", [] {});
    EXPECT_EQ(next(queue, Takes::Light), "light");
    EXPECT_EQ(next(queue, Takes::Light), "drags");
}

TEST(FairQueue, DoesNotTakeASessionForLightUntilWhatItHasUsedIsLongAgo) {
    FairQueue queue(rules());
    use(queue, "heavy", 1.0, start);
    queue.push("heavy", [] {});
    queue.push("light", [] {});
    EXPECT_EQ(next(queue, Takes::NotLight), "heavy");
    EXPECT_EQ(next(queue, Takes::NotLight), "") << "light is left for its own threads";
    queue.done("heavy", 0.0, start);
    queue.push("heavy", [] {});
    EXPECT_EQ(next(queue, Takes::Light), "light");
    EXPECT_EQ(next(queue, Takes::Light), "");
    EXPECT_EQ(next(queue, Takes::Light, start + milliseconds(1000)), "heavy");
}

TEST(FairQueue, DoesNotTakeASessionForLightWhileAsManyOfItsJobsRunAsMay) {
    FairQueue queue(rules(no_limit, 2));
    for (int i = 0; i < 4; ++i)
        queue.push("crowd", [] {});
    queue.push("light", [] {});
    EXPECT_EQ(next(queue, Takes::Light), "crowd");
    EXPECT_EQ(next(queue, Takes::Light), "light");
    EXPECT_EQ(next(queue, Takes::Light), "crowd");
    EXPECT_EQ(next(queue, Takes::Light), "");
    EXPECT_EQ(next(queue, Takes::NotLight), "crowd");
    queue.done("crowd", 0.0, start);
    queue.done("crowd", 0.0, start);
    EXPECT_EQ(next(queue, Takes::Light), "crowd");
}

TEST(FairQueue, DividesTheLightShareAmongManyBusySessionsSoThatTheyLeaveRoom) {
    FairQueue queue(rules());
    const auto busy = [](int i) { return "busy " + std::to_string(i); };
    for (int i = 0; i < 6; ++i) // each a quarter: less than it may have alone
        use(queue, busy(i), 0.25, start);
    for (int i = 0; i < 6; ++i)
        queue.push(busy(i), [] {});
    EXPECT_EQ(next(queue, Takes::Light), "");
    queue.push("light", [] {});
    EXPECT_EQ(next(queue, Takes::Light), "light");
}

TEST(FairQueue, LosesNoJobUnderRandomUse) {
    std::mt19937 random(11);
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{3}, no_limit}) {
        FairQueue queue(rules(at_once, 2));
        FairQueue::Time now = start;
        std::map<std::string, std::size_t> running;
        std::size_t pushed = 0, popped = 0, ran = 0;
        for (int step = 0; step < 20'000; ++step, now += milliseconds(random() % 5)) {
            const std::string session(1, static_cast<char>('a' + random() % 5));
            if (random() % 2 == 0) {
                ++pushed;
                queue.push(session, [&ran] { ++ran; });
            } else if (auto turn = queue.pop(static_cast<Takes>(random() % 3), now)) {
                ++popped;
                turn->job();
                ASSERT_LE(++running[turn->session], at_once);
            }
            if (running[session] > 0 && random() % 2 == 0) {
                --running[session];
                queue.done(session, 0.001 * static_cast<double>(random() % 8), now);
            }
            ASSERT_EQ(pushed, popped + queue.waiting());
            ASSERT_EQ(ran, popped);
        }
        for (auto& [session, jobs] : running)
            for (; jobs > 0; --jobs)
                queue.done(session, 0.0, now);
        popped += turns(queue).size();
        EXPECT_EQ(popped, pushed);
    }
}

TEST(FairQueue, LetsNoSessionWaitLongerThanOneTurnOfEachOther) {
    std::mt19937 random(7);
    for (const bool one_a_session : {false, true}) {
        FairQueue queue(rules(one_a_session ? 1 : no_limit));
        std::vector<std::string> running;
        std::map<std::string, std::size_t> waiting, passed;
        for (int step = 0; step < 20'000; ++step) {
            const std::string session(1, static_cast<char>('a' + random() % 6));
            if (random() % 2 == 0) {
                queue.push(session, [] {});
                if (waiting[session]++ == 0)
                    passed[session] = 0;
            } else if (const auto turn = queue.pop(Takes::Any, start)) {
                --waiting[turn->session];
                passed[turn->session] = 0;
                running.push_back(turn->session);
                const auto blocked = [&](const std::string& each) {
                    return one_a_session &&
                           std::find(running.begin(), running.end(), each) != running.end();
                };
                for (auto& [other, jobs] : waiting)
                    if (other != turn->session && jobs > 0 && !blocked(other)) {
                        ASSERT_LE(++passed[other], 5U) << other;
                    } else if (blocked(other)) {
                        passed[other] = 0;
                    }
            }
            if (!running.empty() && random() % 3 == 0) {
                queue.done(running.back(), 0.0, start);
                running.pop_back();
            }
        }
    }
}

} // namespace wakesurf::server::fair_queue_test
