// Chunks within a budget.
#include "server/remote/zarr/chunk_cache.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <thread>

namespace wakesurf::server::chunk_cache_test {

namespace {

constexpr std::size_t bytes = 1000;

/// Fetches a chunk of that many bytes, and counts.
struct Fetched {
    ChunkCache& cache;
    std::atomic<int> times{0};

    core::Result<void> get(
        std::uint64_t chunk, const ChunkCache::Use& use = [](auto) {}) {
        return cache.with({0, chunk}, 2 * bytes,
                          [&]() -> core::Result<ChunkCache::Bytes> {
                              ++times;
                              return ChunkCache::Bytes(bytes, static_cast<std::byte>(chunk));
                          },
                          use, {});
    }
};

} // namespace

TEST(ChunkCache, KeepsWhatWasUsedLast) {
    ChunkCache cache(5 * bytes);
    Fetched fetched{cache};
    for (const std::uint64_t chunk : {1, 2, 1, 2, 1})
        ASSERT_TRUE(fetched.get(chunk));
    EXPECT_EQ(fetched.times, 2);
    for (const std::uint64_t chunk : {3, 1, 4, 1, 5, 1})
        ASSERT_TRUE(fetched.get(chunk));
    EXPECT_EQ(fetched.times, 5) << "1 stays, which is used again and again";
    EXPECT_LE(cache.bytes(), 5 * bytes);
}

TEST(ChunkCache, FetchesOnceForAllWhoWantAChunk) {
    ChunkCache cache(10 * bytes);
    std::latch all_there(4);
    std::atomic<int> fetches{0};
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            all_there.arrive_and_wait();
            const auto fetch = [&]() -> core::Result<ChunkCache::Bytes> {
                ++fetches;
                return ChunkCache::Bytes(bytes);
            };
            ASSERT_TRUE(cache.with({0, 7}, bytes, fetch, [](auto) {}, {}));
        });
    threads.clear();
    EXPECT_EQ(fetches, 1);
}

TEST(ChunkCache, LetsAnotherTryWhereOneFailed) {
    ChunkCache cache(10 * bytes);
    const auto fail = []() -> core::Result<ChunkCache::Bytes> {
        return core::fail(core::Error::Code::Io, "no");
    };
    EXPECT_EQ(cache.with({0, 1}, bytes, fail, [](auto) {}, {}).error().message, "no");
    EXPECT_EQ(cache.bytes(), 0u);
    Fetched fetched{cache};
    EXPECT_TRUE(fetched.get(1));
}

TEST(ChunkCache, WaitsForRoomThatOthersUse) {
    ChunkCache cache(3 * bytes);
    Fetched fetched{cache};
    std::latch used(1);
    std::latch go_on(1);
    std::jthread user([&] {
        ASSERT_TRUE(fetched.get(1, [&](auto) {
            used.count_down();
            go_on.wait();
        }));
    });
    used.wait();
    std::stop_source stop;
    stop.request_stop();
    const auto none = cache.with(
        {0, 2}, 2 * bytes + 900, {}, [](auto) {}, stop.get_token());
    EXPECT_EQ(none.error().code, core::Error::Code::Cancelled);
    std::jthread waiting([&] { ASSERT_TRUE(fetched.get(2)); });
    go_on.count_down();
    waiting.join();
    EXPECT_EQ(fetched.times, 2);
    EXPECT_LE(cache.bytes(), 3 * bytes);
}

} // namespace wakesurf::server::chunk_cache_test
