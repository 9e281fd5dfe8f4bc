// What a live surface tells of the ranges of its values, its jobs run by hand.
#include "core/field/analytic_flow.hpp"
#include "server/live/live_surface.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace wakesurf::server::announced_ranges_test {

namespace {

SurfaceJob job_of(core::SurfaceKind kind) {
    SurfaceJob job;
    core::SurfaceParameters p;
    const core::Rake rake{core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    p.kind = kind;
    p.to = 2.0;
    p.separation = 0.2;
    job.plan = core::plan_surface(*core::make_analytic_flow("abc"), rake, p).value();
    job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
    job.fields = {{"vorticity", SurfaceField::Source::Gradient},
                  {"vorticity_x", SurfaceField::Source::Gradient}};
    return job;
}

core::ValueRange of(const ValueRanges& ranges, const std::string& attribute) {
    const auto found = std::ranges::find(ranges, attribute, &AnnouncedRange::attribute);
    return found == ranges.end() ? core::ValueRange{} : found->range;
}

bool holds(const core::ValueRange& wide, const core::ValueRange& narrow) {
    return wide.low <= narrow.low && wide.high >= narrow.high && wide.least <= narrow.least &&
           wide.greatest >= narrow.greatest;
}

class ToldRangesTest : public testing::Test {
  protected:
    void settle() {
        while (pool.turn())
            loop.advance(std::chrono::milliseconds(0));
    }

    HandClock hand;
    HandLoop loop{hand};
    ComputePool pool{ComputePool::ByHand{}};
    std::vector<SurfaceRanges> told;
    std::shared_ptr<LiveSurface> surface = std::make_shared<LiveSurface>(
        "s1",
        3,
        "main",
        LiveSurface::Services{loop, pool, hand, nullptr},
        LiveSurface::Events{[](const SurfaceProgress&) {}, [](const SurfaceOutcome&) {},
                            [this](const SurfaceRanges& ranges) { told.push_back(ranges); }});
};

} // namespace

TEST_F(ToldRangesTest, NameWhatTheFramesCarryAndTheAge) {
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    std::vector<std::string> names;
    for (const AnnouncedRange& each : surface->ranges())
        names.push_back(each.attribute);
    EXPECT_EQ(names, (std::vector<std::string>{"speed", "t", "vorticity", "vorticity_x"}));
    const core::ValueRange age = of(surface->ranges(), "t");
    EXPECT_NEAR(age.low, 0.0, 1e-9);
    EXPECT_NEAR(age.high, 2.0, 1e-9);
    EXPECT_GE(of(surface->ranges(), "vorticity").low, 0.0);
}

TEST_F(ToldRangesTest, OnlyGrowWhileASurfacePlaysAndAreTheSameForWhoComesLate) {
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    surface->show(0.25, true, true);
    settle();
    ValueRanges before = surface->ranges();
    for (const double time : {0.5, 1.0, 2.0, 0.25, 1.5}) {
        surface->show(time, true, false);
        settle();
        for (const AnnouncedRange& each : before)
            EXPECT_TRUE(holds(of(surface->ranges(), each.attribute), each.range))
                << each.attribute << " at " << time;
        before = surface->ranges();
    }
    EXPECT_EQ(told.back().ranges, surface->ranges()) << "as surface.subscribe answers it";
    EXPECT_NEAR(of(before, "t").high, 2.0, 1e-9) << "though 1.5 is shown";
    const auto count = told.size();
    surface->show(1.0, true, false);
    settle();
    EXPECT_EQ(told.size(), count) << "nothing new was seen";
}

TEST_F(ToldRangesTest, GoOnWhereAFieldIsAddedAndBeginAnewWithAnotherRakeOrOtherData) {
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    SurfaceJob fewer = job_of(core::SurfaceKind::Streak);
    fewer.fields.pop_back();
    fewer.plan.flow = surface->wanted().plan.flow;
    surface->show(0.5, false, true);
    surface->rebuild(fewer);
    settle();
    EXPECT_NEAR(of(surface->ranges(), "t").high, 2.0, 1e-9) << "the same surface";

    const core::Rake shorter{core::Rake::Kind::Line, {{0, 0, 0}, {0, 1, 0}}, 9};
    fewer.plan = core::plan_surface(fewer.plan.flow, shorter, fewer.plan.parameters).value();
    surface->rebuild(fewer);
    settle();
    EXPECT_NEAR(of(surface->ranges(), "t").high, 0.5, 1e-9) << "another rake";
    EXPECT_EQ(told.back().epoch, surface->epoch());

    surface->show(2.0, false, true);
    settle();
    fewer.plan.flow = *core::make_analytic_flow("abc?A=0.1,B=0.1,C=0.1");
    surface->rebuild(fewer);
    settle();
    EXPECT_LT(of(surface->ranges(), "speed").greatest, 0.4) << "other data";
}

TEST_F(ToldRangesTest, OfAStreamSurfaceGoOnWhenItsFieldIsFrozenAtAnotherTime) {
    SurfaceJob job = job_of(core::SurfaceKind::Stream);
    job.fields.clear();
    const core::Rake rake{core::Rake::Kind::Line, {{0.3, 0.2, 0.0}, {0.3, 0.8, 0.0}}, 9};
    job.plan =
        core::plan_surface(*core::make_analytic_flow("double-gyre"), rake, job.plan.parameters)
            .value();
    surface->rebuild(job);
    settle();
    const core::ValueRange first = of(surface->ranges(), "speed");
    ASSERT_GT(first.greatest, 0.0);
    for (const double from : {2.5, 5.0, 7.5, 0.1}) {
        job.plan.parameters.from = from;
        job.plan.parameters.to = from + 2.0;
        const core::ValueRange before = of(surface->ranges(), "speed");
        surface->rebuild(job);
        settle();
        EXPECT_TRUE(holds(of(surface->ranges(), "speed"), before)) << from;
    }
    EXPECT_FALSE(holds(first, of(surface->ranges(), "speed"))) << "there was something to see";
    job.plan.parameters.to += 1.0;
    EXPECT_FALSE(plays_on(surface->wanted(), job)) << "a longer surface is another one";
}

} // namespace wakesurf::server::announced_ranges_test
