// family.make and family.remove against the real program.
#include "store/store_generation.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::tests::family_methods_test {

using nlohmann::json;

namespace {

void generate(const TemporaryFolder& folder) {
    store::GenerateRequest request{
        .flow = "cylinder", .grid = {{-3, -2, -1}, {0.25, 0.25, 0.5}, {33, 17, 5}}, .times = {0.0}};
    ASSERT_TRUE(
        store::generate_store(request, folder / "flow", [](const store::ImportProgress&) {}, {}));
}

json call(const ServerProcess& server, const std::string& method, const json& parameters) {
    const json request{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}};
    return json::parse(server.rpc(request.dump()));
}

const json psi{{"dataset", "flow"},
               {"name", "psi"},
               {"from", "curve"},
               {"rakeKind", "line"},
               {"points", {{-2, 0.25, -1}, {-2, 0.25, 1}}}};

} // namespace

TEST(FamilyMethods, MakeAFieldThatEverybodyIsToldOfAndThatIsThereAfterARestart) {
    const TemporaryFolder folder;
    generate(folder);
    {
        ServerProcess server({folder / "flow"});
        ASSERT_EQ(call(server, "dataset.open", {{"dataset", "flow"}})["result"]["state"], "ready");
        WebSocketClient other(server);
        const json made = call(server, "family.make", psi);
        ASSERT_TRUE(made.contains("result")) << made;
        EXPECT_GT(made["result"]["steps"][0]["reached"], 1000);
        EXPECT_GT(made["result"]["steps"][0]["obstacle"], 0);
        json told = other.notification("dataset.patched");
        while (!told.contains("families"))
            told = other.notification("dataset.patched");
        EXPECT_EQ(told["families"], json({"psi"})) << told;
        const json taken = call(server, "family.make", psi);
        EXPECT_EQ(taken["error"]["code"], -32602) << taken;
    }
    ServerProcess server({folder / "flow"});
    ASSERT_EQ(call(server, "dataset.open", {{"dataset", "flow"}})["result"]["state"], "ready");
    const json described = call(server, "dataset.describe", {{"dataset", "flow"}})["result"];
    EXPECT_EQ(described["families"][0]["points"], psi["points"]);
    EXPECT_EQ(described["fields"].back()["family"], true);
    const auto& names = described["surfaceFields"];
    EXPECT_NE(std::find(names.begin(), names.end(), "psi"), names.end()) << names;
    const json values = call(server, "probe.sample",
                             {{"dataset", "flow"},
                              {"time", 0},
                              {"points", {{-2, 0.25, 0.5}, {-2, 1.0, 0}}},
                              {"fields", {"psi"}}})["result"]["values"]["psi"];
    EXPECT_NEAR(values[0].get<double>(), 0.0, 1e-6);
    EXPECT_NEAR(std::abs(values[1].get<double>()), 0.75, 1e-3); // its plane is across the flow
    EXPECT_EQ(call(server, "family.remove", {{"dataset", "flow"}, {"name", "psi"}})["result"],
              json::object());
    const json after = call(server, "dataset.describe", {{"dataset", "flow"}})["result"];
    EXPECT_FALSE(after.contains("families")) << after;
    EXPECT_EQ(
        call(server, "family.remove", {{"dataset", "flow"}, {"name", "psi"}})["error"]["code"],
        -32004);
}

TEST(FamilyMethods, RefuseWhatDoesNotBelongTogether) {
    const TemporaryFolder folder;
    generate(folder);
    ServerProcess server({folder / "flow", "flow:abc"});
    ASSERT_EQ(call(server, "dataset.open", {{"dataset", "flow"}})["result"]["state"], "ready");
    const json inflow{{"dataset", "flow"}, {"name", "psi"}, {"from", "inflow"}};
    const auto refused = [&](json change) {
        json parameters = inflow;
        parameters.update(change);
        return call(server, "family.make", parameters)["error"]["code"];
    };
    EXPECT_EQ(refused({{"from", "plane"}}), -32602);
    EXPECT_EQ(refused({{"from", "plane"}, {"point", {0, 0, 0}}}), -32602);
    EXPECT_EQ(refused({{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}}), -32602);
    EXPECT_EQ(refused({{"from", "curve"}, {"rakeKind", "line"}}), -32602);
    EXPECT_EQ(
        refused({{"from", "curve"}, {"rakeKind", "points"}, {"points", {{0, 0, 0}, {1, 0, 0}}}}),
        -32602);
    EXPECT_EQ(refused({{"dataset", "nothing"}}), -32004);
    EXPECT_EQ(refused({{"dataset", "abc"}}), -32602);
    EXPECT_EQ(refused({{"time", 5}}), -32013);
    EXPECT_EQ(refused({{"from", "plane"}, {"point", {90, 0, 0}}, {"normal", {1, 0, 0}}}), -32012);
}

TEST(FamilyMethods, LeaveRoomForTheHostsFamiliesWhereHoldersOfALinkMakeMany) {
    const TemporaryFolder folder;
    generate(folder);
    ServerProcess server({folder / "flow"});
    WebSocketClient host(server);
    host.result("dataset.open", {{"dataset", "flow"}});
    const json link = host.result("session.share", {{"role", "editor"}});
    WebSocketClient editor(server, "",
                           {{"Authorization", "Bearer " + link["key"].get<std::string>()}});
    editor.result("session.join");
    const auto make = [](WebSocketClient& by, int number) {
        json of = psi;
        of["name"] = "psi" + std::to_string(number);
        return by.call("family.make", of);
    };
    int made = 0;
    while (make(editor, made).contains("result"))
        ++made;
    EXPECT_EQ(made, 8);
    EXPECT_EQ(make(editor, made)["error"]["code"], -32014);
    EXPECT_TRUE(make(host, made).contains("result"));
}

TEST(FamilyMethods, TellTheirProgressAndEndWhenTheyAreCancelled) {
    const TemporaryFolder folder;
    generate(folder);
    ServerProcess server({folder / "flow"});
    ASSERT_EQ(call(server, "dataset.open", {{"dataset", "flow"}})["result"]["state"], "ready");
    WebSocketClient client(server);
    json parameters = psi;
    parameters["workDoneToken"] = "w";
    ASSERT_TRUE(client.result("family.make", parameters).contains("steps"));
    const json begun = client.notification("$/progress");
    EXPECT_EQ(begun["token"], "w");
    EXPECT_EQ(begun["value"]["kind"], "begin");
}

TEST(FamilyMethods, RefuseANameThatIsNoNameAlsoWhereProgressIsToldOfIt) {
    const TemporaryFolder folder;
    generate(folder);
    ServerProcess server({folder / "flow"});
    ASSERT_EQ(call(server, "dataset.open", {{"dataset", "flow"}})["result"]["state"], "ready");
    WebSocketClient client(server);
    for (const std::string name : {"{", "}", "{}x", "%n"}) {
        json parameters = psi;
        parameters["name"] = name;
        parameters["workDoneToken"] = name;
        EXPECT_TRUE(client.call("family.make", parameters).contains("error")) << name;
    }
}

} // namespace wakesurf::tests::family_methods_test
