// Jobs that were expected to be quick and are not: who waits for them.
#include "server/service/compute/quick_threads.hpp"
#include "server/service/compute/thread_priority.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <future>
#include <string>
#include <thread>

namespace wakesurf::server::quick_threads_test {

namespace {

int own_niceness() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(own_thread_id()));
}

} // namespace

TEST(QuickThreads, TakeMoreJobsWhileEveryOneOfTheirsTakesLong) {
    QuickThreads threads(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 4; ++i) // as many as there are threads, of sessions of their own
        threads.run("slow" + std::to_string(i), [released] { released.wait(); });
    std::promise<int> light;
    threads.run("light", [&] { light.set_value(own_niceness()); });
    EXPECT_EQ(light.get_future().get(), own_niceness()) << "at full priority";
    release.set_value();
}

TEST(QuickThreads, StepBackWithAJobThatKeepsAProcessor) {
    const int here = own_niceness();
    QuickThreads threads(2);
    std::promise<int> niceness;
    threads.run("slow", [&] {
        while (own_niceness() == here) { // ends only when it has been lowered
        }
        niceness.set_value(own_niceness());
    });
    EXPECT_EQ(niceness.get_future().get(), here + long_niceness);
}

TEST(QuickThreads, DoNotLowerAJobThatOnlyWaits) {
    const int here = own_niceness();
    QuickThreads threads(2);
    std::promise<void> release;
    std::promise<int> niceness;
    threads.run("waits", [&, released = release.get_future().share()] {
        released.wait();
        niceness.set_value(own_niceness());
    });
    // Several jobs of others, each long enough for the first to be looked at again.
    for (int i = 0; i < 4; ++i) {
        std::promise<void> done;
        threads.run("other" + std::to_string(i), [&] {
            std::this_thread::sleep_for(QuickThreads::patience / 2);
            done.set_value();
        });
        done.get_future().wait();
    }
    release.set_value();
    EXPECT_EQ(niceness.get_future().get(), here);
}

TEST(QuickThreads, RunEveryJobBeforeTheyEnd) {
    std::atomic<int> ran{0};
    {
        QuickThreads threads(2);
        for (int i = 0; i < 300; ++i)
            threads.run("session" + std::to_string(i % 7), [&] { ++ran; });
    }
    EXPECT_EQ(ran, 300);
}

} // namespace wakesurf::server::quick_threads_test
