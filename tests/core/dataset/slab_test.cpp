#include "core/dataset/slab.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>

namespace wakesurf::core::slab_test {
namespace {

TEST(Slab, IsZeroedAndAlignedToHugePagesWhereItIsLarge) {
    for (const std::size_t bytes : {std::size_t{1}, std::size_t{4096}, std::size_t{5} << 20}) {
        const Slab slab(bytes);
        ASSERT_EQ(slab.bytes().size(), bytes);
        EXPECT_TRUE(std::all_of(slab.bytes().begin(), slab.bytes().end(),
                                [](std::byte b) { return b == std::byte{0}; }));
        const std::size_t alignment = bytes > (std::size_t{2} << 20) ? 2u << 20 : 1;
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(slab.bytes().data()) % alignment, 0u);
    }
}

TEST(Slab, LeavesReadableBytesBehindTheLastNode) {
    for (std::size_t bytes = 4096 - 70; bytes <= 4096 + 2; ++bytes) {
        const Slab slab(bytes);
        EXPECT_GE(slab.reserved(), bytes + 64);
        EXPECT_EQ(slab.reserved(), Slab::reservation(bytes));
        EXPECT_EQ(static_cast<int>(*(slab.bytes().data() + bytes + 63)), 0);
    }
}

TEST(Slab, MovesItsMemory) {
    Slab a(100);
    a.bytes()[7] = std::byte{42};
    Slab b(std::move(a));
    EXPECT_EQ(b.bytes()[7], std::byte{42});
    Slab c;
    c = std::move(b);
    EXPECT_EQ(c.bytes()[7], std::byte{42});
    EXPECT_EQ(c.bytes().size(), 100u);
}

TEST(Slab, ThrowsWhereThereIsNoSuchMemory) {
    EXPECT_THROW(Slab(std::numeric_limits<std::size_t>::max() - 100), std::bad_alloc);
    EXPECT_THROW(Slab(std::size_t{1} << 60), std::bad_alloc);
}

} // namespace
} // namespace wakesurf::core::slab_test
