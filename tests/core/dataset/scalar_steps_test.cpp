#include "core/dataset/scalar_steps.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace wakesurf::core::scalar_steps_test {
namespace {

/// Counts what is read.
struct Reads {
    std::vector<std::pair<std::size_t, std::size_t>> made;

    ScalarSteps::Values get(ScalarSteps& steps, std::size_t scalar, std::size_t step) {
        return steps
            .get(scalar, step,
                 [&]() -> Result<Slab> {
                     made.emplace_back(scalar, step);
                     Slab slab(16);
                     slab.bytes()[0] = static_cast<std::byte>(10 * scalar + step);
                     return slab;
                 })
            .value();
    }
};

TEST(ScalarSteps, ReadsEachOnceWhileItIsAmongTheLast) {
    ScalarSteps steps(2);
    Reads reads;
    for (int i = 0; i < 3; ++i)
        for (const std::size_t step : {3u, 4u})
            EXPECT_EQ(static_cast<int>(reads.get(steps, 1, step)->bytes()[0]),
                      10 + static_cast<int>(step));
    EXPECT_EQ(reads.made.size(), 2u);
    reads.get(steps, 1, 3);
    reads.get(steps, 1, 5); // 4 was not asked for longest
    reads.get(steps, 1, 3);
    EXPECT_EQ(reads.made.size(), 3u);
    reads.get(steps, 1, 4);
    EXPECT_EQ(reads.made.back(), (std::pair<std::size_t, std::size_t>{1, 4}));
    EXPECT_EQ(static_cast<int>(reads.get(steps, 2, 4)->bytes()[0]), 24) << "another scalar's";
}

TEST(ScalarSteps, WhatIsInUseOutlivesItsPlaceAndAFailureTakesNone) {
    ScalarSteps steps(1);
    Reads reads;
    const auto held = reads.get(steps, 0, 1);
    const auto failed =
        steps.get(0, 2, []() -> Result<Slab> { return fail(Error::Code::Io, "no"); });
    EXPECT_EQ(failed.error().code, Error::Code::Io);
    reads.get(steps, 0, 3);
    EXPECT_EQ(static_cast<int>(held->bytes()[0]), 1);
    reads.get(steps, 0, 3);
    EXPECT_EQ(reads.made.size(), 2u);
}

} // namespace
} // namespace wakesurf::core::scalar_steps_test
