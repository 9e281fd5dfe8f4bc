// When the allocator is asked to give freed memory back, and that it does.
#include "core/base/machine_memory.hpp"
#include "server/metrics/spare_heap.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace wakesurf::server {

namespace {

using namespace std::chrono_literals;

/// Asks four times a second.
struct Watch {
    HeapRest rest;
    HeapRest::Time now{1h};
    double processors = 0.0;

    /// How often it was due over so much time, with that part of a processor in use.
    int pass(std::chrono::milliseconds time, double share, bool computing = false) {
        int times = 0;
        for (const auto end = now + time; now < end;) {
            now += 250ms;
            processors += 0.25 * share;
            times += rest.due(processors, computing, now) ? 1 : 0;
        }
        return times;
    }
};

} // namespace

TEST(HeapRest, IsDueOnceAfterWorkHasRested) {
    Watch watch;
    EXPECT_EQ(watch.pass(60s, 1.5), 0) << "others would wait for the allocator";
    EXPECT_EQ(watch.pass(HeapRest::quiet_for, 0.001), 1);
    EXPECT_EQ(watch.pass(60s, 0.001), 0) << "nothing was freed since";
    EXPECT_EQ(watch.pass(2s, 1.0), 0);
    EXPECT_EQ(watch.pass(60s, 0.001), 1);
}

TEST(HeapRest, IsNotDueInAShortPause) {
    Watch watch;
    for (int edits = 0; edits < 100; ++edits) {
        EXPECT_EQ(watch.pass(1s, 0.5), 0);
        EXPECT_EQ(watch.pass(HeapRest::quiet_for - 1s, 0.001), 0);
    }
}

TEST(HeapRest, IsNotDueWhileOthersKeepTheProcessFromItsWork) {
    Watch watch;
    EXPECT_EQ(watch.pass(60s, 0.02, true), 0);
    EXPECT_EQ(watch.pass(60s, 0.001), 1);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(SpareHeap, GoesBackToTheSystemBetweenPiecesThatAreStillInUse) {
    make_allocator_frugal();
    constexpr std::size_t pieces = 64 << 10, piece = 1 << 10, mebi = 1 << 20;
    std::vector<std::unique_ptr<std::byte[]>> all(pieces);
    for (auto& each : all) {
        each = std::make_unique<std::byte[]>(piece);
        std::memset(each.get(), 1, piece);
    }
    for (std::size_t i = 0; i < pieces; ++i)
        if (i % 64 != 63)
            all[i].reset();
    const auto before = core::resident_memory();
    give_back_spare_heap();
    EXPECT_LT(core::resident_memory() + 48 * mebi, before) << "of 63 MiB that were freed";
}
#endif

} // namespace wakesurf::server
