// Jobs of one priority class on threads: who waits for one that takes longer than expected.
#include "server/live/compute/worker_threads.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <future>
#include <string>
#include <thread>

namespace wakesurf::server::worker_threads_test {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds patience{20};

/// Three permits, of which one session has two at most.
WorkerThreads::Rules rules() {
    return {.permits = 3,
            .most_threads = 35,
            .one_a_session = false,
            .niceness = 0,
            .patience = patience,
            .loop_threads = 1};
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
    for (int i = 0; i < 4; ++i) // more than there are permits, of sessions of their own
        hold(threads, "slow" + std::to_string(i), released);
    std::promise<void> light;
    threads.run("light", [&] { light.set_value(); });
    light.get_future().wait();
    release.set_value();
}

TEST(WorkerThreads, RunTheNextJobOfASessionOnceOneHasReturnedItsPermitUnlessOneRunsAtATime) {
    for (const bool one_a_session : {false, true}) {
        auto these = rules();
        these.one_a_session = one_a_session;
        WorkerThreads threads(these);
        std::promise<void> release;
        const auto released = release.get_future().share();
        std::atomic<int> running{0};
        for (int i = 0; i < 6; ++i)
            threads.run("a", [&, released] {
                ++running;
                released.wait();
            });
        const int expected = one_a_session ? 1 : 6;
        while (running < expected)
            std::this_thread::yield();
        std::promise<void> other;
        threads.run("b", [&] { other.set_value(); });
        other.get_future().wait();
        EXPECT_EQ(running, expected);
        release.set_value();
    }
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
    few.most_threads = 4;
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
    EXPECT_EQ(running, 4);
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
