// What a live surface computes, in which order, and what it sends and says of it.
#include "tests/server/live/live_surface_fixture.hpp"
#include "tests/support/same_state.hpp"

#include <utility>
#include <vector>

namespace wakesurf::server::live_surface_test {

using std::chrono::milliseconds;

TEST_F(LiveSurfaceTest, ShowsACoarseARefinedAndAFinalStateWhereTheFinalOneIsLongInComing) {
    wall.each = std::chrono::milliseconds(10);
    surface->rebuild(job_of(core::SurfaceKind::Stream, 0.01));
    settle();
    ASSERT_EQ(seen.size(), 3U);
    EXPECT_EQ(seen[0].header.phase, Phase::Coarse);
    EXPECT_EQ(seen[1].header.phase, Phase::Refined);
    EXPECT_EQ(seen[2].header.phase, Phase::Final);
    EXPECT_LT(seen[0].vertices, seen[1].vertices);
    EXPECT_LE(seen[1].vertices, seen[2].vertices);
    EXPECT_EQ(progress, (std::vector<std::pair<std::uint32_t, Phase>>{
                            {1, Phase::Coarse}, {1, Phase::Refined}, {1, Phase::Final}}));
    ASSERT_EQ(done.size(), 1U);
    EXPECT_EQ(done[0].state_sum, seen[2].header.state_sum);
    EXPECT_EQ(done[0].statistics.vertices, seen[2].vertices);
}

TEST_F(LiveSurfaceTest, SaysWhatEachPassTookFromTheEditOn) {
    wall.each = std::chrono::milliseconds(10);
    surface->rebuild(job_of(core::SurfaceKind::Stream, 0.01));
    wall.time += std::chrono::milliseconds(250); // no one takes the job so long
    settle();
    ASSERT_EQ(took.size(), 3U);
    EXPECT_GE(took[0].queue, 0.25);
    for (const PassSeconds& each : took) {
        EXPECT_GE(each.queue, 0.01) << "at least one look at the clock";
        EXPECT_GE(each.load, 0.0);
        EXPECT_GT(each.compute, 0.0);
        EXPECT_GE(each.encode, 0.01);
    }
    EXPECT_LT(took[1].queue, 0.25) << "from when it was wanted: after the one before";
    ASSERT_TRUE(done[0].took);
    EXPECT_EQ(done[0].took->queue, took[2].queue);
    EXPECT_EQ(done[0].took->compute, took[2].compute);
}

TEST_F(LiveSurfaceTest, StopsWhatIsUnderWayKeepsWhatIsThereAndBuildsAgainWhenItIsSet) {
    wall.each = std::chrono::milliseconds(10);
    surface->rebuild(job_of(core::SurfaceKind::Stream, 0.05));
    turn(); // the coarse one
    look();
    ASSERT_EQ(seen.size(), 1U);
    core::Result<SurfaceOutcome> answer;
    surface->wait(1, milliseconds(1000),
                  [&](const core::Result<SurfaceOutcome>& given) { answer = given; });
    EXPECT_TRUE(surface->stop({core::Error::Code::Cancelled, "stopped by Ada", ""}));
    EXPECT_FALSE(surface->stop({core::Error::Code::Cancelled, "stopped by Bob", ""})) << "it is";
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().message, "stopped by Ada");
    settle();
    EXPECT_EQ(seen.size(), 1U) << "what the stopped job still gave is no one's";
    ASSERT_EQ(done.size(), 1U);
    EXPECT_FALSE(done[0].complete);
    EXPECT_EQ(done[0].error->code, core::Error::Code::Cancelled);
    EXPECT_EQ(done[0].state_sum, seen[0].header.state_sum) << "the coarse state stays";
    surface->rebuild(job_of(core::SurfaceKind::Stream, 0.05));
    settle();
    EXPECT_EQ(seen.back().header.phase, Phase::Final);
    EXPECT_FALSE(surface->stop({core::Error::Code::Cancelled, "late", ""}))
        << "nothing is under way";
    EXPECT_TRUE(surface->outcome().complete);
}

TEST_F(LiveSurfaceTest, TellsHowFarItIsOverAllPassesAndNeverLessThanBefore) {
    wall.each = std::chrono::milliseconds(10);
    surface->rebuild(job_of(core::SurfaceKind::Streak, 0.03));
    EXPECT_EQ(surface->status().fraction, 0.0);
    std::vector<double> told;
    do
        told.push_back(surface->status().fraction);
    while (turn());
    told.push_back(surface->status().fraction);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GE(told.size(), 3U) << "early passes are a part of the way";
    EXPECT_GT(told[1], 0.0);
    EXPECT_LT(told[1], 0.3);
    const BuildStatus there = surface->status();
    EXPECT_EQ(there.fraction, 1.0);
    EXPECT_EQ(there.time, 2.0);
    EXPECT_EQ(there.quads, done.back().statistics.quads);
    EXPECT_GT(there.seconds, 0.0);

    surface->rebuild(job_of(core::SurfaceKind::Streak, 0.031));
    EXPECT_EQ(surface->status().fraction, 0.0) << "another way";
    EXPECT_FALSE(surface->status().time);
}

TEST_F(LiveSurfaceTest, GoesOnFromWhereItWasWhenAnotherTimeIsAskedForOnTheWay) {
    wall.each = std::chrono::milliseconds(10);
    surface->rebuild(job_of(core::SurfaceKind::Streak, 0.03));
    turn(); // the coarse one
    const double before = surface->status().fraction;
    surface->show(1.0, false, true);
    EXPECT_GE(surface->status().fraction, before);
    while (turn())
        EXPECT_GE(surface->status().fraction, before);
    EXPECT_EQ(surface->status().fraction, 1.0);
    surface->show(1.5, false, true);
    EXPECT_LT(surface->status().fraction, 1.0) << "what was asked for is there: a new way";
    settle();
    EXPECT_EQ(surface->status().fraction, 1.0);
    EXPECT_EQ(surface->status().time, 1.5);
}

TEST_F(LiveSurfaceTest, LeavesEarlyStatesOutWhereTheFinalOneIsFast) {
    surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    EXPECT_EQ(progress.size(), 2U) << "nothing was known of the first";
    surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    EXPECT_EQ(progress.back(), std::pair(2U, Phase::Final));
    EXPECT_EQ(progress.size(), 3U);
}

TEST_F(LiveSurfaceTest, ShowsMostEditsEarlyWhileASurfaceGrowsBeyondWhatEarlyOnesHadInQuads) {
    wall.each = std::chrono::milliseconds(10);
    int without = 0, edits = 0;
    for (double to = 2.0; to < 120.0; to *= 1.3, ++edits) {
        SurfaceJob job = job_of(core::SurfaceKind::Stream, 0.4);
        job.plan.parameters.to = to;
        const std::size_t before = seen.size();
        surface->rebuild(std::move(job));
        settle();
        ASSERT_GT(seen.size(), before);
        without += seen[before].header.phase == Phase::Final;
    }
    EXPECT_GE(edits, 15);
    EXPECT_LE(without, 3);
}

TEST_F(LiveSurfaceTest, BuildsOnlyTheNewestOfManyEdits) {
    for (int i = 0; i < 10; ++i)
        surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    ASSERT_EQ(done.size(), 1U);
    EXPECT_EQ(done[0].epoch, 10U);
    for (const Seen& each : seen)
        EXPECT_EQ(each.header.epoch, 10U);
    EXPECT_EQ(surface->newest()->wire.state_sum, seen.back().header.state_sum);
}

TEST_F(LiveSurfaceTest, ShowsMovingSurfacesAtTheClocksTime) {
    for (const auto kind :
         {core::SurfaceKind::Path, core::SurfaceKind::Streak, core::SurfaceKind::Time}) {
        surface->show(std::nullopt, false, true);
        surface->rebuild(job_of(kind));
        settle();
        EXPECT_EQ(seen.back().header.time, 2.0) << "never set: at its end";
        for (const double time : {1.3, 0.4, -5.0, 0.9, 7.0}) {
            surface->show(time, false, true);
            settle();
            const double shown = std::clamp(time, 0.0, 2.0);
            EXPECT_EQ(seen.back().header.time, shown);
            EXPECT_EQ(seen.back().header.phase, Phase::Final);
            EXPECT_NE(seen.back().header.flags & protocol::FrameHeader::lossless, 0);
            EXPECT_EQ(decoder.newest()->mesh->cells().size(), cells_at(kind, time)) << time;
            const SurfaceOutcome outcome = surface->outcome();
            EXPECT_TRUE(outcome.complete);
            EXPECT_EQ(outcome.state_sum, protocol::state_sum(*decoder.newest()->mesh));
        }
        EXPECT_EQ(surface->epoch(), seen.back().header.epoch) << "the clock begins no epoch";
    }
}

TEST_F(LiveSurfaceTest, PaysTheClockNoAttentionWhereNothingMoves) {
    surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    const std::size_t before = seen.size();
    surface->show(0.5, true, true);
    EXPECT_FALSE(surface->busy());
    settle();
    EXPECT_EQ(seen.size(), before);
}

TEST_F(LiveSurfaceTest, LeavesTimesOutWhileItPlaysFasterThanItIsComputed) {
    surface->show(0.0, true, true);
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    seen.clear();
    double time = 0.0;
    for (int frame = 0; frame < 10; ++frame) {
        for (int tick = 0; tick < 4; ++tick)
            surface->show(time += 0.04, true, false);
        turn();
        look();
    }
    settle();
    EXPECT_GE(seen.size(), 9U);
    EXPECT_LE(seen.size(), 12U) << "40 ticks";
    for (const Seen& each : seen) {
        EXPECT_EQ(each.header.phase, Phase::Live);
        EXPECT_EQ(each.header.epoch, 1U);
    }
    EXPECT_EQ(seen.back().header.time, time);
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [](const Seen& each) {
        return !each.header.is_key();
    })) << "deltas";
    EXPECT_TRUE(done.empty());
}

TEST_F(LiveSurfaceTest, EndsPlayingWithALosslessState) {
    surface->show(0.0, true, true);
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    for (const double time : {0.5, 1.0, 1.5}) {
        surface->show(time, true, false);
        settle();
    }
    EXPECT_EQ(seen.back().header.phase, Phase::Live);
    surface->show(1.5, false, true);
    settle();
    EXPECT_EQ(seen.back().header.phase, Phase::Final);
    EXPECT_NE(seen.back().header.flags & protocol::FrameHeader::lossless, 0);
    EXPECT_FALSE(seen.back().header.is_key()) << "what was within the tolerance";
    ASSERT_EQ(done.size(), 1U);
    EXPECT_EQ(done[0].state_sum, protocol::state_sum(*decoder.newest()->mesh));
    SurfaceBuild alone(job_of(core::SurfaceKind::Streak), wall);
    const auto exact = alone.run({Phase::Final, 0, 1.5}, {});
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->wire.state->vertices(), decoder.newest()->mesh->vertices());
}

TEST_F(LiveSurfaceTest, AnswersWhoWaitsOnceTheClocksTimeIsShown) {
    std::vector<core::Result<SurfaceOutcome>> answers;
    const auto keep = [&](core::Result<SurfaceOutcome> outcome) {
        answers.push_back(std::move(outcome));
    };
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    surface->wait(1, milliseconds(1000), keep);
    settle();
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_TRUE(answers[0]->complete);
    surface->show(1.0, false, true);
    surface->wait(1, milliseconds(1000), keep);
    EXPECT_EQ(answers.size(), 1U);
    settle();
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_EQ(answers[1]->state_sum, seen.back().header.state_sum);
    surface->show(0.5, false, true);
    surface->wait(1, milliseconds(1000), keep);
    loop.advance(milliseconds(1001));
    ASSERT_EQ(answers.size(), 3U);
    EXPECT_FALSE(answers[2]->complete);
    surface->wait(5, milliseconds(1000), keep);
    surface->retire();
    ASSERT_EQ(answers.size(), 4U);
    EXPECT_EQ(answers[3].error().code, core::Error::Code::NotFound);
}

TEST_F(LiveSurfaceTest, GivesWhoComesLateTheStateOthersHaveFollowedTo) {
    surface->show(0.0, true, true);
    surface->rebuild(job_of(core::SurfaceKind::Streak));
    settle();
    for (int i = 1; i <= 30; ++i) {
        surface->show(0.05 * i, true, false);
        settle();
    }
    FrameCursor late(surface->ring(), {}, [](bool) { ADD_FAILURE() << "it has missed nothing"; });
    protocol::MeshDecoder other;
    const auto read = [&] {
        while (const auto frame = late.next())
            ASSERT_TRUE(other.fold(*frame));
    };
    read();
    settle(); // the keyframe, if it had to be made
    read();
    ASSERT_TRUE(other.newest());
    EXPECT_TRUE(tests::same_state(*other.newest()->mesh, *decoder.newest()->mesh));
    surface->show(1.6, true, false);
    settle();
    read();
    EXPECT_TRUE(tests::same_state(*other.newest()->mesh, *decoder.newest()->mesh));
}

TEST_F(LiveSurfaceTest, SaysWhyThereIsNothingToBuildAndBuildsAgainLater) {
    surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    surface->refuse(core::SurfaceKind::Stream, {core::Error::Code::NotFound, "no dataset", ""});
    loop.advance(milliseconds(0));
    EXPECT_EQ(done.back().error->code, core::Error::Code::NotFound);
    EXPECT_EQ(done.back().epoch, 2U);
    EXPECT_FALSE(surface->newest());
    surface->rebuild(job_of(core::SurfaceKind::Stream));
    settle();
    EXPECT_FALSE(done.back().error);
    EXPECT_EQ(done.back().epoch, 3U);
}

} // namespace wakesurf::server::live_surface_test
