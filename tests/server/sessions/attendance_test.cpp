// Sessions without anybody: by a clock that the test turns, and jobs that it runs.
#include "core/field/analytic_flow.hpp"
#include "server/sessions/session.hpp"
#include "server/sessions/session_directory.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace wakesurf::server::attendance_test {

namespace {

using namespace std::chrono_literals;

constexpr auto all_gone = 30s; ///< by then nothing is computed

struct EmptySession : testing::Test {
    EmptySession() {
        SessionServices services{loop, pool, datasets, entropy};
        services.clock = &clock;
        services.memory = &memory;
        sessions.emplace(services);
        rake = session().set_rake(tests::rake_at(1))->record.rake;
    }

    Session& session() { return **sessions->find("main"); }

    std::shared_ptr<LiveSurface> live() { return *session().live(surface); }

    void add(core::SurfaceKind kind) {
        auto setting = tests::surface_on(rake);
        setting.parameters.kind = kind;
        surface = session().set_surface(setting)->surface;
    }

    /// Runs jobs and what comes of them for so long by the clock; returns how many there were.
    std::size_t run(std::chrono::milliseconds time) {
        std::size_t jobs = 0;
        for (auto passed = 0ms; passed <= time; passed += 100ms) {
            loop.advance(passed == 0ms ? 0ms : 100ms);
            while (pool.turn()) {
                ++jobs;
                loop.advance(0ms);
            }
        }
        return jobs;
    }

    void play() {
        ASSERT_TRUE(
            session().clock().play({{}, 0.1, true, {}, {}}, session().builds().moving_range()));
    }

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{ComputePool::ByHand{}};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    core::MemoryAccount memory{std::size_t{256} << 20};
    std::optional<SessionDirectory> sessions;
    std::string rake, surface;
};

} // namespace

TEST_F(EmptySession, StopsPlayingAndComputingWithinHalfAMinuteHoweverItWasPlayed) {
    add(core::SurfaceKind::Streak);
    play(); // by a script over HTTP, which never joined
    EXPECT_GT(run(2s), 10U);
    run(all_gone);
    EXPECT_FALSE(session().clock().playing());
    EXPECT_EQ(run(60s), 0U);
    EXPECT_TRUE(live()->resting());
}

TEST_F(EmptySession, GivesItsMemoryBack) {
    add(core::SurfaceKind::Streak);
    play();
    run(2s);
    EXPECT_GT(memory.used(core::MemoryUse::Rings), 0U);
    EXPECT_GT(memory.used(core::MemoryUse::Surfaces), 0U);
    run(all_gone);
    for (const auto use : {core::MemoryUse::Rings, core::MemoryUse::Surfaces,
                           core::MemoryUse::Histories, core::MemoryUse::Builds})
        EXPECT_EQ(memory.used(use), 0U) << static_cast<int>(use);
}

TEST_F(EmptySession, IsOneWhoseLastPersonHasLeftLongEnoughAgo) {
    add(core::SurfaceKind::Streak);
    tests::Onlooker ada;
    const auto place = session().join({"Ada", "", "", {}}, ada);
    ASSERT_TRUE(place);
    play();
    run(3 * all_gone);
    EXPECT_TRUE(session().clock().playing()) << "she looks on";
    session().lose(ada);
    run(10s);
    EXPECT_TRUE(session().clock().playing()) << "she may be reloading the page";
    ASSERT_TRUE(session().join({"", "", place->resume_token, {}}, ada));
    run(all_gone);
    EXPECT_TRUE(session().clock().playing());
    session().leave(ada);
    run(all_gone);
    EXPECT_FALSE(session().clock().playing());
}

TEST_F(EmptySession, IsNoneWhileSomebodyReadsASurfaceOrWaitsOrCalls) {
    add(core::SurfaceKind::Streak);
    play();
    auto reader = live()->ring()->listen([] {});
    run(all_gone);
    EXPECT_TRUE(session().clock().playing()) << "a socket that joined nothing";
    reader.reset();
    auto download = session().attendance().stay();
    run(all_gone);
    EXPECT_TRUE(session().clock().playing()) << "a download";
    download.reset();
    for (int call = 0; call < 6; ++call) {
        run(15s);
        session().attendance().seen();
    }
    EXPECT_TRUE(session().clock().playing()) << "calls";
    run(all_gone);
    EXPECT_FALSE(session().clock().playing());
}

TEST_F(EmptySession, ComputesOnWhatWasInterruptedWhenSomebodyIsBack) {
    add(core::SurfaceKind::Stream); // whose jobs do not run for a while
    loop.advance(all_gone);
    EXPECT_TRUE(live()->resting());
    run(0ms); // the job that waited for its turn is stopped
    EXPECT_TRUE(live()->resting());
    EXPECT_FALSE(live()->outcome().complete);
    session().attendance().seen();
    EXPECT_FALSE(live()->resting());
    run(1s);
    EXPECT_TRUE(live()->outcome().complete);
}

TEST_F(EmptySession, TellsWhatASurfaceWasAndBuildsItAgainOnlyForWhoLooks) {
    add(core::SurfaceKind::Stream);
    run(1s);
    const SurfaceOutcome before = live()->outcome();
    ASSERT_TRUE(before.complete);
    run(all_gone);
    EXPECT_TRUE(live()->resting());
    EXPECT_EQ(live()->outcome().state_sum, before.state_sum);
    session().attendance().seen();
    EXPECT_EQ(run(1s), 0U);
    const auto reader = live()->ring()->listen([] {});
    live()->begin_now();
    EXPECT_GT(run(1s), 0U);
    EXPECT_EQ(live()->outcome().state_sum, before.state_sum);
}

TEST(Attendance, CostsATimerOnlyWhileSomebodyIsThere) {
    HandClock clock;
    HandLoop loop(clock);
    int looks = 0, empty = 0, back = 0;
    Attendance attendance(loop, clock,
                          {[&] {
                               ++looks;
                               return false;
                           },
                           [&] { ++empty; }, [&] { ++back; }});
    loop.advance(60s);
    EXPECT_EQ(looks, 0);
    attendance.seen();
    loop.advance(Attendance::nobody - 1s);
    EXPECT_EQ(empty, 0);
    loop.advance(60min);
    EXPECT_EQ(empty, 1);
    EXPECT_LT(looks, 10);
    EXPECT_EQ(back, 0);
    attendance.seen();
    EXPECT_EQ(back, 1);
}

} // namespace wakesurf::server::attendance_test
