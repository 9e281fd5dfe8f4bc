// The errors that a streak or time surface states do not depend on how it was computed.
#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/surface_history.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace wakesurf::core::moving_error_test {

namespace {

const SteadyClock steady_clock;

} // namespace

TEST(MovingError, IsTheSameForAnyNumberOfThreadsAndAfterGoingBack) {
    const auto flow = *make_analytic_flow("double-gyre");
    const Rake rake{Rake::Kind::Line, {{0.2, 0.5, 0.0}, {1.8, 0.5, 0.0}}, 8};
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced}) {
        const auto errors = [&](std::size_t threads, std::vector<double> looked_at) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            SurfaceParameters p{
                .kind = SurfaceKind::Streak, .to = 4.0, .separation = 0.1, .accuracy = accuracy};
            SurfaceHistory history(
                *MovingSurface::start(plan_surface(*flow, rake, p).value(), {}, steady_clock), 1e6);
            for (const double time : looked_at)
                EXPECT_TRUE(history.at(time, {}));
            const auto shown = history.at(3.1, {});
            EXPECT_TRUE(shown);
            return shown->mesh.error;
        };
        const std::vector<float> once = errors(1, {});
        ASSERT_GT(once.size(), 100u);
        EXPECT_GT(*std::max_element(once.begin(), once.end()), 0.0f);
        EXPECT_EQ(errors(2, {}), once);
        EXPECT_EQ(errors(2, {3.9, 1.3, 4.0, 0.2}), once);
    }
}

} // namespace wakesurf::core::moving_error_test
