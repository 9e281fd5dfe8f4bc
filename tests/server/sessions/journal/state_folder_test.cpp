// Who may have the folder of `--state`, and who may read it.
#include "server/sessions/journal/state_folder.hpp"
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace wakesurf::tests::state_folder_test {

using server::StateFolder;
using std::filesystem::perms;

TEST(StateFolder, IsHeldByOneServerAtATime) {
    const TemporaryFolder folder;
    std::optional<StateFolder> first = *StateFolder::hold(folder / "state");
    const auto second = StateFolder::hold(folder / "state");
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, core::Error::Code::OverLimit);
    EXPECT_EQ(second.error().message.find(folder.path().string()), std::string::npos);
    first.reset();
    EXPECT_TRUE(StateFolder::hold(folder / "state"));
}

TEST(StateFolder, IsForTheUserAlone) {
    const TemporaryFolder folder;
    const auto held = StateFolder::hold(folder / "a" / "state");
    ASSERT_TRUE(held);
    auto store = server::StateStore::open(held->file());
    ASSERT_TRUE(store);
    server::PendingWrites changes;
    changes.write("main", {{"rake", "r1", "{}"}});
    ASSERT_TRUE(store->apply(changes));
    const auto mode = [](const std::filesystem::path& path) {
        return std::filesystem::status(path).permissions();
    };
    EXPECT_EQ(mode(folder / "a" / "state"), perms::owner_all);
    int files = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder / "a" / "state")) {
        EXPECT_EQ(mode(each), perms::owner_read | perms::owner_write) << each.path();
        ++files;
    }
    EXPECT_EQ(files, 3); // with the log and how many changes were kept
}

TEST(StateFolder, SaysWhyItCannotBeUsed) {
    const TemporaryFolder folder;
    write_file(folder / "file", "");
    for (const std::filesystem::path& path :
         {folder / "file", folder / "file" / "state", std::filesystem::path("/proc/state")}) {
        const auto held = StateFolder::hold(path);
        ASSERT_FALSE(held) << path;
        EXPECT_EQ(held.error().code, core::Error::Code::Io);
        EXPECT_FALSE(held.error().hint.empty());
    }
}

} // namespace wakesurf::tests::state_folder_test
