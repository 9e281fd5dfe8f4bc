// Files of other versions: they are copied before they are written to; those of another layout are left alone.
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/server/record_script.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::state_upgrade_test {

using server::PendingWrites;
using server::StateOptions;
using server::StateStore;

namespace {

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
    EXPECT_EQ(std::filesystem::status(folder / copies_in(folder)[0]).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    auto copy = StateStore::open(options(folder / copies_in(folder)[0], "1.0"));
    ASSERT_TRUE(copy);
    EXPECT_EQ((records_of(copy->take_loaded().sessions)[{"main", "rake", "r1"}]), "second");
}

TEST(StateUpgrade, DoesNotStartWhereTheCopyCannotBeMade) {
    const TemporaryFolder folder;
    const std::string path = folder / "sessions.sqlite";
    ASSERT_TRUE(StateStore::open(options(path, "1.0")));
    write_file(folder / "sessions-1.0-20261122T110000Z.sqlite", "someone's");
    const std::string before = read_file(path);
    const auto store = StateStore::open(options(path, "2.0"));
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message.find("cannot be copied"), std::string::npos);
    EXPECT_EQ(read_file(path), before);
}

} // namespace wakesurf::tests::state_upgrade_test
