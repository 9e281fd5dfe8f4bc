// Turns between sessions, by hand.
#include "server/live/compute/fair_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::server::fair_queue_test {

namespace {

constexpr auto no_limit = std::numeric_limits<std::size_t>::max();

std::string next(FairQueue& queue) {
    const auto turn = queue.pop();
    return turn ? turn->session : "";
}

/// Lets the next job run for so many seconds. Returns its session.
std::string run(FairQueue& queue, double seconds) {
    const std::string session = next(queue);
    queue.done(session, seconds);
    return session;
}

/// The sessions in the order of their turns, each job done at once.
std::vector<std::string> turns(FairQueue& queue) {
    std::vector<std::string> order;
    while (const auto turn = queue.pop()) {
        turn->job();
        order.push_back(turn->session);
        queue.done(turn->session, 0.0);
    }
    return order;
}

} // namespace

TEST(FairQueue, GivesSessionsTurnsHoweverManyJobsOneHas) {
    FairQueue queue(no_limit);
    std::vector<int> ran;
    for (int i = 0; i < 4; ++i)
        queue.push("heavy", [&ran, i] { ran.push_back(i); });
    queue.push("light", [&ran] { ran.push_back(100); });
    EXPECT_EQ(turns(queue),
              (std::vector<std::string>{"heavy", "light", "heavy", "heavy", "heavy"}));
    EXPECT_EQ(ran, (std::vector<int>{0, 100, 1, 2, 3})) << "within a session the oldest first";
}

TEST(FairQueue, HoldsASessionsNextJobWhileAsManyOfItsRunAsMay) {
    FairQueue queue(1);
    queue.push("a", [] {});
    queue.push("a", [] {});
    queue.push("b", [] {});
    EXPECT_EQ(next(queue), "a");
    EXPECT_EQ(next(queue), "b");
    EXPECT_EQ(next(queue), "") << "a's first still runs";
    EXPECT_EQ(queue.waiting(), 1U);
    queue.done("a", 0.0);
    EXPECT_EQ(next(queue), "a");
    EXPECT_EQ(queue.waiting(), 0U);
}

TEST(FairQueue, DividesTheTimeEvenlyWhateverAJobOfEachTakes) {
    const std::map<std::string, double> takes{{"short", 0.001}, {"long", 0.007}, {"longer", 0.02}};
    FairQueue queue(no_limit);
    for (const auto& [session, seconds] : takes)
        for (int i = 0; i < 4'000; ++i)
            queue.push(session, [] {});
    std::map<std::string, double> served;
    for (double total = 0.0; total < 9.0;) {
        const auto turn = queue.pop();
        ASSERT_TRUE(turn);
        const double seconds = takes.at(turn->session);
        queue.done(turn->session, seconds);
        served[turn->session] += seconds;
        total += seconds;
        // Never more apart than the longest job.
        for (const auto& [session, each] : served)
            ASSERT_LE(std::abs(each - served.begin()->second), 0.02 + 1e-9) << session;
    }
}

TEST(FairQueue, LetsASessionThatUsesLittleGoBeforeThoseThatUseAllTheyCanGet) {
    FairQueue queue(no_limit);
    for (int i = 0; i < 6; ++i)
        for (int job = 0; job < 100; ++job)
            queue.push("busy " + std::to_string(i), [] {});
    for (int edit = 0; edit < 10; ++edit) {
        for (int i = 0; i < 12; ++i)
            run(queue, 0.02);
        queue.push("light", [] {});
        EXPECT_EQ(run(queue, 0.004), "light");
    }
}

TEST(FairQueue, ChargesASessionThatComesBackForWhatItUsedBefore) {
    FairQueue queue(no_limit);
    for (int i = 0; i < 3; ++i)
        queue.push("steady", [] {});
    queue.push("heavy", [] {});
    EXPECT_EQ(run(queue, 0.001), "steady");
    EXPECT_EQ(run(queue, 1.0), "heavy"); // it has no further job meanwhile
    queue.push("heavy", [] {});
    queue.push("light", [] {});
    EXPECT_EQ(run(queue, 0.001), "light");
    EXPECT_EQ(run(queue, 0.001), "steady");
    EXPECT_EQ(run(queue, 0.001), "steady");
    EXPECT_EQ(run(queue, 0.001), "heavy");
}

TEST(FairQueue, OwesASessionNothingForTheTimeThatItWasIdle) {
    FairQueue queue(no_limit);
    for (int i = 0; i < 400; ++i)
        queue.push("busy", [] {});
    for (int i = 0; i < 100; ++i)
        run(queue, 1.0);
    for (int i = 0; i < 100; ++i)
        queue.push("back", [] {});
    std::map<std::string, int> turns;
    for (int i = 0; i < 100; ++i)
        ++turns[run(queue, 1.0)];
    EXPECT_EQ(turns["back"], turns["busy"]);
}

TEST(FairQueue, ForgetsAllDebtsWhenNothingIsLeftToDo) {
    FairQueue queue(no_limit);
    queue.push("heavy", [] {});
    run(queue, 100.0);
    queue.push("heavy", [] {});
    queue.push("light", [] {});
    EXPECT_EQ(next(queue), "heavy") << "it came first";
}

TEST(FairQueue, LosesNoJobUnderRandomUse) {
    std::mt19937 random(11);
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{3}, no_limit}) {
        FairQueue queue(at_once);
        std::map<std::string, std::size_t> running;
        std::size_t pushed = 0, popped = 0, ran = 0;
        for (int step = 0; step < 20'000; ++step) {
            const std::string session(1, static_cast<char>('a' + random() % 5));
            if (random() % 2 == 0) {
                ++pushed;
                queue.push(session, [&ran] { ++ran; });
            } else if (auto turn = queue.pop()) {
                ++popped;
                turn->job();
                ASSERT_LE(++running[turn->session], at_once);
            }
            if (running[session] > 0 && random() % 2 == 0) {
                --running[session];
                queue.done(session, 0.001 * static_cast<double>(random() % 8));
            }
            ASSERT_EQ(pushed, popped + queue.waiting());
            ASSERT_EQ(ran, popped);
        }
        for (auto& [session, jobs] : running)
            for (; jobs > 0; --jobs)
                queue.done(session, 0.0);
        popped += turns(queue).size();
        EXPECT_EQ(popped, pushed);
    }
}

TEST(FairQueue, LetsNoSessionWaitLongerThanOneTurnOfEachOtherWhereAllJobsAreAlike) {
    std::mt19937 random(7);
    for (const bool one_a_session : {false, true}) {
        FairQueue queue(one_a_session ? 1 : no_limit);
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
                queue.done(running.back(), 0.0);
                running.pop_back();
            }
        }
    }
}

} // namespace wakesurf::server::fair_queue_test
