#include "core/field/interval.hpp"
#include "tests/support/asleep.hpp"
#include "tests/support/gated_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <chrono>
#include <future>
#include <thread>

namespace wakesurf::core::interval_test {

using tests::SampledSource;

namespace {

std::shared_ptr<TimeStepCache> small_cache(std::size_t steps, std::size_t room) {
    const UniformGrid grid;
    std::vector<double> times;
    for (std::size_t i = 0; i < steps; ++i)
        times.push_back(static_cast<double>(i));
    return std::make_shared<TimeStepCache>(
        std::make_shared<SampledSource>(grid, times, [](const Vec3&, double) { return Vec3(1.0); }),
        TimeStepCache::Options{room * grid.nodes() * 12});
}

} // namespace

TEST(Interval, HoldsWhatIsNeededAndThereIs) {
    const Intervals intervals(small_cache(4, 4));
    const auto held = [&](std::size_t k, Intervals::Needs needs) {
        const Interval interval = intervals.acquire(k, needs, {}).value();
        std::string text;
        for (const auto& step : {interval.before, interval.first, interval.second, interval.after})
            text += step ? std::to_string(step->index) : "-";
        return text;
    };
    EXPECT_EQ(held(1, Intervals::Needs::First), "-1--");
    EXPECT_EQ(held(1, Intervals::Needs::Both), "-12-");
    EXPECT_EQ(held(1, Intervals::Needs::Four), "0123");
    EXPECT_EQ(held(0, Intervals::Needs::Four), "-012");
    EXPECT_EQ(held(2, Intervals::Needs::Four), "123-");
    EXPECT_EQ(held(3, Intervals::Needs::Both), "-3--");
}

TEST(Interval, CallersWhoWantMoreThanTheCacheHoldsAreServedOneAfterTheOther) {
    for (const std::size_t room : {4u, 8u}) {
        const Intervals intervals(small_cache(100, room));
        constexpr int callers = 4;
        std::barrier together(callers);
        std::vector<std::jthread> threads;
        for (std::size_t caller = 0; caller < callers; ++caller)
            threads.emplace_back([&, caller] {
                for (std::size_t round = 0; round < 4; ++round) {
                    together.arrive_and_wait();
                    const auto got =
                        intervals.acquire(25 * caller + 5 * round + 1, Intervals::Needs::Four, {});
                    EXPECT_TRUE(got) << got.error().message;
                }
            });
    }
}

TEST(Interval, ACallerWhoIsCancelledWhileAnotherHasItsTurnLeavesAtOnce) {
    const auto source = std::make_shared<tests::GatedSource>(100);
    source->close();
    const Intervals intervals(
        std::make_shared<TimeStepCache>(source, TimeStepCache::Options{4 * tests::step_bytes}));
    std::jthread first([&] { EXPECT_TRUE(intervals.acquire(1, Intervals::Needs::Four, {})); });
    source->wait_for_loads(1);
    std::stop_source stop;
    std::atomic<int> id{0};
    auto second = std::async(std::launch::async, [&] {
        id = tests::this_thread_id();
        return intervals.acquire(50, Intervals::Needs::Four, stop.get_token());
    });
    while (id == 0 || !tests::asleep(id))
        std::this_thread::yield();
    stop.request_stop();
    EXPECT_EQ(second.wait_for(std::chrono::minutes(1)), std::future_status::ready);
    source->open();
    EXPECT_EQ(second.get().error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::interval_test
