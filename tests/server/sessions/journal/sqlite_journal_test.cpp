// The journal with its thread: what is acknowledged is on the disk at that moment, and a disk that refuses for a while
// costs nothing but the promise.
#include "server/sessions/journal/sqlite_journal.hpp"
#include "tests/support/server/faulty_disk.hpp"
#include "tests/support/server/record_script.hpp"
#include "tests/support/server/waiting_loop.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <memory>

namespace wakesurf::tests::sqlite_journal_test {

using core::Result;
using server::SqliteJournal;
using server::StateStore;
using std::chrono::milliseconds;

namespace {

constexpr const char* file = "sessions.sqlite";

void write(SqliteJournal& journal, const ScriptedEdit& edit) {
    if (edit.entries.empty())
        journal.remove(edit.session);
    else
        journal.write(edit.session, edit.entries);
}

RecordMap content(const std::string& path, const char* disk) {
    auto store = StateStore::open(path, disk);
    EXPECT_TRUE(store) << store.error().message;
    return store ? records_of(store->take_loaded().sessions) : RecordMap{};
}

/// A journal on a disk in memory, and what it says.
class SqliteJournalTest : public testing::Test {
  protected:
    FaultyDisk disk;
    WaitingLoop loop;
    RecordScript script{11};
    std::vector<Result<void>> turns;
    std::unique_ptr<SqliteJournal> journal = open();

    std::unique_ptr<SqliteJournal> open() {
        return std::make_unique<SqliteJournal>(
            loop, *StateStore::open(file, disk.name()),
            [this](Result<void> turn) { turns.push_back(std::move(turn)); }, milliseconds(1));
    }

    Result<void> settled() {
        std::optional<Result<void>> outcome;
        journal->settled([&](Result<void> given) { outcome = std::move(given); });
        loop.turn_until([&] { return outcome.has_value(); });
        return outcome.value_or(Result<void>{});
    }

    void edit() { write(*journal, script.next()); }
};

} // namespace

TEST_F(SqliteJournalTest, AcknowledgesOnlyWhatAPowerCutLeaves) {
    std::size_t open_answers = 0;
    std::size_t checked = 0;
    std::size_t last = 0;
    for (int edits = 0; edits < 400; ++edits) {
        edit();
        if (script.random()() % 3 != 0)
            continue;
        ++open_answers;
        journal->settled([&, promised = script.history().size() - 1](const Result<void>& outcome) {
            --open_answers;
            EXPECT_TRUE(outcome);
            EXPECT_GE(promised, last) << "answered out of order";
            last = promised;
            FaultyDisk after;
            disk.cut_power_onto(after, script.random());
            const RecordMap found = content(file, after.name());
            const auto& all = script.history();
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(promised);
            EXPECT_NE(std::find(from, all.end(), found), all.end()) << "edit " << promised;
            ++checked;
        });
        if (script.random()() % 4 == 0)
            loop.turn_until([&] { return open_answers == 0; });
    }
    loop.turn_until([&] { return open_answers == 0; });
    EXPECT_GT(checked, 100u);
    EXPECT_TRUE(turns.empty());
}

TEST_F(SqliteJournalTest, AnswersAtOnceWhereNothingWaits) {
    EXPECT_TRUE(settled());
    edit();
    EXPECT_TRUE(settled());
    EXPECT_TRUE(settled());
}

TEST_F(SqliteJournalTest, WritesTheRestAsItEnds) {
    for (int life = 0; life < 10; ++life) {
        for (int edits = 0; edits < 20; ++edits)
            edit();
        journal.reset();
        EXPECT_EQ(content(file, disk.name()), script.now());
        journal = open();
    }
}

TEST_F(SqliteJournalTest, GoesOnWithoutTheDiskAndCatchesUpByItself) {
    for (const int code : {SQLITE_FULL, SQLITE_READONLY, SQLITE_IOERR_FSYNC}) {
        turns.clear();
        edit();
        ASSERT_TRUE(settled());
        disk.refuse(1, code, true);
        // Nothing that comes later writes it once more.
        const std::string once = "refused " + std::to_string(code);
        journal->write(once, {{"rake", "r1", "{}"}});
        ASSERT_FALSE(settled());
        for (int edits = 0; edits < 50; ++edits) {
            edit();
            const Result<void> outcome = settled();
            ASSERT_FALSE(outcome);
            EXPECT_EQ(outcome.error().code, core::Error::Code::Io);
            EXPECT_FALSE(outcome.error().hint.empty());
        }
        ASSERT_EQ(turns.size(), 1u);
        EXPECT_FALSE(turns[0]);
        EXPECT_TRUE(disk.heal());
        loop.turn_until([&] { return turns.size() == 2; });
        EXPECT_TRUE(turns.at(1));
        FaultyDisk after;
        disk.cut_power_onto(after, script.random());
        RecordMap expected = script.now();
        expected[{once, "rake", "r1"}] = "{}";
        EXPECT_EQ(content(file, after.name()), expected) << "written before it says so";
        journal->remove(once);
        edit();
        EXPECT_TRUE(settled());
    }
}

TEST_F(SqliteJournalTest, EndsWhileTheDiskRefuses) {
    edit();
    ASSERT_TRUE(settled());
    const RecordMap before = script.now();
    disk.refuse(1, SQLITE_FULL, true);
    edit();
    EXPECT_FALSE(settled());
    journal.reset();
    EXPECT_TRUE(disk.heal());
    EXPECT_EQ(content(file, disk.name()), before);
}

TEST(SqliteJournal, KeepsAnotherConnectionOut) {
    const TemporaryFolder folder;
    WaitingLoop loop;
    const std::string path = folder / file;
    SqliteJournal journal(loop, *StateStore::open(path), {});
    journal.write("main", {{"rake", "r1", "{}"}});
    std::optional<Result<void>> outcome;
    journal.settled([&](Result<void> given) { outcome = std::move(given); });
    loop.turn_until([&] { return outcome.has_value(); });
    ASSERT_TRUE(outcome && *outcome);
    EXPECT_FALSE(StateStore::open(path));
}

} // namespace wakesurf::tests::sqlite_journal_test
