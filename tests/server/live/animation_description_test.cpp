// What the viewer of an animation says of it.
#include "core/base/clock.hpp"
#include "core/field/analytic_flow.hpp"
#include "server/live/animation_description.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wakesurf::server::animation_description_test {

TEST(AnimationDescription, SaysWhyThereIsNoErrorBetweenStoredTimes) {
    std::shared_ptr<const core::Flow> flow = core::make_analytic_flow("double-gyre").value();
    const core::Rake rake{core::Rake::Kind::Line, {{0.5, 0.2, 0}, {0.5, 0.8, 0}}, 9};
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.separation = 0.05;
    SurfaceJob job;
    job.plan = value_of(core::plan_surface(flow, rake, p));
    job.lattice = protocol::lattice_over(flow->domain());
    core::SteadyClock clock;
    auto made = value_of(animate(job, std::vector<double>{0.0, 1.0}, clock, {}));
    made.last.statistics.interval_left_out = "the flow is known at all times";
    core::DatasetInfo info;
    info.name = "</script>\x1b[31m";
    info.bounds = job.plan.flow->domain();
    info.time_unit = "s";
    const auto said = description_of(made, job, info, "1.2");
    EXPECT_TRUE(std::ranges::any_of(said.facts, [](const std::string& fact) {
        return fact.ends_with("none is stated, because the flow is known at all times.");
    }));
    EXPECT_EQ(said.title, "</script>[31m: streak surface");
    EXPECT_EQ(said.times, (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(said.values[0].title, "Speed");
}

} // namespace wakesurf::server::animation_description_test
