// A download that nobody waits for any more costs nothing more.
#include "tests/support/server/processor_time.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace wakesurf::tests::downloads_timing_test {

using nlohmann::json;
using std::chrono::milliseconds;

namespace {

/// Of a surface that is shown as it is just after its release, which is nothing to compute; later it is much.
std::string slow_to_download(WebSocketClient& client) {
    client.result("time.set", {{"session", "main"}, {"time", 0.0}});
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{0.2, 0, -1}, {1, 0, -1}}}, {"seeds", 9}});
    const std::string surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                              {"kind", "streak"},
                                                              {"dataset", "abc"},
                                                              {"from", 0},
                                                              {"to", 500},
                                                              {"maxQuads", 4'000'000},
                                                              {"separation", 0.002}})["surface"];
    client.result("surface.wait", {{"surface", surface}, {"timeoutMs", 60000}});
    return surface;
}

bool within(milliseconds patience, const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!done()) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(milliseconds(10));
    }
    return true;
}

} // namespace

TEST(DownloadsTiming, ComputeNoFurtherWhenWhoAskedHasHungUp) {
    const ServerProcess server({"flow:abc"});
    WebSocketClient host(server);
    const std::string surface = slow_to_download(host);
    std::optional<RawSocket> guest(server.port());
    guest->send(fmt::format("GET /api/v1/sessions/main/surfaces/{}/mesh.ply?time=end HTTP/1.1\r\n"
                            "Host: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\n\r\n",
                            surface, server.port(), server.token()));
    const auto begun = processor_time_of(server.pid());
    EXPECT_TRUE(within(milliseconds(20'000), [&] {
        return processor_time_of(server.pid()) - begun > milliseconds(300);
    })) << "it does not compute";
    guest.reset();
    EXPECT_TRUE(within(milliseconds(20'000), [&] {
        const auto before = processor_time_of(server.pid());
        std::this_thread::sleep_for(milliseconds(500));
        return processor_time_of(server.pid()) - before < milliseconds(30);
    })) << "it goes on";
}

} // namespace wakesurf::tests::downloads_timing_test
