// What a server says of its memory, and what it answers when something does not fit.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::tests::memory_stats_test {

using nlohmann::json;

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20;

class SmallServer : public testing::Test {
  protected:
    json set_surface(double separation) {
        if (rake.empty())
            rake = client.result(
                "rake.set",
                {{"kind", "line"}, {"points", {{1, -5, 0}, {1, 5, 0}}}, {"seeds", 32}})["rake"];
        json record{{"rake", rake},     {"kind", "stream"},
                    {"dataset", "abc"}, {"from", 0},
                    {"to", 100},        {"separation", separation},
                    {"angle", 180.0},   {"maxQuads", 4'000'000}};
        if (!surface.empty())
            record["surface"] = surface;
        surface = client.result("surface.set", record)["surface"];
        return client.call("surface.wait", {{"surface", surface}, {"timeoutMs", 120'000}});
    }

    ServerProcess server{{"flow:abc", "--memory", "96MiB"}};
    WebSocketClient client{server};
    std::string rake, surface;
};

} // namespace

TEST_F(SmallServer, TellsTheAccountByUse) {
    ASSERT_TRUE(set_surface(0.5)["result"]["complete"]);
    const json memory = client.result("server.stats")["memory"];
    EXPECT_EQ(memory["budget"], 96 * mebi);
    EXPECT_GT(memory["used"], 0);
    EXPECT_EQ(memory["refused"], 0);
    std::size_t sum = 0;
    for (const auto& [use, bytes] : memory["byUse"].items())
        sum += bytes.get<std::size_t>();
    EXPECT_GT(sum, mebi) << "the process itself";
    const std::string text = http(server.port(), "GET", "/metrics", server.bearer()).body;
    EXPECT_NE(text.find("wakesurf_memory_budget_bytes 100663296"), std::string::npos);
    EXPECT_NE(text.find("wakesurf_memory_bytes{use=\"other\"} "), std::string::npos);
}

TEST_F(SmallServer, RefusesWhatDoesNotFitNamingTheLimitAndACureAndServesOn) {
    const json answer = set_surface(0.01);
    ASSERT_TRUE(answer.contains("error")) << answer.dump();
    const json& error = answer["error"];
    EXPECT_EQ(error["code"], -32014);
    EXPECT_EQ(error["data"]["limit"], 96 * mebi);
    EXPECT_NE(error["message"].get<std::string>().find("96.0 MiB of --memory"), std::string::npos);
    EXPECT_NE(error["data"]["hint"].get<std::string>().find("--memory"), std::string::npos);
    const json memory = client.result("server.stats")["memory"];
    EXPECT_GT(memory["refused"], 0);
    EXPECT_LE(memory["peak"].get<double>(), 1.1 * 96 * mebi);
    EXPECT_TRUE(set_surface(0.5)["result"]["complete"]);
}

} // namespace wakesurf::tests::memory_stats_test
