// That the allocator gives freed memory back.
#include "core/base/machine_memory.hpp"
#include "server/base/process_account.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace wakesurf::server::spare_heap_test {

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(SpareHeap, GoesBackToTheSystemBetweenPiecesThatAreStillInUse) {
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

} // namespace wakesurf::server::spare_heap_test
