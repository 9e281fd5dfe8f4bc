// How soon who waits for a call can stop waiting.
#include "server/base/limits.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace wakesurf::tests::cancel_timing_test {

using nlohmann::json;

TEST(CancelTiming, AnOpenCallIsAnsweredWithin50MillisecondsOfIt) {
    const ServerProcess server({"flow:abc"});
    WebSocketClient client(server);
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{-9, 0, 0}, {9, 0.1, 0}}}, {"seeds", 256}});
    const json surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                       {"kind", "stream"},
                                                       {"dataset", "abc"},
                                                       {"from", 0},
                                                       {"to", 200},
                                                       {"separation", 0.01},
                                                       {"maxQuads", 4000000}})["surface"];
    std::vector<std::chrono::steady_clock::duration> took;
    for (int i = 0; i < 9; ++i) {
        const int id = client.next_id();
        client.send({{"jsonrpc", "2.0"},
                     {"id", id},
                     {"method", "surface.wait"},
                     {"params", {{"surface", surface}, {"timeoutMs", server::limits::wait_ms}}}});
        client.result("server.ping"); // the wait is open now
        const auto start = std::chrono::steady_clock::now();
        client.send({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", id}}}});
        EXPECT_EQ(client.answer(id)["error"]["code"], -32800);
        took.push_back(std::chrono::steady_clock::now() - start);
    }
    std::ranges::nth_element(took, took.begin() + 4);
    EXPECT_LT(took[4], std::chrono::milliseconds(50)) << "the median";
}

} // namespace wakesurf::tests::cancel_timing_test
