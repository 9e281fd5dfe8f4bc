// What RFC 6455 says about a connection beyond its frames (those: websocket_conformance_test): the opening handshake, frames that come with
// it, and pings without end.
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/server/websocket_frames.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace wakesurf::tests::websocket_rules_test {

using nlohmann::json;
using namespace ws;

namespace {

class WebSocketRules : public ServerSuite {
  protected:
    static void SetUpTestSuite() { start({"flow:abc"}); }
};

} // namespace

TEST_F(WebSocketRules, TakeFramesThatComeWithTheHandshake) {
    for (const std::size_t size : {std::size_t{10}, std::size_t{3000}}) {
        RawSocket socket(server_->port());
        socket.send("GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer " +
                    server_->token() +
                    "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n" +
                    frame(fin | text, call("nine", size)) + frame(fin | ping, "and this"));
        EXPECT_NE(socket.receive_until("\r\n\r\n").find("101"), std::string::npos);
        const std::string answer = R"({"jsonrpc":"2.0","id":"nine","result":{}})";
        EXPECT_NE(socket.receive_until(answer).find(answer), std::string::npos);
    }
}

TEST_F(WebSocketRules, PutEachLengthBehindTheHeaderThatSaysIt) {
    WebSocketClient client(*server_, "");
    const auto answer = [&](const std::string& method, std::size_t id) {
        client.send({{"jsonrpc", "2.0"}, {"method", method}, {"id", std::string(id, 'i')}});
        return client.receive().payload;
    };
    for (const auto& [method, size] : {std::pair{"server.ping", 125u},
                                       {"server.ping", 126u},
                                       {"no.method", 65535u},
                                       {"no.method", 65536u}}) {
        const std::size_t id = size - answer(method, 0).size();
        const std::string payload = answer(method, id);
        EXPECT_EQ(payload.size(), size);
        EXPECT_EQ(json::parse(payload)["id"], std::string(id, 'i'));
    }
}

TEST_F(WebSocketRules, SayWhatAnEventGivesAClientBeforeItsFrames) {
    WebSocketClient client(*server_);
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{1, 1, 1}, {2, 2, 2}}}, {"seeds", 8}});
    const json surface = client.result(
        "surface.set",
        {{"rake", rake["rake"]}, {"kind", "stream"}, {"dataset", "abc"}, {"from", 0}, {"to", 1}});
    client.result("surface.wait", {{"surface", surface["surface"]}, {"timeoutMs", 60000}});
    client.send({{"jsonrpc", "2.0"},
                 {"id", "subscribe"},
                 {"method", "surface.subscribe"},
                 {"params", {{"surface", surface["surface"]}}}});
    bool answered = false;
    for (auto message = client.receive(); message.opcode != binary; message = client.receive()) {
        ASSERT_EQ(message.opcode, text);
        answered = answered || json::parse(message.payload).value("id", "") == "subscribe";
    }
    EXPECT_TRUE(answered);
}

TEST_F(WebSocketRules, EndTheConnectionOfWhoeverPingsWithoutEnd) {
    WebSocketClient client(*server_, "");
    const json link = client.result("session.share", {{"session", "main"}, {"role", "viewer"}});
    WebSocketClient flood(*server_, "",
                          {{"Authorization", "Bearer " + link["key"].get<std::string>()}});
    constexpr int at_once = 200;
    std::string pings;
    for (int i = 0; i < at_once; ++i)
        pings += frame(fin | ping, "");
    WebSocketClient::Message answer;
    for (int i = 0; i < 1000 && answer.opcode != closing; ++i) {
        flood.socket().send(pings);
        for (int k = 0; k < at_once && answer.opcode != closing; ++k)
            answer = flood.receive();
    }
    EXPECT_EQ(answer.close_code(), 1008u);
    EXPECT_EQ(client.result("server.ping"), json::object());
}

TEST_F(WebSocketRules, RefuseHandshakesThatAreNone) {
    const auto upgrade = [](const std::string& method, const std::string& headers) {
        RawSocket socket(server_->port());
        socket.send(method + " /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer " +
                    server_->token() + "\r\n" + headers + "\r\n");
        return read_reply(socket);
    };
    const std::string key = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    const std::string both = "Upgrade: websocket\r\nConnection: Upgrade\r\n";
    const std::string version = "Sec-WebSocket-Version: 13\r\n";
    const HttpReply good = upgrade("GET", both + key + version);
    EXPECT_EQ(good.status, 101);
    EXPECT_EQ(good.header("sec-websocket-accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
    EXPECT_EQ(good.header("sec-websocket-extensions"), "") << "nothing is compressed";
    EXPECT_EQ(
        upgrade("GET", both + key + version + "Sec-WebSocket-Extensions: permessage-deflate\r\n")
            .header("sec-websocket-extensions"),
        "");
    const HttpReply old = upgrade("GET", both + key + "Sec-WebSocket-Version: 8\r\n");
    EXPECT_EQ(old.status, 426);
    EXPECT_EQ(old.header("sec-websocket-version"), "13");
    EXPECT_EQ(old.header("x-content-type-options"), "nosniff");
    EXPECT_EQ(upgrade("GET", both + version).status, 400) << "no key";
    EXPECT_EQ(upgrade("GET", "Upgrade: websocket\r\n" + key + version).status, 426);
    EXPECT_EQ(upgrade("POST", both + key + version + "Content-Length: 0\r\n").status, 405);
}

} // namespace wakesurf::tests::websocket_rules_test
