// The store on disks that fail: at each operation in turn, for a moment or for good, with a power cut after it.
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/server/faulty_disk.hpp"
#include "tests/support/server/record_script.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>

namespace wakesurf::tests::state_store_test {

using core::Error;
using server::PendingWrites;
using server::StateStore;

namespace {

constexpr const char* file = "sessions.sqlite";
constexpr int edits = 25;
constexpr std::array refusals{SQLITE_FULL, SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC, SQLITE_READONLY};

void add(PendingWrites& changes, const ScriptedEdit& edit) {
    if (edit.entries.empty())
        changes.remove(edit.session);
    else
        changes.write(edit.session, edit.entries);
}

RecordMap content(const std::string& path, const char* disk) {
    auto store = StateStore::open(path, disk);
    if (!store) {
        ADD_FAILURE() << store.error().message;
        return {};
    }
    return records_of(store->take_loaded().sessions);
}

RecordMap content(const FaultyDisk& disk) {
    return content(file, disk.name());
}

/// Runs the script on a store; after a failure what was refused waits for the next edit. Returns the number of edits that are
/// acknowledged; the disk may have refused the last ones.
std::size_t run(RecordScript& script, const FaultyDisk& disk) {
    std::size_t acknowledged = 0;
    auto store = StateStore::open(file, disk.name());
    PendingWrites changes;
    for (int edit = 0; edit < edits; ++edit) {
        add(changes, script.next());
        if (!store)
            store = StateStore::open(file, disk.name());
        if (!store || !store->apply(changes))
            continue;
        changes = {};
        acknowledged = script.history().size() - 1;
    }
    return acknowledged;
}

void execute(const std::filesystem::path& path, const char* statements) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, statements, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
}

} // namespace

TEST(StateStore, HoldsWhatWasAppliedWhenItIsOpenedAgain) {
    const TemporaryFolder folder;
    const std::string path = folder / file;
    RecordScript script(1);
    for (int life = 0; life < 20; ++life) {
        auto store = StateStore::open(path);
        ASSERT_TRUE(store) << store.error().message;
        ASSERT_EQ(records_of(store->take_loaded().sessions), script.now());
        for (std::uint64_t edit = script.random()() % 10; edit > 0; --edit) {
            PendingWrites changes;
            add(changes, script.next());
            ASSERT_TRUE(store->apply(changes));
        }
    }
}

TEST(StateStore, LosesNothingWhereTheDiskRefusesOneOperation) {
    int reached = 0;
    for (const int code : refusals)
        for (int at = 1;; ++at) {
            std::mt19937_64 random(static_cast<std::uint64_t>(at));
            FaultyDisk disk;
            RecordScript script(99);
            disk.refuse(at, code, false);
            const std::size_t acknowledged = run(script, disk);
            const bool refused = disk.heal();
            if (acknowledged == script.history().size() - 1) {
                // What could not be synced at first must be on the disk by now.
                disk.cut_power(random);
                ASSERT_EQ(content(disk), script.now()) << "refusal " << code << " at " << at;
            } else {
                const RecordMap found = content(disk);
                const auto from =
                    script.history().begin() + static_cast<std::ptrdiff_t>(acknowledged);
                ASSERT_NE(std::find(from, script.history().end(), found), script.history().end())
                    << "refusal " << code << " at " << at;
            }
            if (!refused)
                break;
            ++reached;
        }
    EXPECT_GT(reached, 400);
}

TEST(StateStore, SurvivesAPowerCutAtEveryOperation) {
    int reached = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        for (int at = 1;; ++at) {
            std::mt19937_64 random(seed * 10'000 + static_cast<std::uint64_t>(at));
            FaultyDisk disk;
            RecordScript script(seed);
            disk.refuse(at, SQLITE_IOERR_WRITE, true);
            const std::size_t acknowledged = run(script, disk);
            const bool refused = disk.heal();
            disk.cut_power(random);
            const RecordMap found = content(disk);
            // An edit that was not acknowledged may be there, whole.
            const auto from = script.history().begin() + static_cast<std::ptrdiff_t>(acknowledged);
            ASSERT_NE(std::find(from, script.history().end(), found), script.history().end())
                << "seed " << seed << ", power cut at " << at;
            if (!refused)
                break;
            ++reached;
        }
    EXPECT_GT(reached, 400);
}

TEST(StateStore, TellsADamagedFileAndLeavesItAlone) {
    const TemporaryFolder folder;
    const std::string path = folder / file;
    {
        RecordScript script(3);
        auto store = StateStore::open(path);
        ASSERT_TRUE(store);
        PendingWrites changes;
        for (int edit = 0; edit < 200; ++edit)
            add(changes, script.next());
        ASSERT_TRUE(store->apply(changes));
    }
    const std::string whole = read_file(path);
    ASSERT_GT(whole.size(), 16'384u);
    for (const std::string& damaged :
         {std::string(5000, 'x'), whole.substr(0, whole.size() / 2),
          whole.substr(0, 4096) + std::string(4096, '\x5a') + whole.substr(8192)}) {
        write_file(path, damaged);
        const auto store = StateStore::open(path);
        ASSERT_FALSE(store);
        EXPECT_EQ(store.error().code, Error::Code::Corrupt);
        EXPECT_NE(store.error().hint.find("move"), std::string::npos);
        EXPECT_EQ(store.error().message.find('/'), std::string::npos) << store.error().message;
        EXPECT_EQ(read_file(path), damaged);
    }
}

TEST(StateStore, RefusesFilesOfANewerLayoutOrAnotherProgramAndLeavesThemAlone) {
    const TemporaryFolder folder;
    { ASSERT_TRUE(StateStore::open((folder / "newer").string())); }
    execute(folder / "newer", "PRAGMA user_version=3");
    execute(folder / "other", "CREATE TABLE recipes(name)");
    for (const char* name : {"newer", "other"}) {
        const std::string before = read_file(folder / name);
        const auto store = StateStore::open((folder / name).string());
        ASSERT_FALSE(store) << name;
        EXPECT_EQ(store.error().code, Error::Code::Unsupported);
        EXPECT_EQ(read_file(folder / name), before) << name;
    }
}

} // namespace wakesurf::tests::state_store_test
