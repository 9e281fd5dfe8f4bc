// dataset.open against the real program: several wait for one import, and the last who does not want it any more ends it.
#include "server/base/limits.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/slow_series.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <string>
#include <thread>

namespace wakesurf::tests::dataset_open_test {

using nlohmann::json;

namespace {

class DatasetOpen : public testing::Test {
  protected:
    static int open(WebSocketClient& client, const json& more = json::object()) {
        json parameters{{"dataset", "u_00"}};
        parameters.update(more);
        const int id = client.next_id();
        client.send(
            {{"jsonrpc", "2.0"}, {"id", id}, {"method", "dataset.open"}, {"params", parameters}});
        return id;
    }

    static void cancel(WebSocketClient& client, int id) {
        client.send({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", id}}}});
    }

    static json entry(WebSocketClient& client) {
        return client.result("dataset.list")["datasets"][0];
    }

    /// Until the import has some time-steps, and not all. Others connect after it: a client that waits for one connection reads no
    /// other, and the server ends one whose pings no one answers for 40 s.
    static void wait_for_some(WebSocketClient& client) {
        json now = entry(client);
        while (now["state"] == "importing" && now["steps"]["ready"] == 0)
            now = client.notification("dataset.patched");
        ASSERT_EQ(now["state"], "importing");
    }

    bool tidied_up() const {
        for (int i = 0; i < 3000 && unfinished_files(folder / "cache") > 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return unfinished_files(folder / "cache") == 0;
    }

    TemporaryFolder folder;
    ServerProcess server{
        {write_slow_series(folder.path()), "flow:abc", "--store", folder / "cache"}};
    WebSocketClient ada{server};
};

} // namespace

TEST_F(DatasetOpen, TheLastWhoCancelsStopsTheImportAndWhoOpensItAgainHasItGoOn) {
    const int first = open(ada);
    wait_for_some(ada);
    WebSocketClient bob(server);
    const int second = open(bob);
    bob.result("server.ping"); // he waits now
    cancel(ada, first);
    EXPECT_EQ(ada.answer(first)["error"]["code"], -32800);
    EXPECT_EQ(entry(ada)["state"], "importing") << "Bob still waits";
    cancel(bob, second);
    EXPECT_EQ(bob.answer(second)["error"]["code"], -32800);
    const json stopped = entry(bob);
    EXPECT_EQ(stopped["state"], "stopped");
    EXPECT_LT(stopped["steps"]["ready"], 40);
    EXPECT_TRUE(tidied_up());
    EXPECT_EQ(entry(bob), stopped) << "nothing goes on";
    EXPECT_EQ(ada.result("dataset.describe", {{"dataset", "u_00"}})["times"].size(), 40u)
        << "what is there can be used";
    const json rake = ada.result(
        "rake.set", {{"kind", "line"}, {"points", {{-1, 0, 0}, {1, 0, 0}}}, {"seeds", 8}});
    const json surface = ada.result(
        "surface.set",
        {{"rake", rake["rake"]}, {"kind", "stream"}, {"dataset", "abc"}, {"from", 0}, {"to", 1}});
    EXPECT_EQ(ada.result("surface.wait", {{"surface", surface["surface"]},
                                          {"timeoutMs", server::limits::wait_ms}})["complete"],
              true);
    const json whole = ada.result("dataset.open", {{"dataset", "u_00"}});
    EXPECT_EQ(whole["state"], "ready");
    EXPECT_EQ(whole["steps"], json({{"ready", 40}, {"total", 40}}));
    EXPECT_TRUE(tidied_up());
}

TEST_F(DatasetOpen, WhoStillWaitsGetsTheDatasetAndIsToldHowFarItIs) {
    const int first = open(ada);
    wait_for_some(ada);
    WebSocketClient bob(server);
    const int second = open(bob, {{"workDoneToken", "bar"}});
    bob.result("server.ping");
    cancel(ada, first);
    double newest = 0;
    for (json told = bob.notification("$/progress");; told = bob.notification("$/progress")) {
        EXPECT_EQ(told["token"], "bar");
        const json& value = told["value"];
        if (value["kind"] != "begin") {
            EXPECT_GE(value["percentage"], newest);
            newest = value["percentage"];
        }
        if (value["kind"] == "end")
            break;
    }
    EXPECT_EQ(newest, 100);
    EXPECT_EQ(bob.answer(second)["result"]["state"], "ready");
}

TEST_F(DatasetOpen, ALostConnectionStopsNothing) {
    {
        WebSocketClient eve(server);
        open(eve);
        eve.result("server.ping");
        eve.socket().reset();
    }
    EXPECT_EQ(ada.result("dataset.open", {{"dataset", "u_00"}})["state"], "ready");
}

TEST_F(DatasetOpen, AViewerOfALinkWaitsButNeitherStopsNorStarts) {
    const json link = ada.result("session.share", {{"session", "main"}, {"role", "viewer"}});
    const std::string key = link["key"];
    wait_for_some(ada);
    WebSocketClient viewer(server, "main", {{"Authorization", "Bearer " + key}});
    const int id = open(viewer);
    cancel(viewer, id);
    EXPECT_EQ(viewer.answer(id)["error"]["code"], -32800);
    EXPECT_EQ(entry(ada)["state"], "importing");
    const int mine = open(ada);
    cancel(ada, mine);
    ada.answer(mine);
    ASSERT_EQ(entry(ada)["state"], "stopped");
    const json refused = viewer.call("dataset.open", {{"dataset", "u_00"}})["error"];
    EXPECT_EQ(refused["code"], -32800);
    EXPECT_NE(refused["message"].get<std::string>().find("stopped"), std::string::npos);
    EXPECT_EQ(entry(ada)["state"], "stopped");
}

TEST_F(DatasetOpen, AnswersAtOnceWhereThereIsNothingToWaitFor) {
    EXPECT_EQ(ada.result("dataset.open", {{"dataset", "abc"}})["state"], "ready");
    EXPECT_EQ(ada.call("dataset.open", {{"dataset", "nothing"}})["error"]["code"], -32004);
    EXPECT_EQ(ada.result("dataset.open", {{"dataset", "u_00"}, {"timeoutMs", 0}})["state"],
              "importing");
    EXPECT_EQ(entry(ada)["state"], "importing") << "whose patience ends stops nothing";
}

TEST_F(DatasetOpen, ANotificationGoesOnWithAnImportButNeitherWaitsNorIsToldOfIt) {
    const int mine = open(ada);
    cancel(ada, mine);
    ada.answer(mine);
    ASSERT_EQ(entry(ada)["state"], "stopped");
    WebSocketClient bob(server);
    bob.send({{"jsonrpc", "2.0"},
              {"method", "dataset.open"},
              {"params", {{"dataset", "u_00"}, {"workDoneToken", "unheard"}}}});
    EXPECT_EQ(entry(bob)["state"], "importing");
    const int heard = open(bob, {{"workDoneToken", "heard"}});
    EXPECT_EQ(bob.notification("$/progress")["token"], "heard");
    cancel(bob, heard);
    bob.answer(heard);
    EXPECT_EQ(entry(bob)["state"], "stopped") << "no one else waits";
}

} // namespace wakesurf::tests::dataset_open_test
