// How soon a share link that has ended lets nobody in any more.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <string>

namespace wakesurf::tests::sharing_timing_test {

using nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;

class SharingTiming : public testing::Test {
  protected:
    static Headers with_key(const json& share) {
        return {{"Authorization", "Bearer " + share["key"].get<std::string>()}};
    }

    /// Until the server has closed; what it says before is dropped.
    static void wait_for_end(WebSocketClient& client) {
        for (;;)
            if (const auto opcode = client.receive().opcode; opcode == 8 || opcode == 0)
                return;
    }

    ServerProcess server;
    WebSocketClient host{server};
};

} // namespace

TEST_F(SharingTiming, EverybodyWhoCameByALinkIsGoneASecondAfterItWasTakenBack) {
    const json link = host.result("session.share", {{"role", "editor"}});
    WebSocketClient joined(server, "main", with_key(link));
    WebSocketClient not_joined(server, "", with_key(link));
    const auto start = Clock::now();
    host.result("session.unshare", {{"grant", link["grant"]}});
    wait_for_end(joined);
    wait_for_end(not_joined);
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(1));
}

TEST_F(SharingTiming, EverybodyWhoCameByALinkIsGoneASecondAfterItHasExpired) {
    const json link = host.result("session.share", {{"role", "viewer"}, {"expiresIn", 1}});
    const auto start = Clock::now();
    WebSocketClient viewer(server, "main", with_key(link));
    wait_for_end(viewer);
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(2));
}

} // namespace wakesurf::tests::sharing_timing_test
