#include "core/base/worker_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <latch>
#include <vector>

namespace wakesurf::core::worker_threads_test {

TEST(WorkerThreads, WorkAtTheSameTimeAsManyAsThereMayBe) {
    std::latch together(3); // opens only when three are at work at once
    std::atomic<int> done{0};
    {
        WorkerThreads threads(3);
        threads.add({3, [&](bool) {
                         together.arrive_and_wait();
                         ++done;
                     }});
        together.wait();
    }
    EXPECT_EQ(done, 3);
}

TEST(WorkerThreads, TakeWhatCameFirst) {
    std::vector<int> order;
    std::latch begun(1);
    std::latch added(1);
    std::latch finished(1);
    WorkerThreads threads(1);
    threads.add({[&](bool) {
        begun.count_down();
        added.wait();
    }});
    begun.wait();
    for (int i = 0; i < 5; ++i)
        threads.add({[&, i](bool) { order.push_back(i); }});
    threads.add({[&](bool) { finished.count_down(); }});
    added.count_down();
    finished.wait();
    EXPECT_EQ(order, (std::vector{0, 1, 2, 3, 4}));
}

TEST(WorkerThreads, FinishWhatIsAddedWhileTheyEndAndTellItSo) {
    std::atomic<int> ended{0};
    {
        std::function<void(bool)> again; // is called while the threads end
        WorkerThreads threads(2);
        again = [&](bool ending) {
            if (ending)
                ++ended;
            else
                threads.add({again});
        };
        threads.add({again, again, again});
    }
    EXPECT_EQ(ended, 3);
}

} // namespace wakesurf::core::worker_threads_test
