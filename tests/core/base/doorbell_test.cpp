#include "core/base/doorbell.hpp"
#include "tests/support/asleep.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <csignal>
#include <future>
#include <thread>
#include <vector>

namespace wakesurf::core::doorbell_test {

namespace {

using namespace std::chrono_literals;

std::atomic<bool> set_aside{false}, go_on{false};

/// In a signal's handler: the thread it came to stands still, as one that the kernel has set aside.
void stand_still(int) {
    set_aside = true;
    while (!go_on)
        std::this_thread::yield();
}

/// Sleeps at a bell, and can be set aside there.
class Sleeper {
  public:
    explicit Sleeper(Doorbell& bell)
        : thread_([this, &bell] {
              const auto seen = bell.rings();
              id_ = tests::this_thread_id();
              bell.wait(seen);
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

TEST(Doorbell, AWaitEndsAtOnceWhereItHasRungSince) {
    Doorbell bell;
    const auto seen = bell.rings();
    bell.ring_one();
    bell.wait(seen);
    bell.wait(seen, 1h);
    EXPECT_NE(bell.rings(), seen);
}

TEST(Doorbell, AWaitEndsAfterItsLongestTimeWhereNothingRings) {
    Doorbell bell;
    const auto start = std::chrono::steady_clock::now();
    bell.wait(bell.rings(), 20ms);
    EXPECT_GE(std::chrono::steady_clock::now() - start, 20ms);
    bell.wait(bell.rings(), -1ms);
}

TEST(Doorbell, EachThingThatIsLeftBeforeARingIsFoundByAThreadThatSleeps) {
    constexpr int things = 20'000, sleepers = 3;
    Doorbell bell;
    std::atomic<int> left{0}, found{0};
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < sleepers; ++i)
            threads.emplace_back([&] {
                for (;;) {
                    const auto seen = bell.rings();
                    if (found == things)
                        return;
                    int here = left;
                    while (here > 0 && !left.compare_exchange_weak(here, here - 1)) {
                    }
                    if (here == 0)
                        bell.wait(seen);
                    else if (++found == things)
                        bell.ring_all();
                }
            });
        for (int i = 0; i < things; ++i) {
            ++left;
            bell.ring_one();
        }
    }
    EXPECT_EQ(found, things);
}

TEST(Doorbell, WhoRingsDoesNotWaitForASleeperThatWasWokenAndIsSetAside) {
    const auto before = std::signal(SIGUSR1, stand_still);
    Doorbell bell;
    {
        Sleeper first(bell);
        first.set_aside_now();
        while (!set_aside)
            std::this_thread::yield();
        bell.ring_all();
        Sleeper second(bell);
        auto rings = std::async(std::launch::async, [&] { bell.ring_all(); });
        EXPECT_EQ(rings.wait_for(60s), std::future_status::ready);
        go_on = true;
    }
    std::signal(SIGUSR1, before);
}

} // namespace wakesurf::core::doorbell_test
