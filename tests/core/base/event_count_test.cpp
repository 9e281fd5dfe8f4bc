#include "core/base/event_count.hpp"
#include "tests/support/asleep.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <csignal>
#include <future>
#include <thread>
#include <vector>

namespace wakesurf::core::event_count_test {

namespace {

using namespace std::chrono_literals;

std::atomic<bool> set_aside{false}, go_on{false};

/// In a signal's handler: the thread it came to stands still, as one that the kernel has preempted.
void stand_still(int) {
    set_aside = true;
    while (!go_on)
        std::this_thread::yield();
}

/// Sleeps at an event count, and can be set aside there.
class Sleeper {
  public:
    explicit Sleeper(EventCount& event)
        : thread_([this, &event] {
              const auto seen = event.notifications();
              id_ = tests::this_thread_id();
              event.wait(seen);
          }) {
        while (id_ == 0 || !tests::asleep(id_))
            std::this_thread::yield();
    }

    void set_aside_now() { pthread_kill(thread_.native_handle(), SIGUSR1); }

  private:
    std::atomic<int> id_{0};
    std::jthread thread_;
};

} // namespace

TEST(EventCount, AWaitEndsAtOnceAfterANotificationSince) {
    EventCount event;
    const auto seen = event.notifications();
    event.notify_one();
    event.wait(seen);
    event.wait(seen, 1h);
    EXPECT_NE(event.notifications(), seen);
}

TEST(EventCount, AWaitEndsAfterItsLongestTimeWithoutANotification) {
    EventCount event;
    const auto start = std::chrono::steady_clock::now();
    event.wait(event.notifications(), 20ms);
    EXPECT_GE(std::chrono::steady_clock::now() - start, 20ms);
    event.wait(event.notifications(), -1ms);
}

TEST(EventCount, EachThingThatIsLeftBeforeANotificationIsFoundByAThreadThatSleeps) {
    constexpr int things = 20'000, sleepers = 3;
    EventCount event;
    std::atomic<int> left{0}, found{0};
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < sleepers; ++i)
            threads.emplace_back([&] {
                for (;;) {
                    const auto seen = event.notifications();
                    if (found == things)
                        return;
                    int here = left;
                    while (here > 0 && !left.compare_exchange_weak(here, here - 1)) {
                    }
                    if (here == 0)
                        event.wait(seen);
                    else if (++found == things)
                        event.notify_all();
                }
            });
        for (int i = 0; i < things; ++i) {
            ++left;
            event.notify_one();
        }
    }
    EXPECT_EQ(found, things);
}

TEST(EventCount, ANotifierDoesNotWaitForASleeperThatWasWokenAndIsSetAside) {
    const auto before = std::signal(SIGUSR1, stand_still);
    EventCount event;
    {
        Sleeper first(event);
        first.set_aside_now();
        while (!set_aside)
            std::this_thread::yield();
        event.notify_all();
        Sleeper second(event);
        auto notified = std::async(std::launch::async, [&] { event.notify_all(); });
        EXPECT_EQ(notified.wait_for(60s), std::future_status::ready);
        go_on = true;
    }
    std::signal(SIGUSR1, before);
}

} // namespace wakesurf::core::event_count_test
