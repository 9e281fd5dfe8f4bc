#include "core/dataset/time_step_cache.hpp"
#include "tests/support/gated_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <random>
#include <thread>

namespace wakesurf::core::time_step_cache_test {
namespace {

using tests::GatedSource;
using tests::step_bytes;

struct Bench {
    explicit Bench(std::size_t steps, std::size_t capacity, std::size_t threads = 1)
        : source(std::make_shared<GatedSource>(steps)),
          cache(source, {capacity * step_bytes, threads}) {}

    // Waits, without sleeping, until the cache's status says so.
    template <class Condition>
    void wait_until(Condition condition) {
        std::mutex mutex;
        std::condition_variable changed;
        bool dirty = true;
        cache.on_change([&] {
            const std::scoped_lock lock(mutex);
            dirty = true;
            changed.notify_all();
        });
        std::unique_lock lock(mutex);
        while (true) {
            changed.wait(lock, [&] { return dirty; });
            dirty = false;
            lock.unlock();
            if (condition(cache.status()))
                break;
            lock.lock();
        }
        cache.on_change({});
    }

    void wait_for_resident(std::vector<std::size_t> steps) {
        wait_until([&](const TimeStepCache::Status& status) {
            return std::all_of(steps.begin(), steps.end(), [&](std::size_t i) {
                return status.steps[i].state() == StepState::Resident;
            });
        });
    }

    std::shared_ptr<GatedSource> source;
    TimeStepCache cache;
};

TEST(TimeStepCache, HandsOutTheStepAskedFor) {
    Bench bench(10, 4);
    for (const std::size_t i : {3u, 0u, 9u, 3u}) {
        const auto step = bench.cache.acquire(i);
        ASSERT_TRUE(step.has_value());
        EXPECT_EQ((*step)->index, i);
        EXPECT_EQ((*step)->time, static_cast<double>(i));
    }
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{3, 0, 9}));
    EXPECT_EQ(bench.cache.acquire(10).error().code, Error::Code::InvalidArgument);
}

TEST(TimeStepCache, TwoCallersOfOneColdStepCauseOneLoad) {
    Bench bench(10, 4);
    bench.source->close();
    std::vector<std::shared_ptr<const TimeStep>> got(2);
    {
        std::jthread first([&] { got[0] = bench.cache.acquire(5).value(); });
        std::jthread second([&] { got[1] = bench.cache.acquire(5).value(); });
        bench.source->wait_for_loads(1);
        EXPECT_EQ(bench.cache.status().steps[5].state(), StepState::Loading);
        bench.source->open();
    }
    EXPECT_EQ(got[0].get(), got[1].get());
    EXPECT_EQ(bench.source->order().size(), 1u);
    const auto hits = bench.cache.status().hits;
    EXPECT_LE(hits, 1u) << "of a second caller who came when all was loaded";
    (void)bench.cache.acquire(5);
    EXPECT_EQ(bench.cache.status().hits, hits + 1);
    EXPECT_EQ(bench.cache.status().loads, 1u);
}

TEST(TimeStepCache, ShowsWhatIsColdLoadingAndResident) {
    Bench bench(3, 4);
    EXPECT_EQ(bench.cache.status().bytes, 0u);
    EXPECT_EQ(bench.cache.status().budget, 4 * step_bytes);
    (void)bench.cache.acquire(0);
    bench.source->close();
    std::jthread waiting([&] { (void)bench.cache.acquire(1); });
    bench.source->wait_for_loads(2);
    EXPECT_EQ(bench.cache.status().steps,
              (std::vector{StepHeld{step_bytes, 0}, StepHeld{0, step_bytes}, StepHeld{}}));
    EXPECT_EQ(bench.cache.status().step_bytes, step_bytes);
    EXPECT_EQ(bench.cache.status().bytes, 2 * step_bytes);
    bench.source->open();
}

TEST(TimeStepCache, HoldsAtLeastFourSteps) {
    Bench bench(10, 0);
    EXPECT_EQ(bench.cache.status().budget, 4 * step_bytes);
    for (const std::size_t i : {0u, 1u, 2u, 3u, 0u, 1u, 2u, 3u})
        ASSERT_TRUE(bench.cache.acquire(i).has_value());
    EXPECT_EQ(bench.source->order().size(), 4u);
    EXPECT_EQ(TimeStepCache::smallest_budget(*bench.source), 4 * step_bytes);
    EXPECT_EQ(TimeStepCache::smallest_budget(GatedSource(2)), 2 * step_bytes);
}

TEST(TimeStepCache, EvictsTheLeastRecentlyUsedStep) {
    Bench bench(10, 4);
    for (const std::size_t i : {0u, 1u, 2u, 3u, 0u, 4u}) // 4 takes the place of 1
        ASSERT_TRUE(bench.cache.acquire(i).has_value());
    const auto status = bench.cache.status();
    EXPECT_EQ(status.steps[1].state(), StepState::Cold);
    for (const std::size_t i : {0u, 2u, 3u, 4u})
        EXPECT_EQ(status.steps[i].state(), StepState::Resident) << i;
}

TEST(TimeStepCache, KeepsStepsInUseWhateverComes) {
    Bench bench(20, 4);
    const auto held = bench.cache.acquire(0).value();
    for (std::size_t i = 1; i < 20; ++i)
        ASSERT_TRUE(bench.cache.acquire(i).has_value());
    EXPECT_EQ(bench.cache.acquire(0).value().get(), held.get());
    EXPECT_EQ(bench.source->most_alive(), 4u);
}

TEST(TimeStepCache, LoadsAheadNearestFirstInTheDirectionOfPlay) {
    Bench bench(20, 5);
    (void)bench.cache.acquire(10);
    bench.cache.prefetch(10, -1);
    bench.wait_for_resident({9, 8, 7, 6});
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{10, 9, 8, 7, 6}));
    bench.cache.prefetch(10, +1); // the window turns round: what is behind makes room
    bench.wait_for_resident({10, 11, 12, 13, 14});
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{10, 9, 8, 7, 6, 11, 12, 13, 14}));
}

TEST(TimeStepCache, PlaysManyStepsAnIntervalWithOneLoadATimeStep) {
    constexpr std::size_t count = 30;
    for (const int direction : {+1, -1})
        for (const std::size_t capacity : {4u, 5u, 7u}) {
            Bench bench(count, capacity);
            for (std::size_t n = 0; n + 1 < count; ++n) {
                const std::size_t k = direction > 0 ? n : count - 2 - n;
                for (int step = 0; step < 5; ++step) {
                    const auto low = bench.cache.acquire(k).value();
                    const auto high = bench.cache.acquire(k + 1).value();
                    bench.cache.prefetch(direction > 0 ? k + 1 : k, direction, 1);
                }
                std::vector<std::size_t> ahead{k, k + 1};
                for (std::size_t i = 1; i + 2 <= capacity; ++i)
                    if (const std::size_t next = direction > 0 ? k + 1 + i : k - i; next < count)
                        ahead.push_back(next);
                bench.wait_for_resident(ahead);
            }
            EXPECT_EQ(bench.source->order().size(), count) << capacity << " " << direction;
            EXPECT_LE(bench.source->most_alive(), capacity);
        }
}

TEST(TimeStepCache, LoadsAheadUpToTheEndsOfTheSeries) {
    Bench bench(6, 100);
    bench.cache.prefetch(4, +1);
    bench.wait_for_resident({5});
    bench.cache.prefetch(1, -1);
    bench.wait_for_resident({0});
    bench.cache.prefetch(0, -1);
    bench.cache.prefetch(99, +1);
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{5, 0}));
}

TEST(TimeStepCache, DoesNotLoadAheadWhatIsNotWrittenYet) {
    Bench bench(10, 100);
    bench.source->ready_steps = 3;
    bench.cache.prefetch(0, +1);
    bench.wait_for_resident({1, 2});
    bench.source->ready_steps = 4;
    bench.cache.prefetch(0, +1);
    bench.wait_for_resident({3});
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{1, 2, 3}));
}

TEST(TimeStepCache, SomebodyWhoWaitsGoesBeforeLoadsAhead) {
    Bench bench(20, 10);
    bench.source->close();
    bench.cache.prefetch(0, +1);
    bench.source->wait_for_loads(1); // step 1, held at the gate, must make way
    std::jthread waiting([&] { (void)bench.cache.acquire(15); });
    bench.source->wait_for_loads(2);
    EXPECT_EQ(bench.source->order(), (std::vector<std::size_t>{1, 15}));
    bench.source->open();
    bench.wait_for_resident({1, 2, 3, 15});
}

TEST(TimeStepCache, RecoversAfterAnError) {
    Bench bench(10, 4);
    bench.source->failing = true;
    const auto failed = bench.cache.acquire(2);
    ASSERT_FALSE(failed.has_value());
    EXPECT_EQ(failed.error().message, "the disk is on fire");
    EXPECT_EQ(bench.cache.status().bytes, 0u);
    bench.source->failing = false;
    EXPECT_TRUE(bench.cache.acquire(2).has_value());
}

TEST(TimeStepCache, CancellationEndsTheWaitButNotTheLoad) {
    Bench bench(10, 4);
    bench.source->close();
    std::stop_source stop;
    Result<std::shared_ptr<const TimeStep>> got;
    {
        std::jthread waiting([&] { got = bench.cache.acquire(2, stop.get_token()); });
        bench.source->wait_for_loads(1);
        stop.request_stop();
    }
    EXPECT_EQ(got.error().code, Error::Code::Cancelled);
    bench.source->open();
    bench.wait_for_resident({2}); // so that a stream of cancelled edits does not starve
}

TEST(TimeStepCache, WaitsForRoomWhileOthersHoldEverything) {
    Bench bench(10, 4);
    std::vector<std::shared_ptr<const TimeStep>> held;
    for (std::size_t i = 0; i < 4; ++i)
        held.push_back(bench.cache.acquire(i).value());
    Result<std::shared_ptr<const TimeStep>> got;
    std::atomic<bool> done{false};
    std::jthread waiting([&] {
        got = bench.cache.acquire(7);
        done = true;
    });
    EXPECT_FALSE(done);
    held.pop_back();
    waiting.join();
    ASSERT_TRUE(got.has_value());
    EXPECT_EQ((*got)->index, 7u);
    EXPECT_EQ(bench.source->most_alive(), 4u);
}

TEST(TimeStepCache, TwoCallersWhoHoldEverythingBetweenThemMakeProgress) {
    Bench bench(100, 4);
    std::atomic<int> refused{0};
    const auto walk = [&](std::size_t start) {
        std::shared_ptr<const TimeStep> a = bench.cache.acquire(start).value();
        std::shared_ptr<const TimeStep> b = bench.cache.acquire(start + 1).value();
        for (std::size_t i = start + 2; i < start + 5; ++i) {
            auto next = bench.cache.acquire(i); // the third while two are held
            if (!next) {
                ASSERT_EQ(next.error().code, Error::Code::OverLimit);
                ++refused;
                a.reset();
                b.reset();
                next = bench.cache.acquire(i);
            }
            ASSERT_TRUE(next.has_value());
            a = std::move(b);
            b = std::move(*next);
        }
    };
    {
        std::jthread one([&] { walk(0); });
        std::jthread two([&] { walk(50); });
    }
    EXPECT_LE(bench.source->most_alive(), 4u);
    EXPECT_LE(refused, 6);
}

TEST(TimeStepCache, ACallerMayHoldThreeStepsWhileItAcquiresAFourth) {
    Bench bench(10, 4);
    std::vector<std::shared_ptr<const TimeStep>> window;
    for (std::size_t i = 0; i < 10; ++i) {
        if (window.size() == 4)
            window.erase(window.begin());
        window.push_back(bench.cache.acquire(i, {}, window.size()).value());
    }
    EXPECT_EQ(bench.source->most_alive(), 4u);
    EXPECT_EQ(bench.source->order().size(), 10u);
}

TEST(TimeStepCache, TwoCallersOfFourStepsEachAreRefusedOrServedButNeverStuck) {
    Bench bench(100, 4);
    const auto walk = [&](std::size_t start) {
        std::vector<std::shared_ptr<const TimeStep>> window;
        for (std::size_t i = start; i < start + 8;) {
            auto next = bench.cache.acquire(i, {}, window.size());
            if (!next) {
                ASSERT_EQ(next.error().code, Error::Code::OverLimit);
                window.clear();
                continue;
            }
            window.push_back(std::move(*next));
            if (window.size() == 4)
                window.clear();
            ++i;
        }
    };
    {
        std::jthread one([&] { walk(0); });
        std::jthread two([&] { walk(50); });
    }
    EXPECT_LE(bench.source->most_alive(), 4u);
}

TEST(TimeStepCache, NeverExceedsItsBudgetUnderRandomUse) {
    constexpr std::size_t capacity = 6;
    constexpr std::size_t steps = 40;
    Bench bench(steps, capacity, 2);
    const auto use = [&](unsigned seed) {
        std::mt19937 random(seed);
        std::shared_ptr<const TimeStep> held;
        for (int i = 0; i < 3000; ++i) {
            const std::size_t index = random() % steps;
            auto step = bench.cache.acquire(index);
            ASSERT_TRUE(step.has_value()) << step.error().message;
            ASSERT_EQ((*step)->index, index);
            held = std::move(*step);
            if (random() % 4 == 0)
                bench.cache.prefetch(index, random() % 2 == 0 ? 1 : -1);
            ASSERT_LE(bench.cache.status().bytes, bench.cache.status().budget);
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned seed = 1; seed <= 3; ++seed)
            threads.emplace_back(use, seed);
    }
    EXPECT_EQ(bench.source->most_alive(), capacity);
}

TEST(TimeStepCache, AStepOutlivesItsCacheAloneOfAll) {
    const auto source = std::make_shared<GatedSource>(3);
    std::shared_ptr<const TimeStep> step;
    {
        TimeStepCache cache(source, {});
        (void)cache.acquire(0);
        step = cache.acquire(1).value();
        EXPECT_EQ(source->alive(), 2u);
    }
    EXPECT_EQ(step->velocity().size(), 16u);
    EXPECT_EQ(source->alive(), 1u);
    step.reset();
    EXPECT_EQ(source->alive(), 0u);
}

TEST(TimeStepCache, EndsTheLoadThatIsRunningWhenItGoes) {
    const auto source = std::make_shared<GatedSource>(10);
    source->close();
    {
        TimeStepCache cache(source, {4 * step_bytes, 1});
        cache.prefetch(0, +1);
        source->wait_for_loads(1);
        EXPECT_EQ(source->alive(), 1u);
    }
    EXPECT_EQ(source->alive(), 0u); // though the gate never opened
    EXPECT_EQ(source->order().size(), 1u);
}

} // namespace
} // namespace wakesurf::core::time_step_cache_test
