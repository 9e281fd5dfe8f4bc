// The pool's own threads: who waits for whom, and at which priority.
#include "core/base/blocking_wait.hpp"
#include "server/live/compute/compute_pool.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <string>

namespace wakesurf::server::compute_pool_test {

namespace {

int own_priority() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
}

} // namespace

TEST(ComputePool, RunsQuickJobsWhileEveryLongThreadIsBusy) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 20; ++i)
        pool.run("heavy" + std::to_string(i), PriorityClass::Long, [released] { released.wait(); });
    std::promise<int> quick;
    pool.run("light", PriorityClass::Quick, [&] { quick.set_value(own_priority()); });
    EXPECT_EQ(quick.get_future().get(), own_priority());
    release.set_value();
}

TEST(ComputePool, RunsAQuickJobOfOneSessionWhileAnotherHasMoreOfThemThanThreads) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 64; ++i)
        pool.run("heavy", PriorityClass::Quick, [released] { released.wait(); });
    std::promise<int> quick;
    pool.run("light", PriorityClass::Quick, [&] { quick.set_value(own_priority()); });
    EXPECT_EQ(quick.get_future().get(), own_priority());
    release.set_value();
}

TEST(ComputePool, RunsALongJobWhileAsManySessionsAsThereAreThreadsWaitForData) {
    ComputePool pool(2);
    std::promise<void> arrive;
    const auto arrived = arrive.get_future().share();
    for (int i = 0; i < 40; ++i)
        pool.run("cold" + std::to_string(i), PriorityClass::Long, [arrived] {
            const core::BlockingWait blocked;
            arrived.wait();
        });
    std::promise<void> warm;
    pool.run("warm", PriorityClass::Long, [&] { warm.set_value(); });
    EXPECT_EQ(warm.get_future().wait_for(std::chrono::minutes(2)), std::future_status::ready);
    arrive.set_value();
}

TEST(ComputePool, RunsALongJobWhileMoreOfOthersThanThereArePermitsRunForLong) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 20; ++i)
        pool.run("heavy" + std::to_string(i), PriorityClass::Long, [released] { released.wait(); });
    std::promise<void> other;
    pool.run("light", PriorityClass::Long, [&] { other.set_value(); });
    EXPECT_EQ(other.get_future().wait_for(std::chrono::minutes(2)), std::future_status::ready);
    release.set_value();
}

TEST(ComputePool, RunsLongJobsOfSeveralSessionsAtATimeAndOneOfEach) {
    ComputePool pool(2);
    std::atomic<int> running{0}, most{0};
    std::promise<void> both;
    for (int i = 0; i < 8; ++i)
        pool.run("a", PriorityClass::Long, [&] {
            most = std::max(most.load(), ++running);
            --running;
        });
    std::promise<void> a_waits, b_waits;
    pool.run("a", PriorityClass::Long, [&, other = b_waits.get_future().share()] {
        a_waits.set_value();
        other.wait();
    });
    pool.run("b", PriorityClass::Long, [&, other = a_waits.get_future().share()] {
        b_waits.set_value();
        other.wait();
        both.set_value();
    });
    both.get_future().wait(); // each waited for the other to run as well
    EXPECT_EQ(most, 1);
}

TEST(ComputePool, RunsLongJobsAtALowerPriority) {
    ComputePool pool(2);
    std::promise<int> priority;
    pool.run("a", PriorityClass::Long, [&] { priority.set_value(own_priority()); });
    EXPECT_GT(priority.get_future().get(), own_priority());
}

TEST(ComputePool, RunsJobsByHandInTheOrderOfTurns) {
    ComputePool pool{ComputePool::ByHand{}};
    std::string order;
    for (const char job : {'1', '2'})
        pool.run("a", PriorityClass::Long, [&order, job] { order += job; });
    pool.run("b", PriorityClass::Long, [&order] { order += 'b'; });
    pool.run("b", PriorityClass::Quick, [&order] { order += 'q'; });
    pool.run([&order] { order += 'l'; });
    while (pool.turn()) {
    }
    EXPECT_EQ(order, "q1bl2");
}

} // namespace wakesurf::server::compute_pool_test
