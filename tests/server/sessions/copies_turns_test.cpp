// The turns in the compute pool of the copies that holders of a share link have made.
#include "server/sessions/session_directory.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace wakesurf::server::copies_turns_test {
namespace {

/// Returns the turns of the pool until a surface of the session is whole, beside one of each copy that was
/// asked for before.
std::size_t turns_beside(std::size_t copies, const std::string& link) {
    const Author ada{"p1", "Ada"};
    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{ComputePool::ByHand{}};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    SessionDirectory sessions{SessionServices{loop, pool, datasets, entropy}};
    const auto session = *sessions.find("main");
    EXPECT_TRUE(session->set_rake(tests::rake_at(0), ada));
    for (std::size_t i = 0; i < copies; ++i) {
        const std::string by = link.empty() ? "link" + std::to_string(i) : link;
        const auto copy = sessions.fork("main", "", true, by);
        EXPECT_TRUE(copy && (*copy)->set_surface(tests::surface_on("r1"), ada));
    }
    const auto surface = session->set_surface(tests::surface_on("r1"), ada);
    EXPECT_TRUE(surface);
    const auto live = session->builds().find("s1");
    std::size_t turns = 0;
    while (live && live->busy() && pool.turn()) {
        loop.advance(std::chrono::milliseconds(0));
        ++turns;
    }
    EXPECT_TRUE(live && !live->busy());
    return turns;
}

TEST(CopiesTurns, OfOneLinkAreThoseOfOneSession) {
    const std::size_t alone = turns_beside(0, "");
    EXPECT_LE(turns_beside(8, "link"), 2 * alone + 1);
    EXPECT_GE(turns_beside(8, ""), 4 * alone) << "else this shows nothing";
}

} // namespace
} // namespace wakesurf::server::copies_turns_test
