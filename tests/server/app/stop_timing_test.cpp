// How soon the program ends when it is asked to, whatever it is at.
#include "tests/support/server/running_program.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string>

namespace wakesurf::tests::stop_timing_test {

namespace {

using Clock = std::chrono::steady_clock;

/// Of more quads than it can make in minutes.
const std::string large_surface = "surface flow:abc --kind stream --rake '-9,0,0 9,0,0' --to 200"
                                  " --separation 0.01 --max-quads 50000000 -o ";

} // namespace

TEST(Stop, EndsAServerWithinASecond) {
    ServerProcess server;
    const WebSocketClient client(server);
    const auto end = server.stop();
    EXPECT_EQ(end.status, 0);
    EXPECT_LT(end.took, std::chrono::seconds(1));
}

TEST(Stop, EndsASurfaceThatIsBuiltWithinASecond) {
    const TemporaryFolder folder;
    RunningProgram surface(large_surface + (folder / "out.vtp").string());
    EXPECT_NE(surface.line().find("building"), std::string::npos);
    const auto asked = Clock::now();
    EXPECT_EQ(surface.stop(SIGINT).status, 1);
    EXPECT_LT(Clock::now() - asked, std::chrono::seconds(1));
}

TEST(Stop, EndsAStoreThatIsGeneratedWithinASecond) {
    const TemporaryFolder folder;
    RunningProgram generate("generate abc " + (folder / "store").string() +
                            " --grid 200,200,100 --times 0:1:3");
    EXPECT_NE(generate.line().find("generate: 1 of 3"), std::string::npos);
    const auto asked = Clock::now();
    EXPECT_EQ(generate.stop(SIGINT).status, 1);
    EXPECT_LT(Clock::now() - asked, std::chrono::seconds(1));
}

TEST(Stop, EndsASurfaceSoonAfterItsLimitOfSeconds) {
    const TemporaryFolder folder;
    const auto begun = Clock::now();
    RunningProgram surface("surface flow:abc --kind stream --rake '-9,0,0 9,0,0' --to 5"
                           " --separation 0.002 --max-quads 50000000 --seconds 2 -o " +
                           (folder / "out.ply").string());
    while (!surface.line().empty()) {
    }
    EXPECT_LT(Clock::now() - begun, std::chrono::seconds(20));
}

} // namespace wakesurf::tests::stop_timing_test
