// A cache that shares an account of memory with others.
#include "core/dataset/time_step_cache.hpp"
#include "tests/support/gated_source.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stop_token>
#include <thread>
#include <vector>

namespace wakesurf::core::counted_cache_test {

using tests::GatedSource;
using tests::step_bytes;

TEST(CountedTimeStepCache, TakesWhatOthersLeaveAndGivesItBackDownToFourSteps) {
    const MemoryAccount account(32 * step_bytes);
    const auto source = std::make_shared<GatedSource>(100);
    TimeStepCache cache(source, {0, 1, account});
    EXPECT_EQ(account.used(MemoryUse::TimeSteps), 4 * step_bytes) << "taken at once";
    for (std::size_t i = 0; i < 100; ++i)
        ASSERT_TRUE(cache.acquire(i));
    EXPECT_EQ(account.used(MemoryUse::TimeSteps), 28 * step_bytes) << "an eighth stays free";
    EXPECT_EQ(source->alive(), 28u);

    auto others = account.open(MemoryUse::Builds);
    ASSERT_TRUE(others.grow_to(20 * step_bytes));
    EXPECT_EQ(source->alive(), 12u);
    ASSERT_TRUE(others.grow_to(28 * step_bytes));
    EXPECT_FALSE(others.grow_to(29 * step_bytes)) << "never below its smallest";
    EXPECT_EQ(source->alive(), 4u);
    for (std::size_t i = 0; i < 100; ++i)
        ASSERT_TRUE(cache.acquire(i));
    EXPECT_EQ(source->alive(), 4u);

    others.shrink_to(0);
    for (std::size_t i = 0; i < 100; ++i)
        ASSERT_TRUE(cache.acquire(i));
    EXPECT_EQ(source->alive(), 28u);
    EXPECT_LE(cache.status().bytes, cache.status().budget);
}

TEST(CountedTimeStepCache, GivesBackNoStepThatSomebodyHolds) {
    const MemoryAccount account(32 * step_bytes);
    const auto source = std::make_shared<GatedSource>(100);
    TimeStepCache cache(source, {0, 1, account});
    std::vector<std::shared_ptr<const TimeStep>> held;
    for (std::size_t i = 0; i < 10; ++i)
        held.push_back(*cache.acquire(i));
    auto others = account.open(MemoryUse::Builds);
    EXPECT_FALSE(others.grow_to(23 * step_bytes));
    EXPECT_TRUE(others.grow_to(22 * step_bytes));
    for (std::size_t i = 0; i < 10; ++i)
        EXPECT_EQ(held[i]->index, i);
}

TEST(CountedTimeStepCache, WhoWaitsForAStepHasOthersGiveBackMemory) {
    const MemoryAccount account(32 * step_bytes);
    TimeStepCache cache(std::make_shared<GatedSource>(100), {0, 1, account});
    auto kept = account.open(MemoryUse::Downloads);
    ASSERT_TRUE(kept.grow_to(28 * step_bytes));
    const auto ticket =
        account.on_need(ReclaimOrder::Downloads, [&](std::size_t) { kept.shrink_to(0); });
    std::vector<std::shared_ptr<const TimeStep>> held;
    for (std::size_t i = 0; i < 6; ++i) // two more than there is room for
        held.push_back(*cache.acquire(i));
    EXPECT_EQ(kept.bytes(), 0u);
}

TEST(CountedTimeStepCache, WhoWaitsForAStepAsksOthersTenTimesASecondHoweverManyComeAndGoMeanwhile) {
    const MemoryAccount account(32 * step_bytes);
    TimeStepCache cache(std::make_shared<GatedSource>(100), {0, 1, account});
    auto kept = account.open(MemoryUse::Builds);
    ASSERT_TRUE(kept.grow_to(28 * step_bytes));
    std::atomic<int> asked{0};
    const auto ticket = account.on_need(ReclaimOrder::Histories, [&](std::size_t) { ++asked; });
    std::vector<std::shared_ptr<const TimeStep>> held;
    for (std::size_t i = 0; i < 4; ++i)
        held.push_back(*cache.acquire(i));
    std::stop_source gone, enough;
    gone.request_stop();
    const auto begin = std::chrono::steady_clock::now();
    auto waiting =
        std::async(std::launch::async, [&] { return cache.acquire(4, enough.get_token()); });
    while (asked == 0)
        std::this_thread::yield();
    for (int i = 0; i < 20'000; ++i)
        (void)cache.acquire(5, gone.get_token()); // comes, and goes at once
    enough.request_stop();
    EXPECT_FALSE(waiting.get());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LE(asked, 10.0 * took.count() + 2.0);
}

} // namespace wakesurf::core::counted_cache_test
