// How soon a stopped job of the pool lets go.
#include "core/field/analytic_flow.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "server/live/surface_build.hpp"
#include "tests/support/server/processor_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <vector>

namespace wakesurf::server::compute_pool_timing_test {

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
    core::SurfaceParameters p;
    const core::Rake rake{core::Rake::Kind::Line, {{-8, 0, 0}, {8, 2, 0}}, 2000};
    p.to = 40.0;
    p.separation = 0.005;
    p.max_quads = 4'000'000;
    job.plan = core::plan_surface(*core::make_analytic_flow("abc"), rake, p).value();
    job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
    return job;
}

/// Time by the clock, and of the processor by all threads of this process.
struct Spent {
    std::chrono::nanoseconds wall, processor;

    static Spent now() {
        return {std::chrono::steady_clock::now().time_since_epoch(), tests::own_processor_time()};
    }

    Spent operator-(const Spent& earlier) const {
        return {wall - earlier.wall, processor - earlier.processor};
    }
};

} // namespace

TEST(ComputePoolTiming, LetsGoOfEveryStoppedJobWithin50Milliseconds) {
    std::vector<Spent> spent;
    for (const int rounds : {2, 3, 4, 5, 6, 7, 8}) {
        ComputePool pool(2);
        TellingClock clock(rounds);
        auto amid = clock.there();
        SurfaceBuild build(large_surface(), clock);
        std::stop_source stop;
        std::promise<core::Result<Update>> ended;
        pool.run("a", PriorityClass::Long,
                 [&] { ended.set_value(build.run({}, stop.get_token())); });
        ASSERT_EQ(amid.wait_for(std::chrono::minutes(1)), std::future_status::ready);
        const Spent before = Spent::now();
        stop.request_stop();
        const auto result = ended.get_future().get();
        spent.push_back(Spent::now() - before);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, core::Error::Code::Cancelled);
        // On both of its threads together.
        EXPECT_LT(spent.back().processor, 2 * std::chrono::milliseconds(50)) << rounds;
    }
    std::ranges::sort(spent, {}, &Spent::wall);
    EXPECT_LT(spent[spent.size() / 2].wall, std::chrono::milliseconds(50));
}

} // namespace wakesurf::server::compute_pool_timing_test
