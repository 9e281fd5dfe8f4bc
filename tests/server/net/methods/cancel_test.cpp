// $/cancelRequest and $/progress against the real program: who waits can stop waiting, and is told how far the work is.
#include "server/base/limits.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace wakesurf::tests::cancel_test {

using nlohmann::json;

namespace {

class Cancel : public testing::Test {
  protected:
    /// Takes seconds to build, so that it is under way whatever else the machine does.
    std::string long_surface() {
        const json rake = client.result(
            "rake.set", {{"kind", "line"}, {"points", {{-9, 0, 0}, {9, 0.1, 0}}}, {"seeds", 256}});
        return client.result("surface.set", {{"rake", rake["rake"]},
                                             {"kind", "stream"},
                                             {"dataset", "abc"},
                                             {"from", 0},
                                             {"to", 200},
                                             {"separation", 0.01},
                                             {"maxQuads", 4000000}})["surface"];
    }

    int wait_for(const std::string& surface, const json& more = json::object()) {
        json parameters{{"surface", surface}, {"timeoutMs", server::limits::wait_ms}};
        parameters.update(more);
        const int id = client.next_id();
        client.send(
            {{"jsonrpc", "2.0"}, {"id", id}, {"method", "surface.wait"}, {"params", parameters}});
        return id;
    }

    void cancel(const json& id) {
        client.send({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", id}}}});
    }

    ServerProcess server{{"flow:abc", "flow:lamb-oseen"}};
    WebSocketClient client{server};
};

} // namespace

TEST_F(Cancel, AnswersAnOpenCallWithItsKind) {
    const int id = wait_for(long_surface());
    client.result("server.ping"); // the wait is open now
    cancel(id);
    const json error = client.answer(id)["error"];
    EXPECT_EQ(error["code"], -32800);
    EXPECT_EQ(error["data"]["kind"], "cancelled");
    EXPECT_FALSE(error["data"]["hint"].get<std::string>().empty());
}

TEST_F(Cancel, LeavesTheOtherCallsAndTheSurfaceAlone) {
    const std::string surface = long_surface();
    const int first = wait_for(surface);
    const int second = wait_for(surface);
    cancel(first);
    EXPECT_EQ(client.answer(first)["error"]["code"], -32800);
    cancel(second);
    EXPECT_EQ(client.answer(second)["error"]["code"], -32800);
    EXPECT_FALSE(client.result("surface.stats", {{"surface", surface}}).contains("error"));
}

TEST_F(Cancel, IgnoresWhatIsAnsweredUnknownOrAnotherConnections) {
    const int id = wait_for(long_surface());
    WebSocketClient other(server);
    other.send({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", id}}}});
    EXPECT_EQ(other.result("server.ping"), json::object());
    cancel(id + 100);
    cancel("no such id");
    EXPECT_EQ(client.result("server.ping"), json::object())
        << "with nothing in between but its own answer";
    cancel(id);
    EXPECT_EQ(client.answer(id)["error"]["code"], -32800);
    cancel(id);
    EXPECT_EQ(client.result("server.ping"), json::object());
}

TEST_F(Cancel, GivesBackTheWaitersPlace) {
    const std::string surface = long_surface();
    for (int round = 0; round < 200; ++round) // more than may wait at a time
        cancel(wait_for(surface));
    const int id = wait_for(surface);
    cancel(id);
    EXPECT_EQ(client.answer(id)["error"]["code"], -32800);
}

TEST_F(Cancel, RefusesAnIdThatIsNone) {
    for (const json& id : {json::array(), json::object(), json(true), json(nullptr)})
        EXPECT_EQ(client.call("$/cancelRequest", {{"id", id}})["error"]["code"], -32602) << id;
    EXPECT_EQ(client.call("$/cancelRequest", json::object())["error"]["code"], -32602);
}

TEST_F(Cancel, BoundsTheCallsThatAreOpen) {
    std::vector<std::string> surfaces;
    for (int i = 0; i < 5; ++i)
        surfaces.push_back(long_surface());
    int id = 0;
    for (int i = 0; i < 257; ++i)
        id = wait_for(surfaces[static_cast<std::size_t>(i % 5)]);
    const json error = client.answer(id)["error"];
    EXPECT_EQ(error["code"], -32014);
    EXPECT_EQ(error["data"]["limit"], 256);
}

TEST_F(Cancel, ProgressBeginsReportsAndEndsBeforeTheAnswer) {
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{-5, 0, 0}, {5, 0.1, 0}}}, {"seeds", 64}});
    const std::string surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                              {"kind", "stream"},
                                                              {"dataset", "abc"},
                                                              {"from", 0},
                                                              {"to", 8},
                                                              {"separation", 0.05}})["surface"];
    const auto start = std::chrono::steady_clock::now();
    client.send({{"jsonrpc", "2.0"},
                 {"id", "w"},
                 {"method", "surface.wait"},
                 {"params",
                  {{"surface", surface},
                   {"timeoutMs", server::limits::wait_ms},
                   {"workDoneToken", "t1"}}}});
    std::vector<json> told;
    json answer;
    while (answer.is_null()) {
        const json message = json::parse(client.receive().payload);
        if (message.value("id", json()) == "w")
            answer = message;
        else if (message["method"] == "$/progress") {
            EXPECT_EQ(message["params"]["token"], "t1");
            told.push_back(message["params"]["value"]);
        }
    }
    ASSERT_GE(told.size(), 2u);
    EXPECT_EQ(told.front()["kind"], "begin");
    EXPECT_EQ(told.back()["kind"], "end");
    EXPECT_EQ(told.back()["phase"], "final");
    EXPECT_EQ(told.back()["quads"], answer["result"]["quads"]);
    EXPECT_EQ(told.back()["percentage"], 100);
    for (std::size_t i = 1; i + 1 < told.size(); ++i) {
        EXPECT_EQ(told[i]["kind"], "report") << told[i];
        EXPECT_GE(told[i]["percentage"], i == 1 ? json(0) : told[i - 1]["percentage"]) << told[i];
        EXPECT_LE(told[i]["percentage"], 100);
        EXPECT_GE(told[i]["seconds"], i == 1 ? json(0) : told[i - 1]["seconds"]) << told[i];
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LE(static_cast<double>(told.size()) - 2, 10 * took.count() + 1) << "ten a second";
    EXPECT_EQ(client.result("server.ping"), json::object()) << "nothing follows the end";
}

TEST_F(Cancel, ProgressOfACancelledCallStopsWithItsAnswer) {
    const int id = wait_for(long_surface(), {{"workDoneToken", 7}});
    EXPECT_EQ(client.notification("$/progress")["value"]["kind"], "begin");
    cancel(id);
    EXPECT_EQ(client.answer(id)["error"]["code"], -32800);
    EXPECT_EQ(
        client.call("surface.wait",
                    {{"surface", "s1"}, {"timeoutMs", 0}, {"workDoneToken", {1}}})["error"]["code"],
        -32602);
}

TEST_F(Cancel, NoProgressIsToldOfANotificationWhichNothingCouldStop) {
    const std::string surface = long_surface();
    const auto notify = [&](WebSocketClient& from) {
        from.send({{"jsonrpc", "2.0"},
                   {"method", "surface.wait"},
                   {"params",
                    {{"surface", surface},
                     {"timeoutMs", server::limits::wait_ms},
                     {"workDoneToken", "unheard"}}}});
    };
    {
        WebSocketClient eve(server);
        notify(eve);
        eve.result("server.ping");
    }
    notify(client);
    const int id = wait_for(surface, {{"workDoneToken", "heard"}});
    EXPECT_EQ(client.notification("$/progress")["token"], "heard");
    EXPECT_EQ(client.notification("$/progress")["token"], "heard") << "and later";
    cancel(id);
    EXPECT_EQ(client.answer(id)["error"]["code"], -32800);
}

} // namespace wakesurf::tests::cancel_test
