// Surfaces that no one looks at: those a restarted server brought back, and those whose memory others needed, rest as parameters.
#include "core/field/analytic_flow.hpp"
#include "protocol/api/base/json_text.hpp"
#include "server/sessions/session_directory.hpp"
#include "server/sessions/session_exchange.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/hand_loop.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server::resting_surfaces_test {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t many = 24;
constexpr std::size_t mebi = std::size_t{1} << 20;

/// A server whose jobs run by hand, with a journal to restart from.
struct Life {
    explicit Life(const core::Error* withheld = nullptr) {
        SessionServices services{loop, pool, datasets, entropy};
        services.journal = &journal;
        services.clock = &clock;
        services.memory = &memory;
        services.withheld = withheld;
        sessions.emplace(services);
    }

    Session& session() { return **sessions->find("main"); }

    std::shared_ptr<LiveSurface> live(const std::string& id) { return *session().live(id); }

    SurfaceOutcome outcome(const std::string& id) { return live(id)->outcome(); }

    /// Runs all jobs and what comes of them; returns how many there were.
    std::size_t settle() {
        std::size_t jobs = 0;
        loop.advance(milliseconds(0));
        while (pool.turn()) {
            ++jobs;
            loop.advance(milliseconds(0));
        }
        return jobs;
    }

    /// Others need so many bytes more than are free.
    void need(std::size_t bytes) {
        auto share = memory.open(core::MemoryUse::Downloads);
        EXPECT_FALSE(share.grow_to(memory.free() + bytes))
            << "given back on the loop, a moment later";
        loop.advance(milliseconds(0));
    }

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{ComputePool::ByHand{}};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    tests::MemoryJournal journal;
    core::MemoryAccount memory{256 * mebi};
    std::optional<SessionDirectory> sessions;
};

std::vector<std::string> add_surfaces(Life& life, std::size_t count) {
    const std::string rake = life.session().set_rake(tests::rake_at(1))->record.rake;
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < count; ++i)
        ids.push_back(life.session().set_surface(tests::surface_on(rake))->surface);
    return ids;
}

std::shared_ptr<void> look_at(LiveSurface& live) {
    auto ticket = live.ring()->listen([] {});
    live.begin_now();
    return ticket;
}

struct RestoredSurfaces : testing::Test {
    explicit RestoredSurfaces(const core::Error* withheld = nullptr) : after(withheld) {
        Life before;
        ids = add_surfaces(before, many);
        after.sessions->restore("main", "main", before.journal.entries("main"));
    }

    std::vector<std::string> ids;
    Life after;
};

const core::Error died{core::Error::Code::Cancelled, "the server died", "set it again"};

struct WithheldSurfaces : RestoredSurfaces {
    WithheldSurfaces() : RestoredSurfaces(&died) {}
};

} // namespace

TEST(HiddenSurfaces, AreNotComputedForEditsUntilSomebodyShowsThem) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    auto looking = look_at(*life.live(id));
    EXPECT_GT(life.settle(), 0U);
    const std::uint32_t before = life.outcome(id).state_sum;
    looking.reset();
    life.live(id)->turned_away();
    life.loop.advance(milliseconds(2100));
    const std::string rake = life.session().records().all<protocol::RakeRecord>().begin()->first;
    ASSERT_TRUE(life.session().set_rake(tests::rake_at(1.5, rake)));
    EXPECT_EQ(life.settle(), 0U);
    EXPECT_FALSE(life.live(id)->busy());
    EXPECT_FALSE(life.outcome(id).complete);
    looking = look_at(*life.live(id));
    EXPECT_GT(life.settle(), 0U);
    EXPECT_TRUE(life.outcome(id).complete);
    EXPECT_NE(life.outcome(id).state_sum, before);
}

TEST(HiddenSurfaces, AreGivenUpInTheMiddleAndGoOnWhenShown) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    auto looking = look_at(*life.live(id));
    looking.reset();
    life.live(id)->turned_away();
    life.loop.advance(milliseconds(2100));
    life.settle(); // what had been begun
    EXPECT_FALSE(life.outcome(id).complete);
    looking = look_at(*life.live(id));
    life.settle();
    EXPECT_TRUE(life.outcome(id).complete);
}

TEST(HiddenSurfaces, AreComputedWhileOthersShowOrAwaitThem) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    auto one = look_at(*life.live(id));
    auto other = look_at(*life.live(id));
    one.reset();
    life.live(id)->turned_away();
    life.loop.advance(milliseconds(2100));
    life.settle();
    EXPECT_TRUE(life.outcome(id).complete);
    other.reset();
    const std::string rake = life.session().records().all<protocol::RakeRecord>().begin()->first;
    ASSERT_TRUE(life.session().set_rake(tests::rake_at(1.5, rake)));
    EXPECT_EQ(life.settle(), 0U) << "the other is gone too";
    bool answered = false;
    life.live(id)->wait(0, milliseconds(60'000), [&](const auto& outcome) {
        answered = outcome.has_value() && outcome->complete;
    });
    life.settle();
    EXPECT_TRUE(answered);
}

TEST(HiddenSurfaces, AreComputedOnForAMomentInWhichSomebodyMayShowThemAgain) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    look_at(*life.live(id)).reset();
    life.live(id)->turned_away();
    EXPECT_GT(life.settle(), 0U);
    EXPECT_TRUE(life.outcome(id).complete);
}

TEST_F(RestoredSurfaces, AreNotBuiltUntilSomebodyLooks) {
    EXPECT_EQ(after.settle(), 0U);
    EXPECT_EQ(after.memory.used(core::MemoryUse::Surfaces), 0U);
    const auto looking = look_at(*after.live(ids[7]));
    EXPECT_GT(after.settle(), 0U);
    for (const std::string& id : ids)
        EXPECT_EQ(after.outcome(id).complete, id == ids[7]) << id;
}

TEST_F(RestoredSurfaces, AreBuiltForWhoeverWaitsForThem) {
    bool answered = false;
    after.live(ids[3])->wait(0, milliseconds(60'000), [&](const auto& outcome) {
        answered = outcome.has_value() && outcome->complete;
    });
    after.settle();
    EXPECT_TRUE(answered);
    EXPECT_FALSE(after.outcome(ids[4]).complete);
}

TEST_F(RestoredSurfaces, ThatAreEditedAreBuiltAtOnce) {
    auto& session = after.session();
    const std::string rake = session.records().all<protocol::RakeRecord>().begin()->first;
    ASSERT_TRUE(session.set_surface(tests::surface_on(rake, ids[5])));
    after.settle();
    EXPECT_TRUE(after.outcome(ids[5]).complete);
    EXPECT_FALSE(after.outcome(ids[6]).complete);
}

TEST_F(RestoredSurfaces, RestAlsoWhenTheirDataComeLater) {
    Life later;
    later.datasets.there = false;
    later.sessions->restore("main", "main", after.journal.entries("main"));
    later.settle();
    later.datasets.there = true;
    later.sessions->dataset_changed("abc");
    EXPECT_EQ(later.settle(), 0U);
    const auto looking = look_at(*later.live(ids[0]));
    later.settle();
    EXPECT_TRUE(later.outcome(ids[0]).complete);
}

TEST_F(RestoredSurfaces, ThatWereLookedAtBeforeTheirDataCameAreBuiltThen) {
    Life later;
    later.datasets.there = false;
    later.sessions->restore("main", "main", after.journal.entries("main"));
    const auto looking = look_at(*later.live(ids[0]));
    later.settle();
    later.datasets.there = true;
    later.sessions->dataset_changed("abc");
    later.settle();
    EXPECT_TRUE(later.outcome(ids[0]).complete);
    EXPECT_FALSE(later.outcome(ids[1]).complete);
}

TEST(ImportedSurfaces, AreNotBuiltUntilSomebodyLooks) {
    Life life;
    const auto ids = add_surfaces(life, many);
    life.settle();
    const auto text = protocol::json_text(
        protocol::session_file_json(file_of(snapshot_of(life.session(), life.datasets, 0))));
    auto read = read_session_text(text);
    ASSERT_TRUE(read) << read.error().message;
    const auto imported = life.sessions->import(std::move(read->records), "twin");
    ASSERT_TRUE(imported);
    EXPECT_EQ(life.settle(), 0U);
    const auto live = *(*imported)->live(ids[7]);
    const auto looking = look_at(*live);
    life.settle();
    EXPECT_TRUE(live->outcome().complete);
    EXPECT_EQ(live->outcome().state_sum, life.outcome(ids[7]).state_sum)
        << "the same as where it comes from";
    EXPECT_FALSE((*(*imported)->live(ids[8]))->outcome().complete);
}

TEST_F(WithheldSurfaces, AreNotBuiltThoughSomebodyLooksAndSayWhy) {
    const auto looking = look_at(*after.live(ids[0]));
    EXPECT_EQ(after.settle(), 0U);
    after.sessions->dataset_changed("abc");
    EXPECT_EQ(after.settle(), 0U);
    ASSERT_TRUE(after.outcome(ids[0]).error);
    EXPECT_EQ(after.outcome(ids[0]).error->message, died.message);
}

TEST_F(WithheldSurfaces, AreBuiltOnceSomebodySetsThemOrMovesTheirRake) {
    auto& session = after.session();
    const std::string rake = session.records().all<protocol::RakeRecord>().begin()->first;
    ASSERT_TRUE(session.set_surface(tests::surface_on(rake, ids[0])));
    after.settle();
    EXPECT_TRUE(after.outcome(ids[0]).complete);
    EXPECT_FALSE(after.outcome(ids[1]).complete);
    ASSERT_TRUE(session.set_rake(tests::rake_at(2, rake)));
    after.settle();
    EXPECT_TRUE(after.outcome(ids[1]).complete);
}

TEST(IdleSurface, FallsBackToItsParametersWhenOthersNeedMemoryAndIsBuiltAgainBitForBit) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    life.settle();
    const SurfaceOutcome built = life.outcome(id);
    ASSERT_TRUE(built.complete);
    ASSERT_GT(life.memory.used(), 0U);
    life.need(mebi);
    EXPECT_TRUE(life.live(id)->resting());
    EXPECT_EQ(life.memory.used(), life.memory.used(core::MemoryUse::Records))
        << "all of it has been given back";
    EXPECT_TRUE(life.outcome(id).complete) << "what it was is still told";
    EXPECT_EQ(life.outcome(id).state_sum, built.state_sum);

    const auto looking = look_at(*life.live(id));
    EXPECT_FALSE(life.outcome(id).complete) << "it is being built again";
    life.settle();
    EXPECT_TRUE(life.outcome(id).complete);
    EXPECT_EQ(life.outcome(id).state_sum, built.state_sum);
    EXPECT_EQ(life.outcome(id).epoch, built.epoch) << "nothing was edited";
    ASSERT_TRUE(life.live(id)->ring()->first()) << "a new reader begins with a keyframe";
}

TEST(IdleSurface, GoesOnAboveTheUpdatesThatWereSentBefore) {
    Life life;
    const std::string id = add_surfaces(life, 1).front();
    life.settle();
    const std::uint32_t before = life.live(id)->newest()->wire.seq;
    life.need(mebi);
    const auto looking = look_at(*life.live(id));
    life.settle();
    EXPECT_GT(life.live(id)->newest()->wire.seq, before);
    const SharedUpdate next = life.live(id)->ring()->after(before);
    ASSERT_TRUE(next);
    EXPECT_TRUE(next->wire.key) << "for a reader that holds the state of before";
}

TEST(IdleSurface, OfATimeThatTheClockHasLeftIsBuiltForTheNewOne) {
    Life life;
    const std::string rake = life.session().set_rake(tests::rake_at(1))->record.rake;
    auto setting = tests::surface_on(rake);
    setting.parameters.kind = core::SurfaceKind::Streak;
    setting.parameters.to = 1.0;
    setting.parameters.separation = 0.2;
    const std::string id = life.session().set_surface(setting)->surface;
    life.live(id)->show(0.5, false, true);
    life.settle();
    const SurfaceOutcome half = life.outcome(id);
    ASSERT_TRUE(half.complete);
    life.need(mebi);
    ASSERT_TRUE(life.live(id)->resting());
    life.live(id)->show(1.0, false, true);
    EXPECT_FALSE(life.outcome(id).complete);
    life.live(id)->show(0.5, false, true);
    const auto looking = look_at(*life.live(id));
    life.settle();
    EXPECT_EQ(life.outcome(id).state_sum, half.state_sum)
        << "the same at the same time, however it came there";
}

TEST(IdleSurface, StaysAsLongAsSomebodyLooksAtItOrWaits) {
    Life life;
    const auto ids = add_surfaces(life, 3);
    const auto looking = look_at(*life.live(ids[1]));
    life.settle();
    life.need(mebi);
    EXPECT_TRUE(life.live(ids[0])->resting());
    EXPECT_FALSE(life.live(ids[1])->resting());
    EXPECT_TRUE(life.live(ids[2])->resting());
    EXPECT_TRUE(life.outcome(ids[1]).complete);
}

TEST(IdleSurface, ThatNobodyAskedForLongestGoesFirstAndNoMoreThanAreNeeded) {
    Life life;
    const auto ids = add_surfaces(life, 3);
    life.settle();
    life.clock.time += std::chrono::seconds(1);
    life.live(ids[0])->begin_now(); // somebody came, and left
    for (std::size_t i = 0; i < ids.size(); ++i) {
        life.need(1);
        for (const std::string& id : ids)
            EXPECT_FALSE(life.live(id)->resting())
                << "updates that are no longer the newest go first";
    }
    life.need(1);
    EXPECT_FALSE(life.live(ids[0])->resting());
    EXPECT_TRUE(life.live(ids[1])->resting());
    EXPECT_FALSE(life.live(ids[2])->resting());
}

TEST(Surface, ThatDoesNotFitIntoMemoryEndsWithAnErrorThatNamesTheLimitAndIsNeverCoarserInSilence) {
    Life life;
    const std::string rake = life.session().set_rake(tests::rake_at(1))->record.rake;
    auto setting = tests::surface_on(rake);
    setting.parameters.to = 20.0;
    setting.parameters.separation = 0.004;
    setting.parameters.max_quads = 4'000'000;
    const std::string id = life.session().set_surface(setting)->surface;
    auto others = life.memory.open(core::MemoryUse::TimeSteps);
    others.set(life.memory.budget() - 40 * mebi);
    life.settle();
    const SurfaceOutcome outcome = life.outcome(id);
    EXPECT_FALSE(outcome.complete);
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code, core::Error::Code::OverLimit);
    EXPECT_EQ(outcome.error->limit, life.memory.budget());
    EXPECT_NE(outcome.error->message.find("4000000 quads"), std::string::npos);
    EXPECT_NE(outcome.error->message.find("256 MiB of --memory"), std::string::npos);
    EXPECT_NE(outcome.error->hint.find("separation"), std::string::npos);
    EXPECT_EQ(life.memory.used(core::MemoryUse::Builds), 0U) << "what it took is given back";
    // A smaller one has room.
    setting.surface = id;
    setting.parameters.separation = 0.2;
    ASSERT_TRUE(life.session().set_surface(setting));
    life.settle();
    EXPECT_TRUE(life.outcome(id).complete);
}

TEST(Session, WithAsManySurfacesAsItMayHaveStaysWithinMemoryThoughTogetherTheyNeedManyTimesThat) {
    tests::HandLoop loop;
    ComputePool pool{2};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    const core::MemoryAccount memory(24 * mebi);
    SessionServices services{loop, pool, datasets, entropy};
    services.memory = &memory;
    SessionDirectory sessions(services);
    const auto session = *sessions.find("main");
    const std::string rake = session->set_rake(tests::rake_at(1))->record.rake;
    auto setting = tests::surface_on(rake);
    setting.parameters.to = 2.0;
    setting.parameters.separation = 0.02;
    setting.parameters.max_quads = 4'000'000;
    std::size_t highest = 0, needed = 0;
    for (int i = 0; i < 64; ++i) {
        const std::string id = session->set_surface(setting)->surface;
        const auto live = *session->live(id);
        loop.turn_until([&] {
            highest = std::max(highest, memory.used());
            return live->outcome().complete || live->outcome().error;
        });
        EXPECT_TRUE(live->outcome().complete) << i << ": those before gave back what it needs";
        needed += live->ring()->bytes();
    }
    EXPECT_LE(highest, memory.budget());
    EXPECT_GT(memory.used(), 0U);
    EXPECT_GT(needed, 0U);
}

} // namespace wakesurf::server::resting_surfaces_test
