// The error between stored times follows a surface's final state, and yields to every edit.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/twin.hpp"
#include "tests/server/live/live_surface_fixture.hpp"
#include "tests/support/sampled_source.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace wakesurf::server::stated_intervals_test {

namespace {

/// A surface in a fluid that moves to and fro as one, stored 17 times.
SurfaceJob stored_job(core::SurfaceKind kind, std::vector<SurfaceField> fields = {}) {
    core::UniformGrid grid;
    grid.origin = {-8, -4, -4};
    grid.spacing = core::Vec3(1.0);
    grid.dimensions = {33, 9, 9};
    std::vector<double> times;
    for (int k = 0; k <= 16; ++k)
        times.push_back(0.25 * k);
    core::SurfaceParameters p;
    p.kind = kind;
    p.to = 4.0;
    p.separation = 0.25;
    SurfaceJob job;
    job.plan = core::plan_surface(core::make_stored_flow(std::make_shared<core::TimeStepCache>(
                                      std::make_shared<tests::SampledSource>(
                                          grid, std::move(times),
                                          [](const core::Vec3&, double t) {
                                              return core::Vec3(1.0 + std::sin(2.0 * t), 0.0, 0.25);
                                          }),
                                      core::TimeStepCache::Options{})),
                                  {core::Rake::Kind::Line, {{0, -1, 0}, {0, 1, 0}}, 5}, p)
                   .value();
    job.lattice = protocol::lattice_over({{-8, -4, -4}, {24, 4, 4}});
    job.fields = std::move(fields);
    return job;
}

constexpr std::array moving{core::SurfaceKind::Path, core::SurfaceKind::Streak};

} // namespace

class StatedIntervals : public LiveSurfaceTest {};

TEST_F(StatedIntervals, FollowTheFinalStateWithoutChangingIt) {
    wall.each = std::chrono::milliseconds(10);
    for (const core::SurfaceKind kind : moving) {
        done.clear();
        surface->rebuild(stored_job(kind));
        settle();
        ASSERT_EQ(done.size(), 2U);
        EXPECT_TRUE(done[0].complete);
        EXPECT_TRUE(done[0].checks_pending);
        EXPECT_FALSE(done[0].statistics.interval_error);
        EXPECT_EQ(done[0].statistics.interval_left_out, "it is not estimated yet");
        EXPECT_TRUE(done[1].complete);
        EXPECT_FALSE(done[1].checks_pending);
        ASSERT_TRUE(done[1].statistics.interval_error);
        EXPECT_GT(done[1].statistics.interval_error->error99, 1e-4);
        EXPECT_EQ(done[1].statistics.interval_left_out, "");
        EXPECT_EQ(done[0].state_sum, done[1].state_sum);
        EXPECT_GT(done[0].took->compute, 0.0);
        EXPECT_EQ(done[0].took->compute, done[1].took->compute) << "what the picture took";
        EXPECT_EQ(done[0].statistics.vertices, done[1].statistics.vertices);
    }
}

TEST_F(StatedIntervals, ComeAsValuesOfTheField) {
    surface->rebuild(stored_job(core::SurfaceKind::Streak,
                                {{"interval_error", SurfaceField::Source::IntervalError}}));
    const auto missing = [&] {
        const protocol::WireMesh& mesh = *decoder.newest()->mesh;
        std::size_t count = 0;
        for (const std::uint16_t code : mesh.codes[3])
            count += std::isnan(mesh.ranges[3].value(code)) ? 1 : 0;
        return count;
    };
    while (done.empty() && turn())
        look();
    look();
    EXPECT_EQ(missing(), decoder.newest()->mesh->vertices());
    settle();
    ASSERT_TRUE(surface->outcome().statistics.interval_error);
    EXPECT_LT(missing(), decoder.newest()->mesh->vertices() / 2);
}

TEST_F(StatedIntervals, OfAReplacedSurfaceAreNotWaitedFor) {
    surface->rebuild(stored_job(core::SurfaceKind::Streak));
    while (done.empty() && turn())
        ;
    ASSERT_TRUE(surface->outcome().checks_pending);
    EXPECT_FALSE(surface->busy());
    surface->rebuild(stored_job(core::SurfaceKind::Streak));
    EXPECT_TRUE(surface->busy());
    settle();
    for (const SurfaceOutcome& outcome : done)
        EXPECT_TRUE(outcome.epoch == 2 || !outcome.statistics.interval_error);
    EXPECT_TRUE(surface->outcome().statistics.interval_error);
}

TEST_F(StatedIntervals, AreThoseOfTheTimeThatIsShown) {
    surface->show(4.0, false, false);
    surface->rebuild(stored_job(core::SurfaceKind::Streak));
    settle();
    const auto whole = surface->outcome().statistics.interval_error;
    surface->show(2.0, false, true);
    while (surface->outcome().checks_pending == false && turn())
        ;
    surface->show(3.0, false, true); // while the job for the other time waits
    settle();
    const auto later = surface->outcome().statistics.interval_error;
    surface->show(0.5, false, true);
    settle();
    ASSERT_TRUE(whole && later);
    EXPECT_NE(whole->error99, later->error99);
    EXPECT_EQ(surface->outcome().statistics.interval_left_out,
              "the surface uses 3 stored times, and at least 5 are needed");
}

TEST_F(StatedIntervals, OfAStateThatIsNotThereAreRefused) {
    SurfaceBuild build(stored_job(core::SurfaceKind::Streak), wall);
    SurfacePass pass;
    pass.checking = true;
    const auto update = build.run(pass, {});
    ASSERT_FALSE(update);
    EXPECT_EQ(update.error().code, core::Error::Code::NotFound);
}

TEST_F(StatedIntervals, AreLeftOutWithTheReasonWhereThereAreNone) {
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    ASSERT_EQ(done.size(), 1U);
    EXPECT_FALSE(done[0].checks_pending);
    EXPECT_EQ(done[0].statistics.interval_left_out,
              "the flow is known at all times: nothing is interpolated between stored times");
}

TEST_F(StatedIntervals, ComeWithTheTwinAndItsFields) {
    SurfaceJob job = stored_job(core::SurfaceKind::Streak,
                                {{"twin_distance", SurfaceField::Source::TwinDistance}});
    const core::SurfacePlan& plan = job.plan;
    job.twin = std::make_shared<core::SurfacePlan>(
        core::plan_twin(plan, plan.flow, {.offset = core::Vec3(0.0, 0.0, 0.5)}).value());
    surface->rebuild(std::move(job));
    while (done.empty() && turn())
        look();
    EXPECT_TRUE(done[0].checks_pending);
    EXPECT_EQ(done[0].statistics.twin_left_out, "it is not compared yet");
    settle();
    ASSERT_EQ(done.size(), 2U);
    ASSERT_TRUE(done[1].statistics.twin);
    EXPECT_EQ(done[1].statistics.twin_left_out, "");
    EXPECT_NEAR(done[1].statistics.twin->all.p50, 0.5, 1e-6);
    const protocol::WireMesh& mesh = *decoder.newest()->mesh;
    for (const std::uint16_t code : mesh.codes[3])
        EXPECT_NEAR(mesh.ranges[3].value(code), 0.5, 1e-3);
}

TEST_F(StatedIntervals, AndTwinsOfOtherTimesSayWhyTheyAreNotCompared) {
    SurfaceJob job = stored_job(core::SurfaceKind::Streak);
    job.twin_left_out = "the twin: the rake lies outside the domain by 3";
    surface->rebuild(std::move(job));
    settle();
    EXPECT_FALSE(done.back().statistics.twin);
    EXPECT_EQ(done.back().statistics.twin_left_out,
              "the twin: the rake lies outside the domain by 3");
}

TEST_F(StatedIntervals, AreWaitedForByWhoAsksForThem) {
    surface->rebuild(stored_job(core::SurfaceKind::Streak));
    std::vector<SurfaceOutcome> complete, checked;
    surface->wait(1, std::chrono::minutes(1),
                  [&](const auto& outcome) { complete.push_back(outcome.value()); });
    surface->wait(
        1, std::chrono::minutes(1),
        [&](const auto& outcome) { checked.push_back(outcome.value()); }, true);
    while (complete.empty() && turn())
        ;
    EXPECT_TRUE(checked.empty());
    settle();
    ASSERT_EQ(checked.size(), 1U);
    EXPECT_TRUE(checked[0].complete);
    EXPECT_TRUE(checked[0].statistics.interval_error);
    EXPECT_FALSE(complete[0].statistics.interval_error);
    surface->wait(
        1, std::chrono::minutes(1),
        [&](const auto& outcome) { checked.push_back(outcome.value()); }, true);
    EXPECT_EQ(checked.size(), 2U);
}

} // namespace wakesurf::server::stated_intervals_test
