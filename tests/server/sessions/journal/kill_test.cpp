// What was answered is there after the server was killed, wherever it was. WAKESURF_KILLS=N kills it N times.
#include "tests/support/server/killed_server.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace wakesurf::tests::kill_test {

TEST(KilledServer, HasEveryEditItAnswered) {
    const TemporaryFolder folder;
    const char* const asked = std::getenv("WAKESURF_KILLS");
    const int kills = asked == nullptr ? 20 : std::atoi(asked);
    const KillReport report = kill_under_edits(folder / "state", 20, kills);
    EXPECT_EQ(report.kills, kills);
    EXPECT_GT(report.answered, static_cast<std::size_t>(10 * kills));
    EXPECT_EQ(report.wrong, std::vector<std::string>{});
    RecordProperty("longest_start_ms",
                   static_cast<int>(*std::ranges::max_element(report.ready_ms)));
}

} // namespace wakesurf::tests::kill_test
