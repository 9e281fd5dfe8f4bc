#include "core/dataset/brick_table.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::retired_slots_test {

TEST(RetiredSlots, AreFreeOnceAllReadingsThatBeganBeforeHaveEnded) {
    RetiredSlots retired;
    std::vector<std::size_t> free;
    const auto first = retired.begin_reading();
    const auto second = retired.begin_reading();
    retired.next_epoch();
    retired.retire(7);
    const auto later = retired.begin_reading();
    retired.reclaim(free);
    EXPECT_TRUE(free.empty());
    retired.end_reading(first);
    retired.reclaim(free);
    EXPECT_TRUE(free.empty());
    retired.end_reading(second);
    retired.reclaim(free);
    EXPECT_EQ(free, std::vector<std::size_t>{7});
    EXPECT_TRUE(retired.being_read());
    retired.end_reading(later);
    EXPECT_FALSE(retired.being_read());
}

} // namespace wakesurf::core::retired_slots_test
