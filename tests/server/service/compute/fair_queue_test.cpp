// Turns between sessions, by hand.
#include "server/service/compute/fair_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::server::fair_queue_test {

namespace {

/// The sessions in the order of their turns, each job done at once.
std::vector<std::string> turns(FairQueue& queue) {
    std::vector<std::string> order;
    while (const auto turn = queue.pop()) {
        turn->job();
        order.push_back(turn->session);
        queue.done(turn->session);
    }
    return order;
}

} // namespace

TEST(FairQueue, GivesSessionsTurnsHoweverManyJobsOneHas) {
    FairQueue queue(false);
    std::vector<int> ran;
    for (int i = 0; i < 4; ++i)
        queue.push("heavy", [&ran, i] { ran.push_back(i); });
    queue.push("light", [&ran] { ran.push_back(100); });
    EXPECT_EQ(turns(queue),
              (std::vector<std::string>{"heavy", "light", "heavy", "heavy", "heavy"}));
    EXPECT_EQ(ran, (std::vector<int>{0, 100, 1, 2, 3})) << "within a session the oldest first";
}

TEST(FairQueue, HoldsASessionsNextLongJobUntilTheOneBeforeIsDone) {
    FairQueue queue(true);
    queue.push("a", [] {});
    queue.push("a", [] {});
    queue.push("b", [] {});
    EXPECT_EQ(queue.pop()->session, "a");
    EXPECT_EQ(queue.pop()->session, "b");
    EXPECT_FALSE(queue.pop()) << "a's first still runs";
    EXPECT_EQ(queue.waiting(), 1U);
    queue.done("a");
    EXPECT_EQ(queue.pop()->session, "a");
    EXPECT_EQ(queue.waiting(), 0U);
}

TEST(FairQueue, LetsNobodyWaitLongerThanOneTurnOfEachOther) {
    std::mt19937 random(7);
    for (const bool one_a_session : {false, true}) {
        FairQueue queue(one_a_session);
        std::vector<std::string> running;
        std::map<std::string, std::size_t> waiting, passed;
        for (int step = 0; step < 20'000; ++step) {
            const std::string session(1, static_cast<char>('a' + random() % 6));
            if (random() % 2 == 0) {
                queue.push(session, [] {});
                if (waiting[session]++ == 0)
                    passed[session] = 0;
            } else if (const auto turn = queue.pop()) {
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
                queue.done(running.back());
                running.pop_back();
            }
        }
    }
}

} // namespace wakesurf::server::fair_queue_test
