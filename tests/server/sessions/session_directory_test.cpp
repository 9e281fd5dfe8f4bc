// Which sessions there are: no one's work goes away by itself, what is deleted can be brought back, and limits are refusals.
#include "server/base/limits.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/session_exchange.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::session_directory_test {

namespace {

using core::Error;
using namespace std::chrono_literals;

constexpr std::size_t sessions = server::limits::kept_sessions;

/// What a page does on its first visit.
void visit(server::Session& session, const server::Author& by) {
    server::Author page = by;
    page.default_scene = true;
    ASSERT_TRUE(session.set_rake(rake_at(0), page));
    ASSERT_TRUE(session.set_surface(surface_on("r1"), page));
}

void fill(SessionBench& bench) {
    while (bench.sessions.remaining() > 0)
        ASSERT_TRUE(bench.sessions.create("wanted"));
}

struct Restarted {
    explicit Restarted(const SessionBench& before) {
        bench.wall = before.wall;
        bench.journal.sessions = before.journal.sessions;
        std::map<std::string, std::vector<server::JournalEntry>> kept;
        for (const auto& [id, entries] : before.journal.sessions)
            kept[id] = before.journal.entries(id);
        report = server::restore_sessions(kept, bench.sessions, grants);
    }

    SessionBench bench;
    server::Grants grants{
        {bench.loop, bench.loop, bench.entropy, [this] { return bench.wall; }, &bench.journal}};
    server::RestoredSessions report;
};

} // namespace

TEST(SessionDirectory, KeepsTheThesisHoweverOftenThePageIsVisited) {
    SessionBench bench;
    const auto thesis = *bench.sessions.create("Thesis figure 4 - do not lose");
    ASSERT_TRUE(thesis->set_rake(rake_at(0), bench.ada));
    const auto records = thesis->records().list();
    for (std::size_t i = 0; i < 2 * sessions; ++i) {
        const auto made = bench.sessions.create("");
        ASSERT_TRUE(made);
        visit(**made, bench.bob);
    }
    EXPECT_EQ(bench.sessions.all().size(), sessions);
    ASSERT_TRUE(bench.sessions.find(thesis->id()));
    EXPECT_EQ((*bench.sessions.find(thesis->id()))->records().list(), records);
    EXPECT_FALSE(bench.journal.entries(thesis->id()).empty());
}

TEST(SessionDirectory, KeepsASessionThatWasEditedOnceWithoutANameOrAnybodyInIt) {
    SessionBench bench;
    const auto edited = *bench.sessions.create("");
    visit(*edited, bench.ada);
    EXPECT_FALSE(edited->profile().edited);
    ASSERT_TRUE(edited->set_rake(rake_at(1, "r1"), bench.ada));
    EXPECT_TRUE(edited->profile().edited);
    fill(bench);
    EXPECT_EQ(bench.sessions.create("one more").error().code, Error::Code::OverLimit);
    EXPECT_TRUE(bench.sessions.find(edited->id()));
}

TEST(SessionDirectory, GivesUpOnlyWhatNobodyEditedNamedOrIsInTheLongestUnusedFirst) {
    SessionBench bench;
    std::vector<std::string> gone;
    bench.sessions.on_gone([&](const std::string& id) { gone.push_back(id); });
    const auto late = *bench.sessions.create("");
    const auto early = *bench.sessions.create("");
    const auto shared = *bench.sessions.create("");
    shared->made_on_purpose();
    const auto used = *bench.sessions.create("");
    Onlooker someone;
    ASSERT_TRUE(used->join({"Ada", "", "", {}}, someone));
    bench.wall += 60;
    Onlooker visitor;
    ASSERT_TRUE(late->join({"Bob", "", "", {}}, visitor));
    late->leave(visitor);
    const auto left = bench.sessions.remaining();
    EXPECT_EQ(left, sessions - 3) << "main, the shared and the used one stay";
    fill(bench);
    EXPECT_EQ(gone, (std::vector{early->id(), late->id()}));
    EXPECT_FALSE(bench.journal.sessions.contains(early->id()));
    EXPECT_EQ(bench.sessions.create("too many").error().limit, sessions);
    EXPECT_TRUE(bench.sessions.find(used->id()));
    EXPECT_TRUE(bench.sessions.find(shared->id()));
    used->leave(someone);
}

TEST(SessionDirectory, AClockStopsOnceNobodyIsThereToLook) {
    SessionBench bench;
    Onlooker ada;
    const auto place = bench.session->join({"Ada", "", "", {}}, ada);
    ASSERT_TRUE(bench.session->clock().play({{}, 1.0, true, 0.0, 10.0}, std::nullopt));
    bench.session->lose(ada);
    bench.loop.pass(5s);
    ASSERT_TRUE(bench.session->join({"", "", place->resume_token, {}}, ada));
    bench.loop.pass(60s);
    EXPECT_TRUE(bench.session->clock().playing()) << "a reload of the page is no leaving";
    bench.session->leave(ada);
    bench.loop.pass(60s);
    EXPECT_FALSE(bench.session->clock().playing());
}

TEST(SessionDirectory, TellsHowManyMoreThereMayBeBeforeItRefuses) {
    SessionBench bench;
    EXPECT_EQ(bench.sessions.remaining(), sessions - 1) << "main is one";
    fill(bench);
    const auto refused = bench.sessions.create("one more");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::OverLimit);
    EXPECT_NE(refused.error().hint.find("session.delete"), std::string::npos);
    EXPECT_EQ(bench.sessions.fork("main", "").error().code, Error::Code::OverLimit);
}

TEST(SessionDirectory, BringsADeletedSessionBackAsItWas) {
    SessionBench bench;
    const auto session = *bench.sessions.create("vortex");
    const std::string id = session->id();
    Onlooker ada;
    const auto place = session->join({"Ada", "", "", {}}, ada);
    ASSERT_TRUE(session->set_rake(rake_at(0), bench.ada));
    ASSERT_TRUE(session->set_surface(surface_on("r1"), bench.ada));
    ASSERT_TRUE(session->set_annotation(note("here"), bench.ada));
    const auto records = content(session->records());
    const auto until = bench.sessions.remove(id);
    ASSERT_TRUE(until) << until.error().message;
    EXPECT_EQ(*until, bench.wall + 30 * 24 * 3600);
    EXPECT_TRUE(session->participants().present().empty()) << "everyone was sent away";
    EXPECT_EQ(bench.sessions.find(id).error().code, Error::Code::NotFound);
    EXPECT_NE(bench.sessions.find(id).error().hint.find("session.restore"), std::string::npos);
    const auto back = bench.sessions.bring_back(id);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(content((*back)->records()), records);
    EXPECT_EQ((*back)->name(), "vortex");
    EXPECT_FALSE((*back)->profile().deleted);
    EXPECT_EQ((*back)->profile().people.front().name, "Ada");
    const auto again = (*back)->join({"", "", place->resume_token, {}}, ada);
    EXPECT_TRUE(again->returned);
    EXPECT_EQ(again->you.id, place->you.id);
    (*back)->leave(ada);
    EXPECT_EQ(bench.sessions.bring_back(id).error().code, Error::Code::NotFound);
}

TEST(SessionDirectory, KeepsTheTrashWhereTheClockIsWrongAtTheStart) {
    SessionBench bench;
    const auto deleted = *bench.sessions.create("deleted");
    ASSERT_TRUE(bench.sessions.remove(deleted->id()));
    constexpr std::int64_t month = 31 * 24 * 3600;
    bench.wall += month;
    Restarted after(bench);
    after.bench.pass(1h);
    after.bench.wall -= month; // as when the network says what time it is
    after.bench.pass(5h);
    EXPECT_NE(after.bench.sessions.trash().find(deleted->id()), nullptr);
    after.bench.wall += month;
    after.bench.pass(3h);
    EXPECT_EQ(after.bench.sessions.trash().find(deleted->id()), nullptr);
}

TEST(SessionDirectory, HasTheTrashAfterARestartAndPurgesItByTheWallClock) {
    SessionBench bench;
    const auto kept = *bench.sessions.create("kept");
    const auto lost = *bench.sessions.create("lost");
    ASSERT_TRUE(kept->set_rake(rake_at(0), bench.ada));
    ASSERT_TRUE(bench.sessions.remove(lost->id()));
    bench.pass(24h);
    ASSERT_TRUE(bench.sessions.remove(kept->id()));
    bench.pass(28 * 24h);

    Restarted after(bench);
    EXPECT_TRUE(after.report.refused.empty());
    EXPECT_EQ(after.bench.sessions.trash().all().size(), 2u);
    EXPECT_FALSE(after.bench.sessions.find(kept->id()));
    after.bench.pass(25h);
    EXPECT_EQ(after.bench.sessions.trash().find(lost->id()), nullptr) << "30 days are over";
    EXPECT_FALSE(after.bench.journal.sessions.contains(lost->id()));
    const auto back = after.bench.sessions.bring_back(kept->id());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ((*back)->records().count(server::RecordType::Rake), 1u);

    Restarted once_more(after.bench);
    EXPECT_TRUE(once_more.bench.sessions.find(kept->id())) << "it stays restored";
    EXPECT_TRUE(once_more.bench.sessions.trash().all().empty());
}

TEST(SessionDirectory, ErasesForGoodOnlyWhatIsInTheTrash) {
    SessionBench bench;
    const std::string id = (*bench.sessions.create("gone"))->id();
    EXPECT_EQ(bench.sessions.erase(id).error().code, Error::Code::NotFound);
    ASSERT_TRUE(bench.sessions.remove(id));
    EXPECT_TRUE(bench.sessions.erase(id));
    EXPECT_FALSE(bench.journal.sessions.contains(id));
    EXPECT_EQ(bench.sessions.bring_back(id).error().code, Error::Code::NotFound);
    EXPECT_NE((*bench.sessions.create("new"))->id(), id) << "ids are given once";
}

TEST(SessionDirectory, RefusesToDeleteMainAndWhatATrashThatIsFullCannotTake) {
    SessionBench bench;
    EXPECT_EQ(bench.sessions.remove("main").error().code, Error::Code::InvalidArgument);
    for (std::size_t i = 0; i < server::limits::trash; ++i)
        ASSERT_TRUE(bench.sessions.remove((*bench.sessions.create("x"))->id()));
    const auto one_more = *bench.sessions.create("one more");
    EXPECT_EQ(bench.sessions.remove(one_more->id()).error().limit, server::limits::trash);
    EXPECT_TRUE(bench.sessions.find(one_more->id()));
}

TEST(SessionDirectory, ADeletedSessionWritesNothingMoreWhoeverStillHoldsIt) {
    SessionBench bench;
    const auto session = *bench.sessions.create("held");
    ASSERT_TRUE(session->set_rake(rake_at(0), bench.ada));
    ASSERT_TRUE(bench.sessions.remove(session->id()));
    ASSERT_TRUE(bench.sessions.erase(session->id()));
    EXPECT_TRUE(session->set_rake(rake_at(1), bench.ada));
    session->rename("late");
    EXPECT_FALSE(bench.journal.sessions.contains(session->id()));
}

TEST(SessionDirectory, SharedSessionsAreKeptAndTheirLinksRestWhileTheyAreInTheTrash) {
    SessionBench before;
    const auto session = *before.sessions.create("shared");
    const std::string id = session->id();
    {
        server::Grants grants{{before.loop, before.loop, before.entropy,
                               [&] { return before.wall; }, &before.journal}};
        const auto link = grants.make(id, server::Role::Editor, std::chrono::hours(24 * 365));
        ASSERT_TRUE(before.sessions.remove(id));
        grants.suspend(id);
        EXPECT_FALSE(grants.find(link->key));
        Restarted after(before);
        EXPECT_FALSE(after.grants.find(link->key)) << "also after a restart";
        ASSERT_TRUE(after.bench.sessions.bring_back(id));
        after.grants.resume(id);
        EXPECT_TRUE(after.grants.find(link->key));
    }
}

TEST(SessionDirectory, RemembersPeopleAndLastUseAcrossRestarts) {
    SessionBench bench;
    Onlooker ada;
    Onlooker bob;
    ASSERT_TRUE(bench.session->join({"Ada", "#112233", "", {}}, ada));
    bench.session->leave(ada);
    bench.wall += 1000;
    ASSERT_TRUE(bench.session->join({"Bob", "", "", {}}, bob));
    bench.session->leave(bob);
    const std::int64_t left = bench.wall;
    bench.wall += 1000;
    Restarted after(bench);
    const auto& profile = after.bench.session->profile();
    EXPECT_EQ(profile.last_used, left);
    ASSERT_EQ(profile.people.size(), 2u);
    EXPECT_EQ(profile.people[0].name, "Bob");
    EXPECT_EQ(profile.people[1].name, "Ada");
    EXPECT_EQ(profile.people[1].colour, "#112233");
    EXPECT_FALSE(profile.edited);
}

TEST(SessionDirectory, WhatAnOlderWakesurfKeptCountsAsSomebodysWork) {
    SessionBench before;
    const auto session = *before.sessions.create("");
    visit(*session, before.ada);
    before.journal.sessions[session->id()].erase({"profile", ""});
    Restarted after(before);
    const auto back = after.bench.sessions.find(session->id());
    ASSERT_TRUE(back);
    EXPECT_TRUE((*back)->profile().edited);
    EXPECT_FALSE((*back)->profile().created) << "no one noted it";
}

TEST(SessionDirectory, TheDefaultSceneIsNobodysEditAndOnlyForASessionThatHasNone) {
    SessionBench bench;
    server::Author page = bench.ada;
    page.default_scene = true;
    EXPECT_TRUE(bench.session->set_rake(rake_at(0), page));
    EXPECT_EQ(bench.session->set_rake(rake_at(0), page).error().code, Error::Code::InvalidArgument)
        << "another page was first";
    EXPECT_TRUE(bench.session->set_surface(surface_on("r1"), page));
    EXPECT_FALSE(bench.session->set_surface(surface_on("r1"), page));
    EXPECT_FALSE(bench.session->profile().edited);
    EXPECT_TRUE(
        bench.session->move_in_history(server::HistoryMove::Undo, bench.ada).changes.empty());
    ASSERT_TRUE(bench.session->remove({server::RecordType::Rake, "r1"}, bench.ada));
    EXPECT_FALSE(bench.session->set_rake(rake_at(0), page)) << "someone emptied it on purpose";
    Restarted after(bench);
    EXPECT_TRUE(after.bench.session->profile().edited);
}

TEST(SessionDirectory, ANewNameIsToldAndKept) {
    SessionBench bench;
    Onlooker ada;
    ASSERT_TRUE(bench.session->join({"Ada", "", "", {}}, ada));
    bench.session->rename("our wake");
    EXPECT_EQ(ada.name, "our wake");
    EXPECT_TRUE(ada.in_order);
    bench.session->leave(ada);
    Restarted after(bench);
    EXPECT_EQ(after.bench.session->name(), "our wake");
}

} // namespace wakesurf::tests::session_directory_test
