#include "core/dataset/brick_cache.hpp"
#include "core/dataset/missing_bricks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <random>
#include <thread>

namespace wakesurf::core::brick_cache_test {

namespace {

/// Each brick has one value everywhere. Answers at once, or when told to.
class OneValueABrick final : public BrickSource {
  public:
    const BrickLayout& layout() const override { return layout_; }

    bool gaps(std::size_t) const override { return false; }

    static float value(std::size_t step, std::size_t brick) {
        return static_cast<float>(10'000 * step + brick);
    }

    void read(std::vector<BrickRead> reads, std::stop_token, Done done) const override {
        read_ += reads.size();
        const std::scoped_lock lock(mutex_);
        for (std::size_t i = 0; i < reads.size(); ++i)
            waiting_.push_back(
                {reads[i].step, reads[i].field,
                 [read = reads[i], done, i, this] {
                     if (read.brick == broken) {
                         done(i, fail(Error::Code::Corrupt, "brick " + std::to_string(read.brick)));
                         return;
                     }
                     std::fill(read.to.begin(), read.to.end(), value(read.step, read.brick));
                     done(i, {});
                 },
                 [done, i] { done(i, fail(Error::Code::Io, "the disk")); }});
        if (!patient)
            answer_all();
    }

    void answer() const {
        const std::scoped_lock lock(mutex_);
        answer_all();
    }

    std::size_t reads() const { return read_; }

    /// How many bricks of a time-step's velocity were asked for and have not come.
    std::size_t on_their_way(std::size_t step) const {
        const std::scoped_lock lock(mutex_);
        return static_cast<std::size_t>(
            std::count_if(waiting_.begin(), waiting_.end(), [&](const Waiting& each) {
                return each.step == step && each.field == 0;
            }));
    }

    /// Some of what is waited for, the last first; every one in `faulty` fails.
    void answer_some(std::size_t count, std::size_t faulty) const {
        const std::scoped_lock lock(mutex_);
        for (std::size_t i = 0; i < count && !waiting_.empty(); ++i) {
            const Waiting last = std::move(waiting_.back());
            waiting_.pop_back();
            if (i % faulty == 0)
                last.fail();
            else
                last.go();
        }
    }

    std::atomic<bool> patient{false};
    std::atomic<std::size_t> broken{~std::size_t{0}};

  private:
    struct Waiting {
        std::size_t step, field;
        std::function<void()> go, fail;
    };

    void answer_all() const {
        for (const Waiting& each : waiting_)
            each.go();
        waiting_.clear();
    }

    BrickLayout layout_{{65, 65, 65}, 4};
    mutable std::recursive_mutex mutex_;
    mutable std::vector<Waiting> waiting_;
    mutable std::atomic<std::size_t> read_{0};
};

std::vector<BrickName> names(std::size_t step, std::size_t first, std::size_t count) {
    std::vector<BrickName> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back({step, first + i});
    return all;
}

struct Bench {
    explicit Bench(std::size_t slots = 0)
        : cache(source, {BrickCache::smallest_budget(source.layout()) + slots * slot_bytes}) {}

    static constexpr std::size_t slot_bytes = (125 * 3 * sizeof(float) + 64 + 63) / 64 * 64;

    OneValueABrick source;
    BrickCache cache;
};

} // namespace

TEST(BrickCache, HasTheValuesOfTheBricksThatWereFetched) {
    Bench bench;
    const auto table = bench.cache.table(3);
    EXPECT_EQ(table->at(17), nullptr);
    ASSERT_TRUE(bench.cache.fetch(names(3, 10, 20), {}));
    for (std::size_t brick = 10; brick < 30; ++brick) {
        ASSERT_NE(table->at(brick), nullptr);
        EXPECT_EQ(*table->at(brick), OneValueABrick::value(3, brick));
    }
    EXPECT_EQ(bench.cache.held()[3].resident, 20u);
    EXPECT_EQ(table->at(30), nullptr);
}

TEST(BrickCache, StaysWithinItsBudgetWhateverIsAskedFor) {
    Bench bench(50);
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        const std::size_t step = random() % 20;
        const std::size_t first = random() % 4000;
        ASSERT_TRUE(bench.cache.fetch(names(step, first, 1 + random() % 64), {}));
        bench.cache.prefetch(names((step + 1) % 20, first, 30));
        const auto table = bench.cache.table(step);
        ASSERT_NE(table->at(first), nullptr) << "what was fetched last is there";
        ASSERT_EQ(*table->at(first), OneValueABrick::value(step, first));
        ASSERT_LE(bench.cache.status().bytes, bench.cache.status().budget);
    }
}

TEST(BrickCache, KeepsWhatIsUsedAndLetsGoWhatIsNot) {
    Bench bench;
    const auto table = bench.cache.table(0);
    const std::size_t slots = 2 * bench.cache.most_at_once();
    ASSERT_TRUE(bench.cache.fetch(names(0, 0, slots / 2), {}));
    for (std::size_t round = 1; round < 6; ++round) {
        ASSERT_TRUE(bench.cache.fetch(names(0, 1000 * round % 3900, slots / 4), {}));
        for (std::size_t brick = 0; brick < slots / 4; ++brick)
            if (table->at(brick) != nullptr)
                table->use(brick, bench.cache.age());
    }
    for (std::size_t brick = 0; brick < slots / 4; ++brick)
        EXPECT_NE(table->at(brick), nullptr) << brick;
    EXPECT_EQ(table->at(slots / 2 - 1), nullptr);
}

TEST(BrickCache, TakesNoMemoryAwayFromThoseWhoReadIt) {
    Bench bench;
    const auto table = bench.cache.table(0);
    const std::size_t many = bench.cache.most_at_once();
    ASSERT_TRUE(bench.cache.fetch(names(0, 0, many), {}));
    std::vector<const float*> seen;
    std::atomic<bool> fetched{false};
    std::jthread other;
    {
        const BrickCache::Reading reading(bench.cache);
        for (std::size_t brick = 0; brick < many; ++brick)
            seen.push_back(table->at(brick));
        other = std::jthread([&] {
            for (std::size_t round = 1; round < 20; ++round)
                ASSERT_TRUE(bench.cache.fetch(names(0, 100 * round, many), {}));
            fetched = true;
        });
        while (table->at(0) != nullptr) // until it has been evicted
            std::this_thread::yield();
        for (std::size_t brick = 0; brick < many; ++brick)
            EXPECT_EQ(*seen[brick], OneValueABrick::value(0, brick));
        EXPECT_FALSE(fetched);
    }
    other.join();
    EXPECT_TRUE(fetched);
}

TEST(BrickCache, TwoWhoMissTheSameBrickReadItOnce) {
    Bench bench;
    bench.source.patient = true;
    std::jthread first([&] { EXPECT_TRUE(bench.cache.fetch(names(0, 5, 3), {})); });
    while (bench.source.reads() < 3)
        std::this_thread::yield();
    std::jthread second([&] { EXPECT_TRUE(bench.cache.fetch(names(0, 5, 4), {})); });
    while (bench.source.reads() < 4)
        std::this_thread::yield();
    bench.source.answer();
    first.join();
    second.join();
    EXPECT_EQ(bench.source.reads(), 4u);
}

TEST(BrickCache, SaysWhichBrickCannotBeReadAndGoesOn) {
    Bench bench;
    bench.source.broken = 7;
    const auto refused = bench.cache.fetch(names(0, 5, 4), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "brick 7");
    EXPECT_NE(bench.cache.table(0)->at(8), nullptr) << "the others are there";
    bench.source.broken = ~std::size_t{0};
    EXPECT_TRUE(bench.cache.fetch(names(0, 5, 4), {})) << "it is read again";
}

TEST(BrickCache, LeavesAWaitThatIsCancelledAndKeepsWhatComesLater) {
    Bench bench;
    bench.source.patient = true;
    std::stop_source stop;
    std::jthread waiting([&] {
        const auto outcome = bench.cache.fetch(names(0, 5, 4), stop.get_token());
        ASSERT_FALSE(outcome);
        EXPECT_EQ(outcome.error().code, Error::Code::Cancelled);
    });
    while (bench.source.reads() < 4)
        std::this_thread::yield();
    stop.request_stop();
    waiting.join();
    bench.source.answer();
    EXPECT_NE(bench.cache.table(0)->at(5), nullptr);
}

TEST(BrickCache, ReadsAheadWithoutTakingRoomFromWhatIsInUse) {
    Bench bench;
    const std::size_t slots = 2 * bench.cache.most_at_once();
    ASSERT_TRUE(bench.cache.fetch(names(0, 0, slots / 2), {}));
    ASSERT_TRUE(bench.cache.fetch(names(0, slots / 2, slots / 2), {}));
    bench.cache.prefetch(names(1, 0, slots));
    EXPECT_EQ(bench.cache.held()[0].resident, slots);
    EXPECT_EQ(bench.cache.held()[1].resident, 0u);
}

TEST(BrickCache, StaysWithinItsBudgetWhileTheOldestTimeStepIsStillBeingRead) {
    Bench bench(64);
    bench.source.patient = true;
    bench.cache.prefetch(names(0, 0, 2));
    for (std::size_t step = 1; step <= 14; ++step) {
        bench.cache.prefetch(names(step, 0, 10));
        bench.source.answer_some(10, 100);
        EXPECT_LE(bench.cache.status().bytes, bench.cache.status().budget) << step;
    }
    EXPECT_EQ(bench.source.on_their_way(0), 2u);
    bench.source.answer();
    EXPECT_NE(bench.cache.table(0)->at(0), nullptr);
}

TEST(BrickCache, CountsWhatItHoldsOfEachTimeStepWhateverIsDone) {
    constexpr std::size_t steps = 4;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bench bench(50);
        bench.source.patient = true;
        std::mt19937 random(seed);
        std::vector<std::shared_ptr<const BrickTable>> tables;
        for (std::size_t step = 0; step < steps; ++step)
            tables.push_back(bench.cache.table(step));
        const auto check = [&](int operation) {
            auto held = bench.cache.held();
            for (std::size_t step = 0; step < steps; ++step) {
                std::size_t resident = 0;
                for (std::size_t brick = 0; brick < bench.cache.layout().count(); ++brick)
                    resident += tables[step]->at(brick) != nullptr ? 1 : 0;
                ASSERT_EQ(held[step].resident, resident) << operation;
                ASSERT_EQ(held[step].loading, bench.source.on_their_way(step)) << operation;
            }
        };
        for (int operation = 0; operation < 60; ++operation) {
            auto wanted = names(random() % steps, random() % 4000, 1 + random() % 40);
            for (BrickName& name : wanted)
                name.field = random() % 4 == 0 ? 1 : 0;
            switch (random() % 3) {
            case 0:
                bench.cache.prefetch(wanted);
                break;
            case 1:
                bench.source.answer_some(random() % 60, 5);
                break;
            case 2: // what is on its way comes, and takes the place of others
                bench.source.answer_some(1000, 1000);
                bench.source.patient = false;
                ASSERT_TRUE(bench.cache.fetch(wanted, {}));
                bench.source.patient = true;
                break;
            }
            check(operation);
        }
        bench.source.answer();
    }
}

TEST(BrickCache, TellsWhenWhatItHoldsChanges) {
    OneValueABrick source;
    std::atomic<int> told{0};
    BrickCache cache(source, {BrickCache::smallest_budget(source.layout()), {}, [&] { ++told; }});
    ASSERT_TRUE(cache.fetch(names(0, 0, 5), {}));
    const int first = told;
    EXPECT_GT(first, 0);
    ASSERT_TRUE(cache.fetch(names(0, 0, 5), {}));
    EXPECT_EQ(told, first) << "all of it was there";
    ASSERT_TRUE(cache.fetch(names(0, 3, 5), {}));
    EXPECT_GT(told, first) << "a larger part of the same time-step";
}

TEST(MissingBricks, AreFetchedInPartsWhereTheyDoNotFitTogether) {
    Bench bench;
    const auto cache = std::shared_ptr<BrickCache>(&bench.cache, [](BrickCache*) {});
    MissingBricks missing(cache, {0, 1});
    const auto first = cache->table(0), second = cache->table(1);
    std::vector<int> done(1000);
    std::size_t rounds = 0;
    const bool all =
        MissingBricks::in_rounds(&missing, done.size(), {}, MissingBricks::Again::Restart,
                                 [&](std::size_t begin, std::size_t end) {
                                     ++rounds;
                                     const BrickMisses misses(&missing);
                                     for (std::size_t item = begin; item < end; ++item)
                                         if (done[item] == 0 && first->at(3 * item) != nullptr &&
                                             second->at(3 * item) != nullptr)
                                             done[item] = 1;
                                         else if (done[item] == 0)
                                             misses.note(3 * item);
                                     return true;
                                 });
    EXPECT_TRUE(all);
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), 1000);
    EXPECT_LT(rounds, 200u);
}

TEST(MissingBricks, EndTheWorkWithTheErrorOfABrickThatCannotBeRead) {
    Bench bench;
    bench.source.broken = 3;
    MissingBricks missing(std::shared_ptr<BrickCache>(&bench.cache, [](BrickCache*) {}), {0});
    EXPECT_FALSE(MissingBricks::in_rounds(&missing, 10, {}, MissingBricks::Again::GoOn,
                                          [&](std::size_t, std::size_t) {
                                              BrickMisses(&missing).note(3);
                                              return true;
                                          }));
    ASSERT_TRUE(missing.error());
    EXPECT_EQ(missing.error()->message, "brick 3");
}

} // namespace wakesurf::core::brick_cache_test
