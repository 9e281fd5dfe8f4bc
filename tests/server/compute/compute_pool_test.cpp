// The pool's own threads: who waits for whom, at which priority, and how soon a stopped job lets go.
#include "core/field/analytic_flow.hpp"
#include "server/compute/compute_pool.hpp"
#include "server/session/live/surface_build.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <future>
#include <string>
#include <vector>

namespace wakesurf::server::compute_pool_test {

namespace {

/// Tells when it has been looked at `looks` times: the engine does so between its rounds.
class TellingClock final : public core::Clock {
  public:
    explicit TellingClock(int looks) : left_(looks) {}

    std::chrono::steady_clock::time_point now() const override {
        if (--left_ == 0)
            there_.set_value();
        return std::chrono::steady_clock::now();
    }

    std::future<void> there() { return there_.get_future(); }

  private:
    mutable std::atomic<int> left_;
    mutable std::promise<void> there_;
};

SurfaceJob large_surface() {
    SurfaceJob job;
    job.rake = {core::Rake::Kind::Line, {{-8, 0, 0}, {8, 2, 0}}, 2000};
    job.parameters.to = 40.0;
    job.parameters.separation = 0.005;
    job.parameters.max_quads = 4'000'000;
    job.flow = *core::make_analytic_flow("abc");
    job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
    return job;
}

/// Time by the clock, and of the processor by all threads of this process.
struct Spent {
    std::chrono::nanoseconds wall, processor;

    static Spent now() {
        timespec used{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
        return {std::chrono::steady_clock::now().time_since_epoch(),
                std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec)};
    }

    Spent operator-(const Spent& earlier) const {
        return {wall - earlier.wall, processor - earlier.processor};
    }
};

int own_priority() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
}

} // namespace

TEST(ComputePool, RunsQuickJobsWhileEveryLongThreadIsBusy) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 20; ++i)
        pool.run("heavy" + std::to_string(i), Pace::Long, [released] { released.wait(); });
    std::promise<int> quick;
    pool.run("light", Pace::Quick, [&] { quick.set_value(own_priority()); });
    EXPECT_EQ(quick.get_future().get(), own_priority());
    release.set_value();
}

TEST(ComputePool, RunsAQuickJobOfOneSessionWhileAnotherHasMoreOfThemThanThreads) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    for (int i = 0; i < 64; ++i)
        pool.run("heavy", Pace::Quick, [released] { released.wait(); });
    std::promise<int> quick;
    pool.run("light", Pace::Quick, [&] { quick.set_value(own_priority()); });
    EXPECT_EQ(quick.get_future().get(), own_priority());
    release.set_value();
}

TEST(ComputePool, RunsTheManyQuickJobsOfASessionAtAPriorityBetweenAFewAndLongOnes) {
    ComputePool pool(2);
    std::promise<void> release;
    const auto released = release.get_future().share();
    std::promise<int> few, many, longer;
    pool.run("a", Pace::Quick, [&, released] {
        few.set_value(own_priority());
        released.wait();
    });
    pool.run("a", Pace::Quick, [&] { many.set_value(own_priority()); });
    pool.run("a", Pace::Long, [&] { longer.set_value(own_priority()); });
    const int of_many = many.get_future().get();
    EXPECT_GT(of_many, few.get_future().get());
    EXPECT_LT(of_many, longer.get_future().get());
    release.set_value();
}

TEST(ComputePool, RunsLongJobsOfSeveralSessionsAtATimeAndOneOfEach) {
    ComputePool pool(2);
    std::atomic<int> running{0}, most{0};
    std::promise<void> both;
    for (int i = 0; i < 8; ++i)
        pool.run("a", Pace::Long, [&] {
            most = std::max(most.load(), ++running);
            --running;
        });
    std::promise<void> a_waits, b_waits;
    pool.run("a", Pace::Long, [&, other = b_waits.get_future().share()] {
        a_waits.set_value();
        other.wait();
    });
    pool.run("b", Pace::Long, [&, other = a_waits.get_future().share()] {
        b_waits.set_value();
        other.wait();
        both.set_value();
    });
    both.get_future().wait(); // each waited for the other to run as well
    EXPECT_EQ(most, 1);
}

TEST(ComputePool, RunsLongJobsAtALowerPriority) {
    ComputePool pool(2);
    std::promise<int> priority;
    pool.run("a", Pace::Long, [&] { priority.set_value(own_priority()); });
    EXPECT_GT(priority.get_future().get(), own_priority());
}

TEST(ComputePool, LetsGoOfEveryStoppedJobWithin50Milliseconds) {
    std::vector<Spent> spent;
    for (const int rounds : {2, 3, 4, 5, 6, 7, 8}) {
        ComputePool pool(2);
        TellingClock clock(rounds);
        auto amid = clock.there();
        SurfaceBuild build(large_surface(), clock);
        std::stop_source stop;
        std::promise<core::Result<Update>> ended;
        pool.run("a", Pace::Long, [&] { ended.set_value(build.run({}, stop.get_token())); });
        ASSERT_EQ(amid.wait_for(std::chrono::minutes(1)), std::future_status::ready);
        const Spent before = Spent::now();
        stop.request_stop();
        const auto result = ended.get_future().get();
        spent.push_back(Spent::now() - before);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, core::Error::Code::Cancelled);
        // Whatever else the machine does: none computes on for longer, on both of its threads together.
        EXPECT_LT(spent.back().processor, 2 * std::chrono::milliseconds(50)) << rounds;
    }
    // By the clock other programs may hold some of them up.
    std::ranges::sort(spent, {}, &Spent::wall);
    EXPECT_LT(spent[spent.size() / 2].wall, std::chrono::milliseconds(50));
}

TEST(ComputePool, RunsJobsByHandInTheOrderOfTurns) {
    ComputePool pool{ComputePool::ByHand{}};
    std::string order;
    for (const char job : {'1', '2'})
        pool.run("a", Pace::Long, [&order, job] { order += job; });
    pool.run("b", Pace::Long, [&order] { order += 'b'; });
    pool.run("b", Pace::Quick, [&order] { order += 'q'; });
    pool.run([&order] { order += 'l'; });
    while (pool.turn()) {
    }
    EXPECT_EQ(order, "q1bl2");
}

} // namespace wakesurf::server::compute_pool_test
