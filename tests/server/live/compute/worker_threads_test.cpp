// Jobs of one priority class on threads: who waits for one that takes longer than expected, and which threads light sessions have.
#include "server/live/compute/worker_threads.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <future>
#include <limits>
#include <string>
#include <thread>

namespace wakesurf::server::worker_threads_test {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds patience{20};

/// Two permits for light sessions, which have had less than half a processor of the last quarter of a second, and two for any.
WorkerThreads::Rules rules() {
    return {.queue = {.at_once = std::numeric_limits<std::size_t>::max(),
                      .light_at_once = 1,
                      .light_share = 0.5,
                      .busy = 0.05,
                      .memory = milliseconds(250)},
            .light = {2, 34, 0, patience},
            .any = {2, 34, crowd_niceness, patience},
            .loop_threads = 1,
            .charge_processor = true};
}

int own_niceness() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(own_thread_id()));
}

/// Runs a job that keeps its thread until `released`.
void hold(WorkerThreads& threads, const std::string& session, std::shared_future<void> released) {
    threads.run(session, [released = std::move(released)] { released.wait(); });
}

} // namespace

TEST(WorkerThreads, TakeMoreJobsWhileEachOfTheirsTakesLong) {
    WorkerThreads threads(rules());
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 4; ++i) // as many as there are permits, of sessions of their own
        hold(threads, "slow" + std::to_string(i), released);
    std::promise<int> light;
    threads.run("light", [&] { light.set_value(own_niceness()); });
    EXPECT_LE(light.get_future().get(), own_niceness() + crowd_niceness);
    release.set_value();
}

TEST(WorkerThreads, RunTheJobsOfALightSessionAtFullPriorityAndItsCrowdBelow) {
    WorkerThreads threads(rules());
    std::promise<void> release;
    const auto released = release.get_future().share();
    std::promise<int> first, second;
    threads.run("a", [&, released] {
        first.set_value(own_niceness());
        released.wait();
    });
    EXPECT_EQ(first.get_future().get(), own_niceness());
    threads.run("a", [&] { second.set_value(own_niceness()); });
    EXPECT_EQ(second.get_future().get(), own_niceness() + crowd_niceness)
        << "one of the session runs already";
    release.set_value();
}

TEST(WorkerThreads, StepBackWithAJobThatKeepsAProcessor) {
    const int here = own_niceness();
    WorkerThreads threads(rules());
    std::promise<int> niceness;
    threads.run("slow", [&] {
        while (own_niceness() == here) { // ends only when it has been lowered
        }
        niceness.set_value(own_niceness());
    });
    EXPECT_EQ(niceness.get_future().get(), here + long_niceness);
    std::promise<int> next;
    threads.run("light", [&] { next.set_value(own_niceness()); });
    EXPECT_EQ(next.get_future().get(), here) << "another thread has taken its place";
}

TEST(WorkerThreads, DoNotLowerAJobThatOnlyWaits) {
    const int here = own_niceness();
    WorkerThreads threads(rules());
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
            std::this_thread::sleep_for(patience / 2);
            done.set_value();
        });
        done.get_future().wait();
    }
    release.set_value();
    EXPECT_EQ(niceness.get_future().get(), here);
}

TEST(WorkerThreads, KeepTheirPermitsWhereNoMoreThreadsMayBeStarted) {
    auto few = rules();
    few.light = {1, 1, 0, patience};
    few.any = {1, 3, 0, patience};
    WorkerThreads threads(few);
    std::promise<void> release;
    const auto released = release.get_future().share();
    std::atomic<int> running{0};
    for (int i = 0; i < 8; ++i)
        threads.run("slow" + std::to_string(i), [&, released] {
            ++running;
            released.wait();
        });
    while (running < 4)
        std::this_thread::yield();
    std::this_thread::sleep_for(2 * patience);
    EXPECT_EQ(running, 4) << "one light thread and three for any session";
    release.set_value();
}

TEST(WorkerThreads, RunEachJobBeforeTheyEndAlsoThoseThatJobsQueue) {
    std::atomic<int> ran{0};
    {
        WorkerThreads threads(rules());
        for (int i = 0; i < 300; ++i)
            threads.run("session" + std::to_string(i % 7), [&, i] {
                ++ran;
                threads.run("session" + std::to_string(i % 5), [&] { ++ran; });
            });
    }
    EXPECT_EQ(ran, 600);
}

} // namespace wakesurf::server::worker_threads_test
