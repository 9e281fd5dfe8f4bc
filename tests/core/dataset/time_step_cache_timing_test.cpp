// What the field pays at every step for a time-step that is in memory.
#include "core/dataset/time_step_cache.hpp"
#include "tests/support/gated_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

namespace wakesurf::core::time_step_cache_timing_test {

using tests::GatedSource;
using tests::step_bytes;

TEST(TimeStepCacheTiming, AResidentStepCostsLessThanAMicrosecond) {
    TimeStepCache cache(std::make_shared<GatedSource>(4), {4 * step_bytes, 1});
    const auto held = cache.acquire(0).value();
    constexpr int rounds = 100'000;
    double best = 1.0;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < rounds; ++i)
            (void)cache.acquire(0);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        best = std::min(best, took.count() / rounds);
    }
    std::printf("acquire of a resident time-step: %.0f ns\n", best * 1e9);
    EXPECT_LT(best, 1e-6);
}

} // namespace wakesurf::core::time_step_cache_timing_test
