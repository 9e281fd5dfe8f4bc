#include "core/base/memory_account.hpp"
#include "core/base/work_memory.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::core::memory_account_test {

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20;
constexpr auto most = std::numeric_limits<std::size_t>::max();

/// Something that can be had again.
class Kept {
  public:
    Kept(const MemoryAccount& account,
         ReclaimOrder order,
         std::size_t bytes,
         std::vector<ReclaimOrder>& asked)
        : share_(account.open(MemoryUse::Downloads)) {
        share_.set(bytes);
        ticket_ = account.on_need(order, [this, order, &asked](std::size_t) {
            asked.push_back(order);
            share_.shrink_to(0);
        });
    }

    std::size_t bytes() const { return share_.bytes(); }

  private:
    MemoryAccount::Share share_;
    std::shared_ptr<void> ticket_;
};

} // namespace

TEST(MemoryAccount, KnowsWhatIsTakenForWhatAndWhatIsFree) {
    const MemoryAccount account(10 * mebi);
    auto steps = account.open(MemoryUse::TimeSteps);
    auto build = account.open(MemoryUse::Builds);
    EXPECT_TRUE(steps.grow_to(4 * mebi));
    EXPECT_TRUE(build.grow_to(6 * mebi));
    EXPECT_EQ(account.free(), 0U);
    build.shrink_to(mebi);
    EXPECT_EQ(account.used(MemoryUse::TimeSteps), 4 * mebi);
    EXPECT_EQ(account.used(MemoryUse::Builds), mebi);
    EXPECT_EQ(account.used(), 5 * mebi);
    EXPECT_EQ(account.free(), 5 * mebi);
}

TEST(MemoryAccount, AShareThatDoesNotFitStaysAsItWas) {
    const MemoryAccount account(10 * mebi);
    auto share = account.open(MemoryUse::Builds);
    ASSERT_TRUE(share.grow_to(8 * mebi));
    EXPECT_FALSE(share.grow_to(11 * mebi));
    EXPECT_EQ(share.bytes(), 8 * mebi);
    EXPECT_EQ(account.used(), 8 * mebi);
    EXPECT_EQ(account.refused(), 1U);
    EXPECT_TRUE(share.grow_to(10 * mebi)) << "to the last byte";
}

TEST(MemoryAccount, NumbersAMillionTimesTooLargeDoNotWrapRound) {
    const MemoryAccount account(10 * mebi);
    auto one = account.open(MemoryUse::Builds), other = account.open(MemoryUse::Rings);
    ASSERT_TRUE(one.grow_to(mebi));
    EXPECT_FALSE(other.grow_to(most));
    EXPECT_FALSE(other.grow_to(most - mebi + 1));
    EXPECT_EQ(account.used(), mebi);

    const MemoryAccount none(0);
    auto nothing = none.open(MemoryUse::Builds);
    EXPECT_TRUE(nothing.grow_to(0));
    EXPECT_FALSE(nothing.grow_to(1));

    const MemoryAccount endless(most);
    auto large = endless.open(MemoryUse::Builds), more = endless.open(MemoryUse::Builds);
    EXPECT_TRUE(large.grow_to(most - 1));
    EXPECT_TRUE(more.grow_to(1));
    EXPECT_FALSE(more.grow_to(2));
}

TEST(MemoryAccount, AShareThatEndsOrMovesGivesBackOnce) {
    const MemoryAccount account(10 * mebi);
    {
        auto share = account.open(MemoryUse::Builds);
        ASSERT_TRUE(share.grow_to(mebi));
        const auto moved = std::move(share);
        EXPECT_EQ(moved.bytes(), mebi);
        EXPECT_EQ(account.used(), mebi);
    }
    EXPECT_EQ(account.used(), 0U);
}

TEST(MemoryAccount, AShareTakesOverAnotherForItsOwnUse) {
    const MemoryAccount account(10 * mebi);
    auto kept = account.open(MemoryUse::Surfaces);
    auto build = account.open(MemoryUse::Builds);
    ASSERT_TRUE(build.grow_to(4 * mebi));
    kept.join(std::move(build));
    EXPECT_EQ(kept.bytes(), 4 * mebi);
    EXPECT_EQ(account.used(MemoryUse::Builds), 0U);
    EXPECT_EQ(account.used(MemoryUse::Surfaces), 4 * mebi);
}

TEST(MemoryAccount, WhatHasBeenTakenAlreadyCountsEvenWhereItDoesNotFit) {
    const MemoryAccount account(10 * mebi);
    auto seen = account.open(MemoryUse::Other);
    seen.set(12 * mebi);
    EXPECT_EQ(account.free(), 0U);
    auto share = account.open(MemoryUse::Builds);
    EXPECT_FALSE(share.grow_to(1));
    seen.set(9 * mebi);
    EXPECT_TRUE(share.grow_to(mebi));
}

TEST(MemoryAccount, AsksBackInItsOrderAndNoMoreThanIsNeeded) {
    const MemoryAccount account(10 * mebi);
    std::vector<ReclaimOrder> asked;
    const Kept surfaces(account, ReclaimOrder::Surfaces, 2 * mebi, asked);
    const Kept downloads(account, ReclaimOrder::Downloads, 2 * mebi, asked);
    const Kept histories(account, ReclaimOrder::Histories, 2 * mebi, asked);
    const Kept steps(account, ReclaimOrder::TimeSteps, 2 * mebi, asked);
    const Kept heap(account, ReclaimOrder::SpareHeap, 2 * mebi, asked);
    auto share = account.open(MemoryUse::Builds);
    EXPECT_TRUE(share.grow_to(3 * mebi));
    EXPECT_EQ(asked, (std::vector{ReclaimOrder::SpareHeap, ReclaimOrder::Downloads}));
    asked.clear();
    EXPECT_TRUE(share.grow_to(9 * mebi));
    EXPECT_EQ(asked, (std::vector{ReclaimOrder::SpareHeap, ReclaimOrder::Downloads,
                                  ReclaimOrder::Histories, ReclaimOrder::TimeSteps,
                                  ReclaimOrder::Surfaces}));
    EXPECT_EQ(surfaces.bytes(), 0U);
}

TEST(MemoryAccount, WithinWhatIsFreeNobodyIsAsked) {
    const MemoryAccount account(10 * mebi);
    std::vector<ReclaimOrder> asked;
    const Kept downloads(account, ReclaimOrder::Downloads, 8 * mebi, asked);
    auto share = account.open(MemoryUse::TimeSteps);
    EXPECT_TRUE(share.grow_within_free(2 * mebi));
    EXPECT_FALSE(share.grow_within_free(3 * mebi));
    EXPECT_TRUE(asked.empty());
}

TEST(MemoryAccount, SeesWhatTheProcessHoldsBeyondItsShares) {
    const MemoryAccount account(10 * mebi);
    auto steps = account.open(MemoryUse::TimeSteps), importer = account.open(MemoryUse::Importers);
    ASSERT_TRUE(steps.grow_to(2 * mebi));
    ASSERT_TRUE(importer.grow_to(mebi));
    std::size_t resident = 5 * mebi;
    account.watch([&] { return resident; });
    EXPECT_EQ(account.used(MemoryUse::Other), 3 * mebi) << "importers are other processes";
    EXPECT_EQ(account.free(), 4 * mebi);
    ASSERT_TRUE(steps.grow_to(5 * mebi));
    account.measure();
    EXPECT_EQ(account.used(MemoryUse::Other), 3 * mebi)
        << "what was taken a moment ago is not touched yet, but the program is there";
    resident = 9 * mebi;
    EXPECT_FALSE(steps.grow_to(6 * mebi)) << "looked again, since more was taken";
    EXPECT_EQ(account.used(MemoryUse::Other), 4 * mebi);
}

TEST(MemoryAccount, SeesWhatIsHeldWhileAnotherThreadIsSetAsideInItsLook) {
    const MemoryAccount account(10 * mebi);
    std::atomic<std::size_t> resident{5 * mebi};
    std::atomic<bool> is_in{false}, go_on{false};
    const auto here = std::this_thread::get_id();
    account.watch([&] {
        const std::size_t seen = resident;
        if (std::this_thread::get_id() != here)
            is_in = true;
        while (std::this_thread::get_id() != here && !go_on)
            std::this_thread::yield();
        return seen;
    });
    auto steps = account.open(MemoryUse::TimeSteps);
    std::jthread set_aside([&] { account.measure(); });
    while (!is_in)
        std::this_thread::yield();
    resident = 9 * mebi;
    EXPECT_FALSE(steps.grow_to(2 * mebi));
    go_on = true;
    set_aside.join();
    EXPECT_EQ(account.used(MemoryUse::Other), 9 * mebi) << "an older look replaces no newer one";
}

TEST(MemoryAccount, WorkThatNeedsMuchLeavesTheLastPartToWhatNeedsLittle) {
    const MemoryAccount account(64 * mebi);
    std::stop_source none;
    none.request_stop(); // no one waits here
    WorkMemory much(account, none.get_token());
    std::size_t taken = 0;
    while (much.grow(mebi / 4))
        taken += mebi / 4;
    EXPECT_LE(taken, account.budget() - account.reserved_for_small());
    EXPECT_GE(taken, account.budget() - 2 * account.reserved_for_small());
    WorkMemory little(account, none.get_token());
    EXPECT_TRUE(little.grow(account.small() - mebi / 4));
}

TEST(MemoryAccount, LargeWorkGivesWayToSmallWorkAndSaysSo) {
    const MemoryAccount account(64 * mebi);
    auto held = account.open(MemoryUse::Meshes);
    const std::chrono::milliseconds soon(50);
    std::optional<WorkMemory> first(account);
    WorkMemory second(account, {}, soon), little(account);
    ASSERT_TRUE(first->grow(16 * mebi));
    ASSERT_TRUE(second.grow(16 * mebi));
    held.set(32 * mebi); // nothing is free
    EXPECT_FALSE(second.grow(4 * mebi)) << "for large work no other ends";
    EXPECT_TRUE(first->grow(1));
    std::string why;
    std::jthread works([&first, &why](const std::stop_token& stop) {
        while (!stop.stop_requested() && first->grow(0)) {
        }
        if (!first->grow(1))
            why = first->refusal().message;
        first.reset();
    });
    EXPECT_TRUE(little.grow(mebi));
    works.request_stop();
    works.join();
    EXPECT_NE(why.find("smaller surfaces take precedence"), std::string::npos) << why;
}

TEST(MemoryAccount, WorkThatIsRefusedOnceSaysSoAndEndsForAllThreads) {
    const MemoryAccount account(mebi);
    auto held = account.open(MemoryUse::Meshes);
    ASSERT_TRUE(held.grow_to(mebi));
    WorkMemory work(account);
    EXPECT_FALSE(work.grow(2 * mebi));
    EXPECT_TRUE(work.exhausted());
    EXPECT_FALSE(work.grow(1));
    EXPECT_EQ(work.refusal().limit, mebi);
    EXPECT_EQ(account.used(), mebi);
}

TEST(MemoryAccount, WorkThatAsksForMoreThanCanBeCountedIsRefused) {
    const MemoryAccount account(mebi);
    WorkMemory work(account);
    EXPECT_TRUE(work.grow(mebi / 2));
    EXPECT_FALSE(work.grow(most)) << "does not wrap round";
}

TEST(MemoryAccount, WhoHasEndedIsNotAsked) {
    const MemoryAccount account(mebi);
    std::vector<ReclaimOrder> asked;
    { const Kept gone(account, ReclaimOrder::Downloads, mebi, asked); }
    auto share = account.open(MemoryUse::Builds);
    EXPECT_TRUE(share.grow_to(mebi));
    EXPECT_FALSE(share.grow_to(2 * mebi));
    EXPECT_TRUE(asked.empty());
}

TEST(MemoryAccount, WhoWaitsGetsWhatAnotherThreadGivesBack) {
    const MemoryAccount account(10 * mebi);
    auto held = account.open(MemoryUse::Surfaces);
    ASSERT_TRUE(held.grow_to(10 * mebi));
    std::jthread later;
    const auto ticket = account.on_need(ReclaimOrder::Surfaces, [&](std::size_t) {
        if (!later.joinable())
            later = std::jthread([&] { held.shrink_to(0); });
    });
    auto share = account.open(MemoryUse::Builds);
    EXPECT_TRUE(share.grow_to(10 * mebi, {}, std::chrono::minutes(1)));
}

TEST(MemoryAccount, WhoWaitsIsToldAtOnceThatItCanNeverFitOrThatNobodyWantsIt) {
    const MemoryAccount account(mebi);
    auto held = account.open(MemoryUse::Meshes), share = account.open(MemoryUse::Builds);
    EXPECT_FALSE(share.grow_to(2 * mebi, {}, std::chrono::hours(1)));
    ASSERT_TRUE(held.grow_to(mebi));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(share.grow_to(mebi, stop.get_token(), std::chrono::hours(1)));
}

TEST(MemoryAccount, ManyThreadsNeverTakeMoreThanThereIs) {
    constexpr std::size_t budget = 1000;
    const MemoryAccount account(budget);
    std::atomic<std::size_t> taken{0}, highest{0};
    {
        std::vector<std::jthread> threads;
        for (unsigned t = 0; t < 8; ++t)
            threads.emplace_back([&, t] {
                auto share = account.open(MemoryUse::Builds);
                for (std::size_t i = 0; i < 20'000; ++i) {
                    const std::size_t want = 1 + (i * 7919 + t * 104729) % 400;
                    if (!share.grow_to(want))
                        continue;
                    const std::size_t now = taken += share.bytes();
                    for (std::size_t seen = highest;
                         seen < now && !highest.compare_exchange_weak(seen, now);) {
                    }
                    taken -= share.bytes();
                    share.shrink_to(0);
                }
            });
    }
    EXPECT_LE(highest, budget);
    EXPECT_EQ(account.used(), 0U);
}

TEST(MemoryAccount, ARefusalNamesTheLimitWhatWasWantedWhatIsFreeAndACure) {
    const MemoryAccount account(300 * mebi);
    auto share = account.open(MemoryUse::Surfaces);
    ASSERT_TRUE(share.grow_to(250 * mebi));
    const Error error = account.refusal("a surface of 4000000 quads", 1800 * mebi);
    EXPECT_EQ(error.code, Error::Code::OverLimit);
    EXPECT_EQ(error.limit, 300 * mebi);
    EXPECT_EQ(error.message,
              "a surface of 4000000 quads needs 1800 MiB of memory, but of the 300 MiB of "
              "--memory only 12.5 MiB are free for it")
        << "an eighth is kept for small work";
    EXPECT_EQ(account.refusal("a file", 2 * mebi).message,
              "a file needs 2.0 MiB of memory, but of the 300 MiB of --memory only 50.0 MiB are "
              "free for it");
    EXPECT_NE(error.hint.find("--memory"), std::string::npos);
}

} // namespace wakesurf::core::memory_account_test
