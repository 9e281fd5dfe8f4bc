// Files of other versions: older ones are copied, then brought up to date; newer ones are left alone.
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/server/record_script.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

namespace wakesurf::tests::state_upgrade_test {

using server::PendingWrites;
using server::StateOptions;
using server::StateStore;

namespace {

/// As the first release made and filled it.
constexpr const char* layout_1 = R"(
PRAGMA journal_mode=WAL;
BEGIN IMMEDIATE;
CREATE TABLE records(session TEXT NOT NULL, type TEXT NOT NULL, id TEXT NOT NULL, json TEXT NOT NULL, PRIMARY KEY(session, type, id));
PRAGMA application_id=2002873189;
PRAGMA user_version=1;
INSERT INTO records VALUES('main','session','','{"name":"main","seq":7,"nextRake":3,"nextSurface":1,"nextBookmark":1,"nextAnnotation":2}');
INSERT INTO records VALUES('main','rake','r2','{"rake":"r2","rev":1,"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":8,"name":"r2","colour":"#102030","author":"Ada","clipped":false}');
INSERT INTO records VALUES('session-4','annotation','a1','{"annotation":"a1","rev":2,"text":"vortex","position":[1,2,3],"author":"Bob"}');
COMMIT;
)";

void execute(const std::string& path, const char* statements) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, statements, nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
}

std::vector<std::string> copies_in(const TemporaryFolder& folder) {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::directory_iterator(folder / "."))
        if (each.path().filename().string().starts_with("sessions-"))
            names.push_back(each.path().filename());
    return names;
}

StateOptions options(const std::string& path, const std::string& writer) {
    return {path, nullptr, writer, [] { return std::int64_t{1'795'345'200}; }};
}

} // namespace

TEST(StateUpgrade, BringsAFileOfTheFirstLayoutUpToDateAfterCopyingIt) {
    const TemporaryFolder folder;
    const std::string path = folder / "sessions.sqlite";
    execute(path, layout_1);
    RecordMap records;
    for (int life = 0; life < 3; ++life) {
        auto store = StateStore::open(options(path, "2.0"));
        ASSERT_TRUE(store) << store.error().message;
        const RecordMap found = records_of(store->take_loaded().sessions);
        EXPECT_EQ(found.size(), 3u);
        EXPECT_TRUE(life == 0 || found == records);
        records = found;
    }
    EXPECT_EQ((records[{"session-4", "annotation", "a1"}]),
              R"({"annotation":"a1","rev":2,"text":"vortex","position":[1,2,3],"author":"Bob"})");
    ASSERT_EQ(copies_in(folder),
              std::vector<std::string>{"sessions-layout1-20261122T110000Z.sqlite"});
    const auto permissions = std::filesystem::status(folder / copies_in(folder)[0]).permissions();
    EXPECT_EQ(permissions,
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    // The copy is what the older program can start with.
    const TemporaryFolder other;
    std::filesystem::copy_file(folder / copies_in(folder)[0], other / "sessions.sqlite");
    auto from_copy = StateStore::open(options(other / "sessions.sqlite", "2.0"));
    ASSERT_TRUE(from_copy);
    EXPECT_EQ(records_of(from_copy->take_loaded().sessions), records);
}

TEST(StateUpgrade, CopiesTheFileOfAnotherVersionBeforeItsFirstWriteAndOnlyThen) {
    const TemporaryFolder folder;
    const std::string path = folder / "sessions.sqlite";
    const auto write = [&](const char* version, const char* record) {
        auto store = StateStore::open(options(path, version));
        ASSERT_TRUE(store) << store.error().message;
        PendingWrites changes;
        changes.write("main", {{"rake", "r1", record}});
        ASSERT_TRUE(store->apply(changes));
    };
    write("1.0", "first");
    write("1.0", "second");
    EXPECT_TRUE(copies_in(folder).empty());
    write("1.1", "third");
    write("1.1", "fourth");
    ASSERT_EQ(copies_in(folder), std::vector<std::string>{"sessions-1.0-20261122T110000Z.sqlite"});
    auto copy = StateStore::open(options(folder / copies_in(folder)[0], "1.0"));
    ASSERT_TRUE(copy);
    EXPECT_EQ((records_of(copy->take_loaded().sessions)[{"main", "rake", "r1"}]), "second");
}

TEST(StateUpgrade, DoesNotStartWhereTheCopyCannotBeMade) {
    const TemporaryFolder folder;
    const std::string path = folder / "sessions.sqlite";
    execute(path, layout_1);
    write_file(folder / "sessions-layout1-20261122T110000Z.sqlite", "someone's");
    const std::string before = read_file(path);
    const auto store = StateStore::open(options(path, "2.0"));
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message.find("cannot be copied"), std::string::npos);
    EXPECT_EQ(read_file(path), before);
}

} // namespace wakesurf::tests::state_upgrade_test
