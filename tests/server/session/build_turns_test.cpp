// A restarted server with many surfaces: they are built a few at a time, those that somebody looks at first.
#include "core/field/analytic_flow.hpp"
#include "server/limits.hpp"
#include "server/session/build_turns.hpp"
#include "server/session/session_directory.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t many = 24;

/// A server whose jobs run by hand, with a journal to restart from.
struct Life {
    Life() { sessions.emplace(services()); }

    SessionServices services() {
        SessionServices out{loop, pool, datasets, entropy};
        out.journal = &journal;
        out.clock = &clock;
        return out;
    }

    Session& session() { return **sessions->find("main"); }

    /// Runs all that waits for a thread now, and none of what comes of it.
    std::size_t run_queued() {
        std::size_t jobs = 0;
        while (pool.turn())
            ++jobs;
        loop.advance(milliseconds(0));
        return jobs;
    }

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{ComputePool::ByHand{}};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    tests::MemoryJournal journal;
    std::optional<SessionDirectory> sessions;
};

class RestoredSurfaces : public testing::Test {
  protected:
    RestoredSurfaces() {
        Life before;
        const std::string rake = before.session().set_rake(tests::rake_at(1))->record.rake;
        for (std::size_t i = 0; i < many; ++i)
            ids.push_back(before.session().set_surface(tests::surface_on(rake))->surface);
        after.sessions->restore("main", "main", before.journal.entries("main"));
        after.loop.advance(milliseconds(0));
    }

    std::shared_ptr<LiveSurface> live(const std::string& id) { return *after.session().live(id); }

    bool complete(const std::string& id) { return live(id)->outcome().complete; }

    std::vector<std::string> ids;
    Life after;
};

} // namespace

TEST(BuildTurns, GivesSoManyTurnsAtATimeInOrder) {
    HandClock clock;
    HandLoop loop(clock);
    BuildTurns turns(loop, 2);
    std::vector<int> begun;
    std::vector<std::shared_ptr<void>> tickets;
    for (int i = 0; i < 5; ++i)
        turns.queue([&, i](std::shared_ptr<void> ticket) {
            begun.push_back(i);
            if (i != 3) // 3 has nothing to do
                tickets.push_back(std::move(ticket));
        });
    EXPECT_TRUE(begun.empty());
    loop.advance(milliseconds(0));
    EXPECT_EQ(begun, (std::vector{0, 1}));
    tickets[1].reset();
    loop.advance(milliseconds(0));
    EXPECT_EQ(begun, (std::vector{0, 1, 2}));
    tickets.clear();
    loop.advance(milliseconds(0));
    EXPECT_EQ(begun, (std::vector{0, 1, 2, 3, 4}));
}

TEST_F(RestoredSurfaces, AreAllBuiltThoughNobodyAsksAFewAtATime) {
    for (int round = 0; round < 1000; ++round) {
        const std::size_t jobs = after.run_queued();
        EXPECT_LE(jobs, limits::restoring);
        if (jobs == 0)
            break;
    }
    for (const std::string& id : ids)
        EXPECT_TRUE(complete(id)) << id;
}

TEST_F(RestoredSurfaces, ThatSomebodyLooksAtOrWaitsForGoFirst) {
    const auto looked_at = live(ids[many - 1]);
    looked_at->begin_now();
    bool answered = false;
    live(ids[many - 2])->wait(0, milliseconds(60'000), [&](const auto& outcome) {
        answered = outcome.has_value() && outcome->complete;
    });
    std::size_t jobs = 0;
    while (!(complete(ids[many - 1]) && answered) && jobs < many)
        jobs += after.run_queued();
    EXPECT_TRUE(answered);
    EXPECT_LT(jobs, many) << "not behind the others";
    EXPECT_FALSE(complete(ids[many - 3]));
}

TEST_F(RestoredSurfaces, DoNotStandBeforeTheFirstEdit) {
    auto& session = after.session();
    const std::string rake = session.set_rake(tests::rake_at(2))->record.rake;
    const std::string edited = session.set_surface(tests::surface_on(rake))->surface;
    std::size_t jobs = 0;
    while (!live(edited)->newest() && jobs < many) {
        ASSERT_TRUE(after.pool.turn());
        after.loop.advance(milliseconds(0));
        ++jobs;
    }
    EXPECT_LE(jobs, limits::restoring + 1);
}

TEST_F(RestoredSurfaces, ThatAreEditedOrDeletedBeforeTheirTurnHoldUpNobody) {
    auto& session = after.session();
    const std::string rake = session.rakes().front().rake;
    ASSERT_TRUE(session.set_surface(tests::surface_on(rake, ids[5])));
    for (std::size_t i = 6; i < many; i += 2)
        ASSERT_TRUE(session.delete_surface(ids[i]));
    while (after.run_queued() > 0)
        continue;
    for (std::size_t i = 0; i < many; ++i)
        if (i < 6 || i % 2 == 1) {
            EXPECT_TRUE(complete(ids[i])) << ids[i];
        }
}

} // namespace wakesurf::server
