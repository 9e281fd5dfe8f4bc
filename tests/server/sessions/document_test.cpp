// The records of a session under edits of several people: what onlookers fold and what the journal keeps is what the
// session has.
#include "server/base/limits.hpp"
#include "server/sessions/records/colours.hpp"
#include "tests/support/server/random_edits.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::document_test {

using core::Error;
using server::RecordType;

namespace {

bool sound(const server::SessionRecords& records) {
    for (const auto& [id, surface] : records.all<protocol::SurfaceRecord>())
        if (!records.holds_rakes_of(surface) || surface.epoch == 0)
            return false;
    return true;
}

} // namespace

TEST(Document, OnlookersThatFoldThePatchesHaveTheSessionsRecords) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SessionBench bench;
        RandomEdits edits(bench, seed);
        Onlooker onlooker;
        ASSERT_TRUE(bench.session->participants().join({"onlooker", "", "", {}}, onlooker));
        std::map<server::RecordKey, std::uint64_t> revs;
        for (int i = 0; i < 150; ++i) {
            edits.step();
            const server::SessionRecords& records = bench.session->records();
            ASSERT_EQ(onlooker.records.list(), records.list()) << "seed " << seed << ", edit " << i;
            ASSERT_TRUE(sound(records)) << "seed " << seed << ", edit " << i;
            for (const server::Record& each : records.list()) {
                std::uint64_t& before = revs[server::key_of(each)];
                ASSERT_GE(server::rev_of(each), before) << "a revision goes back: seed " << seed;
                before = server::rev_of(each);
            }
        }
        EXPECT_TRUE(onlooker.in_order);
        EXPECT_EQ(onlooker.seq, bench.session->seq());
        EXPECT_GT(revs.size(), 10u);
        bench.session->participants().leave(onlooker);
    }
}

TEST(Document, RestoredFromTheJournalAfterAnyEditItIsTheSameSession) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SessionBench before;
        RandomEdits edits(before, seed);
        for (int round = 0; round < 5; ++round) {
            for (int i = 0; i < 25; ++i)
                edits.step();
            SessionBench after;
            const auto report =
                after.sessions.restore("main", "main", before.journal.entries("main"));
            EXPECT_TRUE(report.refused.empty());
            const server::SessionRecords& old = before.session->records();
            const server::SessionRecords& now = after.session->records();
            EXPECT_EQ(report.restored, old.list().size());
            ASSERT_EQ(content(now), content(old)) << "seed " << seed;
            for (const RecordType type : server::record_types)
                EXPECT_EQ(now.next_number(type), old.next_number(type)) << server::name(type);
            EXPECT_GT(after.session->seq(), before.session->seq());
            for (const auto& [id, surface] : now.all<protocol::SurfaceRecord>())
                EXPECT_GT(surface.epoch, old.find<protocol::SurfaceRecord>(id)->epoch);
            EXPECT_EQ(content(after.session->records()), content(now));
            SessionBench again; // restored twice without an edit between
            again.sessions.restore("main", "main", after.journal.entries("main"));
            EXPECT_EQ(content(again.session->records()), content(old));
            for (const auto& [id, surface] :
                 again.session->records().all<protocol::SurfaceRecord>())
                EXPECT_GT(surface.epoch, now.find<protocol::SurfaceRecord>(id)->epoch);
        }
    }
}

TEST(Document, RakesKeepColourAndAuthorWhenTheyAreUndoneForkedAndRestored) {
    SessionBench bench;
    auto setting = rake_at(1.0);
    setting.colour = "#123456";
    const std::string id = bench.session->set_rake(setting, bench.ada)->record.rake;
    const auto is_adas = [&](const server::Session& session) {
        const auto rake = session.records().get<protocol::RakeRecord>(id);
        return rake && rake->colour == "#123456" && rake->author == "Ada";
    };
    setting = rake_at(1.0, id);
    setting.colour = "#654321";
    ASSERT_TRUE(bench.session->set_rake(setting, bench.bob));
    ASSERT_FALSE(is_adas(*bench.session));
    (void)bench.session->move_in_history(server::HistoryMove::Undo, bench.bob);
    EXPECT_TRUE(is_adas(*bench.session)) << "an edit undone";
    ASSERT_TRUE(bench.session->remove({RecordType::Rake, id}, bench.bob));
    (void)bench.session->move_in_history(server::HistoryMove::Undo, bench.bob);
    EXPECT_TRUE(is_adas(*bench.session)) << "a deletion undone";
    SessionBench after;
    after.sessions.restore("main", "main", bench.journal.entries("main"));
    EXPECT_TRUE(is_adas(*after.session)) << "restored";
    SessionBench copy;
    copy.session->copy(*bench.session, true);
    EXPECT_TRUE(is_adas(*copy.session)) << "forked";
}

TEST(Document, RakesKeptBeforeTheyHadColoursGetThemInTheOrderOfTheirMaking) {
    SessionBench old;
    std::vector<server::JournalEntry> entries;
    for (const int number : {10, 2, 1, 11})
        entries.push_back({"rake", "r" + std::to_string(number),
                           R"({"rake":"r)" + std::to_string(number) +
                               R"(","rev":1,"kind":"line","points":[[0,0,0],[0,2,0]],"seeds":5,)"
                               R"("name":"a","clipped":false)" +
                               (number == 2 ? R"(,"colour":"#0072b2","author":"Ada"})" : "}")});
    const auto report = old.sessions.restore("main", "main", entries);
    EXPECT_TRUE(report.refused.empty());
    const auto colour = [&](const char* id) {
        return old.session->records().get<protocol::RakeRecord>(id)->colour;
    };
    EXPECT_EQ(colour("r2"), server::palette[0]);
    EXPECT_EQ(colour("r1"), server::palette[1]);
    EXPECT_EQ(colour("r10"), server::palette[2]);
    EXPECT_EQ(colour("r11"), server::palette[3]);
    SessionBench again; // and they are kept
    again.sessions.restore("main", "main", old.journal.entries("main"));
    EXPECT_EQ(content(again.session->records()), content(old.session->records()));
}

TEST(Document, TheClockComesBackStoppedWhereItWas) {
    SessionBench before;
    before.session->clock().set(2.0);
    const auto restored = [&] {
        SessionBench after;
        EXPECT_TRUE(
            after.sessions.restore("main", "main", before.journal.entries("main")).refused.empty());
        const protocol::ClockRecord once = after.session->clock().record();
        SessionBench again;
        again.sessions.restore("main", "main", after.journal.entries("main"));
        EXPECT_EQ(again.session->clock().record(), once) << "restored twice";
        return once;
    };
    EXPECT_EQ(restored(), before.session->clock().record());
    ASSERT_TRUE(before.session->clock().play({{}, 0.5, true, 1.0, 40.0}, std::nullopt));
    const std::size_t batches = before.journal.batches;
    before.loop.pass(std::chrono::milliseconds(20'700));
    EXPECT_LE(before.journal.batches, batches + 21) << "one a second, not one a tick";
    const protocol::ClockRecord running = before.session->clock().record();
    const protocol::ClockRecord killed = restored();
    EXPECT_FALSE(killed.playing);
    EXPECT_LE(killed.time, running.time);
    EXPECT_GE(*killed.time, *running.time - 0.55) << "half a unit a second, and a tick";
    EXPECT_EQ(killed.speed, 0.5);
    EXPECT_EQ(killed.loop, true);
    EXPECT_EQ(killed.from, 1.0);
    EXPECT_EQ(killed.to, 40.0);
    before.sessions.keep_times();
    EXPECT_EQ(restored().time, running.time) << "a server that ends in order keeps all of it";
    before.session->clock().pause();
    EXPECT_EQ(restored(), before.session->clock().record());
    before.session->clock().set(std::nullopt);
    EXPECT_EQ(restored().time, std::nullopt);
}

TEST(Document, ADamagedClockIsLeftOutAndTheRestIsThere) {
    SessionBench before;
    ASSERT_TRUE(before.session->set_rake(rake_at(1)));
    for (const char* text : {"", "{}x", R"({"time":1e300})", R"({"speed":0})", R"({"from":1})",
                             R"({"loop":1})", R"({"from":2,"to":1})", R"({"playing":true})"}) {
        auto entries = before.journal.entries("main");
        entries.push_back({"clock", "", text});
        SessionBench after;
        EXPECT_EQ(after.sessions.restore("main", "main", entries).refused.size(), 1u) << text;
        EXPECT_EQ(after.session->clock().record(), protocol::ClockRecord{});
        EXPECT_EQ(after.session->records().all<protocol::RakeRecord>().size(), 1u);
    }
}

TEST(Document, EveryEditIsOneBatchOfTheJournal) {
    SessionBench bench;
    const auto rake = bench.session->set_rake(rake_at(0), bench.ada)->record.rake;
    EXPECT_EQ(bench.journal.batches, 1u);
    ASSERT_TRUE(bench.session->set_surface(surface_on(rake), bench.ada));
    ASSERT_TRUE(bench.session->set_surface(surface_on(rake), bench.ada));
    EXPECT_EQ(bench.journal.batches, 3u);
    EXPECT_EQ(bench.journal.entries("main").size(), 5u)
        << "session, its profile, rake, two surfaces";
    ASSERT_TRUE(bench.session->remove({RecordType::Rake, rake}, bench.ada));
    EXPECT_EQ(bench.journal.batches, 4u);
    EXPECT_EQ(bench.journal.entries("main").size(), 2u);
    EXPECT_FALSE(bench.session->remove({RecordType::Rake, rake}, bench.ada));
    EXPECT_EQ(bench.journal.batches, 4u) << "what was refused is not written";
}

TEST(Document, AJournalThatKeepsNothingHoldsUpNobody) {
    SessionBench sound;
    SessionBench broken;
    broken.journal.broken = true;
    RandomEdits here(sound, 7);
    RandomEdits there(broken, 7);
    for (int i = 0; i < 200; ++i) {
        here.step();
        there.step();
        ASSERT_EQ(broken.session->records().list(), sound.session->records().list());
    }
    EXPECT_EQ(broken.journal.batches, sound.journal.batches);
    EXPECT_TRUE(broken.journal.sessions.empty());
}

TEST(Document, IdsAreNotGivenTwiceAcrossARestart) {
    SessionBench before;
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(before.session->set_bookmark(bookmark_of("{}"), before.ada));
    ASSERT_TRUE(before.session->remove({RecordType::Bookmark, "b3"}, before.ada));
    SessionBench after;
    after.sessions.restore("main", "main", before.journal.entries("main"));
    EXPECT_EQ(after.session->set_bookmark(bookmark_of("{}"), after.ada)->bookmark, "b4");
    const auto other = *after.sessions.create("one");
    SessionBench third;
    third.sessions.restore(other->id(), "", after.journal.entries(other->id()));
    EXPECT_NE((*third.sessions.create("two"))->id(), other->id());
    EXPECT_EQ((*third.sessions.find(other->id()))->name(), "one");
}

TEST(Document, ASurfaceWhoseDatasetIsNotThereSaysSoAndIsBuiltOnceItIs) {
    SessionBench before;
    const auto rake = before.session->set_rake(rake_at(0), before.ada)->record.rake;
    auto streak = surface_on(rake);
    streak.parameters.kind = core::SurfaceKind::Streak;
    const auto surface = before.session->set_surface(streak, before.ada);
    ASSERT_TRUE(surface);
    SessionBench after;
    after.datasets.there = false;
    Onlooker onlooker;
    ASSERT_TRUE(after.session->participants().join({"onlooker", "", "", {}}, onlooker));
    EXPECT_EQ(after.sessions.restore("main", "main", before.journal.entries("main")).restored, 2u);
    const auto live = *after.session->live(surface->surface);
    ASSERT_TRUE(live->outcome().error);
    EXPECT_EQ(live->outcome().error->code, Error::Code::NotFound);
    EXPECT_EQ(live->outcome().statistics.kind, core::SurfaceKind::Streak);
    after.loop.turn_until([&] { return !onlooker.outcomes.empty(); });
    EXPECT_TRUE(onlooker.outcomes[0].error);
    const std::uint32_t told =
        after.session->records().get<protocol::SurfaceRecord>(surface->surface)->epoch;
    after.datasets.there = true;
    after.sessions.dataset_changed("abc");
    EXPECT_GT(after.session->records().get<protocol::SurfaceRecord>(surface->surface)->epoch, told);
    EXPECT_TRUE(live->resting()) << "until someone looks at it";
    live->begin_now();
    after.loop.turn_until([&] { return onlooker.outcomes.size() > 1; });
    EXPECT_FALSE(onlooker.outcomes[1].error);
    EXPECT_TRUE(onlooker.outcomes[1].complete);
    after.session->participants().leave(onlooker);
}

TEST(Document, OfADamagedJournalTheSoundRecordsComeBack) {
    SessionBench before;
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(before.session->set_rake(rake_at(i), before.ada));
    ASSERT_TRUE(before.session->set_surface(surface_on("r2"), before.ada));
    ASSERT_TRUE(before.session->set_surface(surface_on("r3"), before.ada));
    auto entries = before.journal.entries("main");
    for (auto& each : entries)
        if (each.type == "rake" && each.id == "r2")
            each.record = each.record->substr(0, 20);
    entries.push_back({"rake", "../r9", R"({"rake":"../r9"})"});
    entries.push_back({"bookmark", "b1", R"({"bookmark":"b2","rev":1,"name":"","view":{}})"});
    entries.push_back({"participant", "p1", "not ours"});
    SessionBench after;
    const auto report = after.sessions.restore("main", "main", entries);
    EXPECT_EQ(report.restored, 3u) << "r1, r3, s2";
    EXPECT_EQ(report.refused.size(), 5u)
        << "r2, the surface on it, two that are no records, a place that is none";
    EXPECT_EQ(after.session->records().all<protocol::RakeRecord>().size(), 2u);
    EXPECT_EQ(after.session->records().all<protocol::SurfaceRecord>().begin()->first, "s2");
}

TEST(Document, AForkHasTheRecordsAndGoesItsOwnWay) {
    SessionBench bench;
    const auto rake = bench.session->set_rake(dragged(1, "", std::nullopt), bench.ada);
    EXPECT_FALSE(rake) << "no such rake";
    const auto first = bench.session->set_rake(rake_at(1), bench.ada)->record.rake;
    ASSERT_TRUE(bench.session->set_surface(surface_on(first), bench.ada));
    ASSERT_TRUE(bench.session->set_rake(dragged(2, first), bench.ada));
    ASSERT_TRUE(bench.session->set_annotation(note("here"), bench.ada));
    bench.session->clock().set(0.25);
    const auto fork = bench.sessions.fork("main", "mine", false);
    ASSERT_TRUE(fork);
    EXPECT_EQ((*fork)->name(), "mine");
    EXPECT_EQ((*fork)->clock().time(), 0.25);
    EXPECT_EQ(content((*fork)->records()), content(bench.session->records()));
    EXPECT_FALSE((*fork)->records().all<protocol::RakeRecord>().begin()->second.dragging)
        << "a lease is no one's in the fork";
    EXPECT_EQ((*fork)->records().all<protocol::SurfaceRecord>().begin()->second.epoch, 1u);
    EXPECT_NE((*(*fork)->live("s1"))->number(), (*bench.session->live("s1"))->number());
    const auto before = bench.session->records().list();
    ASSERT_TRUE((*fork)->remove({RecordType::Rake, first}, bench.bob));
    EXPECT_EQ(bench.session->records().list(), before);
    EXPECT_TRUE(
        bench.session->move_in_history(server::HistoryMove::Undo, bench.bob).changes.empty());
    SessionBench after;
    after.sessions.restore((*fork)->id(), "", bench.journal.entries((*fork)->id()));
    const auto back = *after.sessions.find((*fork)->id());
    EXPECT_EQ(content(back->records()), content((*fork)->records()));
    EXPECT_EQ(back->profile().copy_of, "main");
    EXPECT_EQ(bench.sessions.fork("none", "").error().code, Error::Code::NotFound);
}

TEST(Document, BookmarksAndAnnotationsAreLimitedInNumber) {
    SessionBench bench;
    for (std::size_t i = 0; i < server::limits::bookmarks; ++i)
        ASSERT_TRUE(bench.session->set_bookmark(bookmark_of("{}"), bench.ada));
    EXPECT_EQ(bench.session->set_bookmark(bookmark_of("{}"), bench.ada).error().code,
              Error::Code::OverLimit);
    EXPECT_TRUE(bench.session->set_bookmark(bookmark_of("{}", "b1"), bench.ada));
    for (std::size_t i = 0; i < server::limits::annotations; ++i)
        ASSERT_TRUE(bench.session->set_annotation(note("n"), bench.ada));
    EXPECT_EQ(bench.session->set_annotation(note("n"), bench.ada).error().code,
              Error::Code::OverLimit);
}

TEST(Document, ASliceShowsAFieldOfItsDatasetWhereItsPlaneMeetsIt) {
    SessionBench bench;
    server::Session& session = *bench.session;
    const auto made = session.set_slice(slice_at(2), bench.ada);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->slice, "c1");
    EXPECT_EQ(made->field, "velocity") << "for its magnitude, where none is named";
    auto setting = slice_at(99, "c1");
    const auto beside = session.set_slice(setting, bench.ada);
    ASSERT_FALSE(beside);
    EXPECT_EQ(beside.error().code, Error::Code::OutOfDomain);
    EXPECT_NE(beside.error().message.find("misses the domain by"), std::string::npos);
    setting = slice_at(1, "c1");
    setting.field = "pressure";
    const auto unknown = session.set_slice(setting, bench.ada);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, Error::Code::InvalidArgument);
    EXPECT_NE(unknown.error().hint.find("vorticity"), std::string::npos) << unknown.error().hint;
    setting.field = "q_criterion";
    EXPECT_EQ(session.set_slice(setting, bench.ada)->rev, 2u);
    session.move_in_history(server::HistoryMove::Undo, bench.ada);
    EXPECT_EQ(session.records().get<protocol::SliceRecord>("c1")->origin.x, 2.0);
}

TEST(Document, ASliceSaysWhatItSubtractsAndIsRefusedWhatItCannot) {
    SessionBench bench;
    server::Session& session = *bench.session;
    auto setting = slice_at(2);
    setting.minus_offset = 0.5;
    const auto made = session.set_slice(setting, bench.ada);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->minus_offset, 0.5);
    const auto refused = [&](const char* words) {
        const auto edit = session.set_slice(setting, bench.ada);
        ASSERT_FALSE(edit);
        EXPECT_NE(edit.error().message.find(words), std::string::npos) << edit.error().message;
    };
    setting.minus_time = 1.0;
    refused("exclude each other");
    setting.minus_offset.reset();
    setting.minus = "none";
    refused("no dataset none");
}

TEST(Document, SlicesAreLimitedInNumber) {
    SessionBench bench;
    for (std::size_t i = 0; i < server::limits::slices; ++i)
        ASSERT_TRUE(bench.session->set_slice(slice_at(1), bench.ada));
    const auto more = bench.session->set_slice(slice_at(1), bench.ada);
    ASSERT_FALSE(more);
    EXPECT_EQ(more.error().code, Error::Code::OverLimit);
    EXPECT_TRUE(bench.session->set_slice(slice_at(2, "c1"), bench.ada)) << "this one is there";
}

TEST(Document, LinesAreColouredByAFieldOfTheirDatasetAndReleasedInIt) {
    SessionBench bench;
    server::Session& session = *bench.session;
    const auto made = session.set_lines(lines_from(2), bench.ada);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->lines, "l1");
    EXPECT_EQ(made->field, "velocity") << "for its magnitude, where none is named";
    const auto refusal = [&](const auto& change) {
        auto setting = lines_from(1, "l1");
        change(setting);
        const auto set = session.set_lines(setting, bench.ada);
        return set ? std::string() : set.error().message;
    };
    EXPECT_NE(refusal([](auto& of) {
                  of.places.points = {{99, 0, 0}, {99, 1, 0}};
              }).find("outside of the domain"),
              std::string::npos);
    EXPECT_NE(refusal([](auto& of) { of.field = "pressure"; }).find("pressure"), std::string::npos);
    EXPECT_EQ(refusal([](auto& of) { of.low = 1.0; }), "`low` and `high` are no range of colours");
    EXPECT_EQ(refusal([](auto& of) {
                  of.places = {core::LineSeeds::Kind::Walls, {}, 0.1, 5};
              }),
              "`kind`: the data have no walls");
    EXPECT_EQ(refusal([](auto& of) {
                  of.places = {core::LineSeeds::Kind::Walls, {}, 0.1, 5, {"hull"}};
              }),
              "there is no patch hull");
    auto setting = lines_from(1, "l1");
    setting.low = 0.0;
    setting.high = 2.0;
    EXPECT_EQ(session.set_lines(setting, bench.ada)->rev, 2u);
    session.move_in_history(server::HistoryMove::Undo, bench.ada);
    EXPECT_EQ(session.records().get<protocol::LinesRecord>("l1")->places.points[0].x, 2.0);
}

TEST(Document, AnAnnotationKeepsItsAuthorAndOutlivesItsSurface) {
    SessionBench bench;
    const auto rake = bench.session->set_rake(rake_at(0), bench.ada)->record.rake;
    const auto surface = bench.session->set_surface(surface_on(rake), bench.ada)->surface;
    auto text = note("a vortex");
    text.surface = "s99";
    EXPECT_EQ(bench.session->set_annotation(text, bench.ada).error().code, Error::Code::NotFound);
    text.surface = surface;
    const auto made = bench.session->set_annotation(text, bench.ada);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->author, "Ada");
    ASSERT_TRUE(bench.session->remove({RecordType::Surface, surface}, bench.bob));
    text.annotation = made->annotation;
    text.text = "was a vortex";
    const auto edited = bench.session->set_annotation(text, bench.bob);
    ASSERT_TRUE(edited) << edited.error().message;
    EXPECT_EQ(edited->author, "Ada");
    EXPECT_EQ(edited->rev, 2u);
}

} // namespace wakesurf::tests::document_test
