// The JSON-RPC envelope over both transports: the answers a script gets are the same over POST /rpc and the WebSocket.
#include "protocol/api/openrpc.hpp"
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace wakesurf::tests::transport_test {

using nlohmann::json;

namespace {

class Transport : public ServerSuite {
  protected:
    /// Leaves of errors their codes.
    static json stripped(json value) {
        if (value.is_array())
            for (json& each : value)
                each = stripped(each);
        else if (value.contains("error"))
            value["error"] = value["error"]["code"];
        return value;
    }

    static json over_http(const std::string& text) {
        return stripped(json::parse(server_->rpc(text)));
    }

    static json over_websocket(const std::string& text) {
        WebSocketClient client(*server_, "");
        client.send_frame(1, text);
        return stripped(json::parse(client.receive().payload));
    }
};

} // namespace

TEST_F(Transport, AnswersTheSameOverBoth) {
    const std::map<std::string, std::string> vectors{
        {R"({"jsonrpc":"2.0","method":"server.ping","id":1})",
         R"({"jsonrpc":"2.0","id":1,"result":{}})"},
        {R"({"jsonrpc":"2.0","method":"server.ping","params":[],"id":"a"})",
         R"({"jsonrpc":"2.0","id":"a","result":{}})"},
        {R"({"jsonrpc":"2.0","method":"server.ping","params":{},"id":1.5})",
         R"({"jsonrpc":"2.0","id":1.5,"result":{}})"},
        {R"({"jsonrpc":"2.0","method":"server.ping","id":null})",
         R"({"jsonrpc":"2.0","id":null,"result":{}})"},
        {R"({"jsonrpc":"2.0","method":"foobar","id":"1"})",
         R"({"jsonrpc":"2.0","id":"1","error":-32601})"},
        {R"({"jsonrpc":"2.0","method":"rpc.foobar","id":"1"})",
         R"({"jsonrpc":"2.0","id":"1","error":-32601})"},
        {R"({"jsonrpc":"2.0","method":"foobar,"params":"bar","baz])",
         R"({"jsonrpc":"2.0","id":null,"error":-32700})"},
        {R"({"jsonrpc":"2.0","method":1,"params":"bar"})",
         R"({"jsonrpc":"2.0","id":null,"error":-32600})"},
        {R"([{"jsonrpc":"2.0","method":"server.ping","id":"1"},{"jsonrpc":"2.0","method"])",
         R"({"jsonrpc":"2.0","id":null,"error":-32700})"},
        {"[]", R"({"jsonrpc":"2.0","id":null,"error":-32600})"},
        {"[1]", R"([{"jsonrpc":"2.0","id":null,"error":-32600}])"},
        {R"([{"jsonrpc":"2.0","method":"server.ping","id":"1"},{"jsonrpc":"2.0","method":"server.ping"},{"foo":"boo"},
             {"jsonrpc":"2.0","method":"foo.get","id":"5"},{"jsonrpc":"2.0","method":"server.ping","id":"1"}])",
         R"([{"jsonrpc":"2.0","id":"1","result":{}},{"jsonrpc":"2.0","id":null,"error":-32600},
             {"jsonrpc":"2.0","id":"5","error":-32601},{"jsonrpc":"2.0","id":"1","result":{}}])"},
    };
    for (const auto& [text, expected] : vectors) {
        EXPECT_EQ(over_http(text), json::parse(expected)) << text;
        EXPECT_EQ(over_websocket(text), json::parse(expected)) << text;
    }
}

TEST_F(Transport, AnswersNotificationsWithNothing) {
    for (
        const char* text :
        {R"({"jsonrpc":"2.0","method":"server.ping"})", R"({"jsonrpc":"2.0","method":"foobar"})",
         R"([{"jsonrpc":"2.0","method":"server.ping"},{"jsonrpc":"2.0","method":"server.ping"}])"}) {
        EXPECT_EQ(http(server_->port(), "POST", "/rpc", server_->bearer(), text).status, 204)
            << text;
        WebSocketClient client(*server_, "");
        client.send_frame(1, text);
        client.send({{"jsonrpc", "2.0"}, {"id", "next"}, {"method", "server.ping"}});
        EXPECT_EQ(json::parse(client.receive().payload)["id"], "next") << text;
    }
}

TEST_F(Transport, HoldsNobodyUpWhileAWaitIsOpen) {
    WebSocketClient client(*server_);
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{1, 0, 0}, {2, 0, 0}}}, {"seeds", 4}});
    const json surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                       {"kind", "stream"},
                                                       {"dataset", "lamb-oseen"},
                                                       {"from", 0},
                                                       {"to", 1}});
    const int waiting = client.next_id();
    client.send({{"jsonrpc", "2.0"},
                 {"id", waiting},
                 {"method", "surface.wait"},
                 {"params", {{"surface", surface["surface"]}, {"epoch", 99}, {"timeoutMs", 50}}}});
    EXPECT_EQ(client.result("server.ping"), json::object());
    EXPECT_EQ(client.answer(waiting)["result"]["complete"], false);
}

TEST_F(Transport, GivesAnEditOfAnOldRevisionTheCurrentRecord) {
    WebSocketClient client(*server_);
    json edit{{"kind", "line"}, {"points", {{1, 0, 0}, {2, 0, 0}}}, {"seeds", 4}};
    edit["rake"] = client.result("rake.set", edit)["rake"];
    edit["ifRev"] = 1;
    EXPECT_EQ(client.result("rake.set", edit)["rev"], 2);
    const json error = client.call("rake.set", edit)["error"];
    EXPECT_EQ(error["code"], -32801);
    EXPECT_EQ(error["data"]["current"]["rev"], 2);
}

TEST_F(Transport, ResumesAPlaceAfterALostConnection) {
    json joined;
    {
        WebSocketClient client(*server_, "");
        joined = client.result("session.join", {{"session", "main"}, {"name", "Ada"}});
        client.socket().reset();
    }
    WebSocketClient client(*server_, "");
    const json again = client.result("session.join",
                                     {{"session", "main"}, {"resumeToken", joined["resumeToken"]}});
    EXPECT_EQ(again["you"], joined["you"]);
    EXPECT_EQ(again["participants"].back()["name"], "Ada");
}

TEST_F(Transport, TellsWhatTheServerIs) {
    const json info =
        json::parse(server_->rpc(R"({"jsonrpc":"2.0","method":"server.info","id":1})"))["result"];
    EXPECT_EQ(info["name"], "wakesurf");
    EXPECT_EQ(info["apiLevel"], protocol::api_level);
    EXPECT_EQ(info["limits"]["messageBytes"], 65536);
    const json dataset = json::parse(server_->rpc(
        R"({"jsonrpc":"2.0","method":"dataset.describe","params":{"dataset":"lamb-oseen"},"id":1})"))
        ["result"];
    EXPECT_EQ(dataset["grid"], "analytic");
    EXPECT_EQ(dataset["lattice"]["bits"], 16);
    const json discovered =
        json::parse(server_->rpc(R"({"jsonrpc":"2.0","method":"rpc.discover","id":1})"))["result"];
    EXPECT_EQ(discovered,
              json::parse(http(server_->port(), "GET", "/openrpc.json", server_->bearer()).body));
}

} // namespace wakesurf::tests::transport_test
