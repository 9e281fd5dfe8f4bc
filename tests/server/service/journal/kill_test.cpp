// What was answered is there after the server was killed, wherever it was.
#include "tests/support/server/killed_server.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::kill_test {

TEST(KilledServer, HasEveryEditItAnswered) {
    const TemporaryFolder folder;
    const KillReport report = kill_under_edits(folder / "state", 20, 20);
    EXPECT_EQ(report.kills, 20);
    EXPECT_GT(report.answered, 200u);
    EXPECT_EQ(report.wrong, std::vector<std::string>{});
}

} // namespace wakesurf::tests::kill_test
