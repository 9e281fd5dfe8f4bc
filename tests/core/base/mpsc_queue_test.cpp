#include "core/base/mpsc_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace wakesurf::core::mpsc_queue_test {

TEST(MpscQueue, ReturnsWhatWasLeftInTheOrderItWasLeft) {
    MpscQueue<int> box;
    EXPECT_TRUE(box.empty());
    for (int i = 0; i < 5; ++i)
        box.push(i);
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.take(), (std::vector{0, 1, 2, 3, 4}));
    EXPECT_TRUE(box.take().empty());
}

TEST(MpscQueue, FreesWhatNoOneTook) {
    const auto thing = std::make_shared<int>(1);
    {
        MpscQueue<std::shared_ptr<int>> box;
        box.push(thing);
        box.push(thing);
        EXPECT_EQ(thing.use_count(), 3);
    }
    EXPECT_EQ(thing.use_count(), 1);
}

TEST(MpscQueue, LosesNothingThatManyThreadsLeaveWhileOthersTake) {
    constexpr int threads = 4, each = 5'000;
    MpscQueue<std::pair<int, int>> box;
    std::vector<std::vector<std::pair<int, int>>> taken(2);
    {
        std::vector<std::jthread> takers, leavers;
        for (auto& all : taken)
            takers.emplace_back([&](const std::stop_token& stop) {
                for (bool last = false; !last;) {
                    last = stop.stop_requested();
                    for (const auto& item : box.take())
                        all.push_back(item);
                }
            });
        for (int t = 0; t < threads; ++t)
            leavers.emplace_back([&box, t] {
                for (int i = 0; i < each; ++i)
                    box.push({t, i});
            });
        leavers.clear();
    }
    std::vector<std::vector<bool>> seen(threads, std::vector<bool>(each, false));
    for (const auto& all : taken) {
        std::vector<int> last(threads, -1);
        for (const auto& [thread, i] : all) {
            EXPECT_FALSE(seen[static_cast<std::size_t>(thread)][static_cast<std::size_t>(i)]);
            seen[static_cast<std::size_t>(thread)][static_cast<std::size_t>(i)] = true;
            EXPECT_GT(i, last[static_cast<std::size_t>(thread)]) << "each thread's in its order";
            last[static_cast<std::size_t>(thread)] = i;
        }
    }
    for (const auto& of_thread : seen)
        EXPECT_EQ(std::count(of_thread.begin(), of_thread.end(), false), 0);
}

} // namespace wakesurf::core::mpsc_queue_test
