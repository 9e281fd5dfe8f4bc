// RFC 6455 frame by frame, over raw sockets: what a peer must not send ends the connection with the code the RFC names,
// and what it may send is understood however it is cut up.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace wakesurf::tests {

using nlohmann::json;

namespace {

constexpr int fin = 0x80;
constexpr int text = 1;
constexpr int binary = 2;
constexpr int closing = 8;
constexpr int ping = 9;
constexpr int pong = 10;

enum class Length { Shortest, Two, Eight };

/// A masked frame; `first` is its whole first byte. The mask is not zero, so that unmasking is seen to be done.
std::string frame(int first, const std::string& payload, Length length = Length::Shortest) {
    const std::string mask("\x37\xfa\x21\x3d", 4);
    std::string bytes{static_cast<char>(first)};
    const std::size_t size = payload.size();
    if (length == Length::Shortest && size >= 126)
        length = size < 65536 ? Length::Two : Length::Eight;
    const int extra = length == Length::Shortest ? 0 : length == Length::Two ? 2 : 8;
    bytes += static_cast<char>(0x80 | (extra == 0   ? static_cast<int>(size)
                                       : extra == 2 ? 126
                                                    : 127));
    for (int i = extra - 1; i >= 0; --i)
        bytes += static_cast<char>((std::uint64_t{size} >> (8 * i)) & 0xff);
    bytes += mask;
    for (std::size_t i = 0; i < size; ++i)
        bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
    return bytes;
}

std::string close_payload(unsigned code, const std::string& reason = {}) {
    return std::string{static_cast<char>(code >> 8), static_cast<char>(code & 0xff)} + reason;
}

std::string ping_call(int id) {
    return json{{"jsonrpc", "2.0"}, {"id", id}, {"method", "server.ping"}}.dump();
}

class WebSocketRules : public testing::Test {
  protected:
    static void SetUpTestSuite() { server_ = new ServerProcess({"flow:abc"}); }

    static void TearDownTestSuite() { delete server_; }

    /// The code of the close frame `bytes` are answered with; 0: the connection ended without one.
    static unsigned closed_with(const std::string& bytes) {
        WebSocketClient client(*server_, "");
        client.socket().send(bytes);
        for (;;) {
            const auto message = client.receive();
            if (message.opcode == closing || message.opcode == 0) {
                client.socket().send(frame(fin | closing, close_payload(1000)));
                EXPECT_TRUE(client.socket().closed_within(std::chrono::seconds(15)));
                return message.opcode == 0 ? 0 : message.close_code();
            }
        }
    }

    static ServerProcess* server_;
};

ServerProcess* WebSocketRules::server_ = nullptr;

} // namespace

TEST_F(WebSocketRules, EndTheConnectionOfWhoeverBreaksThem) {
    struct Case {
        std::string what;
        std::string bytes;
        unsigned code;
    };

    std::vector<Case> cases{
        {"reserved bit 1", frame(fin | 0x40 | text, "{}"), 1002},
        {"reserved bit 2", frame(fin | 0x20 | text, "{}"), 1002},
        {"reserved bit 3", frame(fin | 0x10 | text, "{}"), 1002},
        {"reserved bit on a ping", frame(fin | 0x40 | ping, ""), 1002},
        {"an unmasked frame", std::string("\x81\x02{}", 4), 1002},
        {"a ping in fragments", frame(ping, "half"), 1002},
        {"a pong in fragments", frame(pong, "half"), 1002},
        {"a close in fragments", frame(closing, close_payload(1000)), 1002},
        {"a ping of 126 bytes", frame(fin | ping, std::string(126, 'p')), 1002},
        {"a close of 126 bytes", frame(fin | closing, close_payload(1000, std::string(124, 'r'))),
         1002},
        {"a close of one byte", frame(fin | closing, "\x03"), 1002},
        {"a close reason that is not UTF-8", frame(fin | closing, close_payload(1000, "\xff\xfe")),
         1002},
        {"the end of a message that never began", frame(fin | 0, "{}"), 1002},
        {"the middle of a message that never began", frame(0, "{}"), 1002},
        {"a message within a message", frame(text, "{") + frame(fin | text, "}"), 1002},
        {"a length of 2 in two bytes", frame(fin | text, "{}", Length::Two), 1002},
        {"a length of 2 in eight bytes", frame(fin | text, "{}", Length::Eight), 1002},
        {"text that is not UTF-8", frame(fin | text, "\"\xff\""), 1007},
        {"an overlong slash", frame(fin | text, "\"\xc0\xaf\""), 1007},
        {"a surrogate in UTF-8", frame(fin | text, "\"\xed\xa0\x80\""), 1007},
        {"a code point above the last", frame(fin | text, "\"\xf4\x90\x80\x80\""), 1007},
        {"a code point cut off at the end", frame(fin | text, "\"\xe2\x82"), 1007},
        {"bad UTF-8 in the second fragment", frame(text, "\"\xe2\x82") + frame(fin | 0, "\""),
         1007},
        {"a binary message", frame(fin | binary, "draco"), 1003},
        {"a binary message in fragments", frame(binary, "dr") + frame(fin | 0, "aco"), 1003},
        {"65,537 bytes in one frame", frame(fin | text, std::string(65537, ' ')), 1009},
        {"65,537 bytes in fragments",
         frame(text, std::string(65000, ' ')) + frame(fin | 0, std::string(537, ' ')), 1009},
        {"the announcement of 2^62 bytes",
         std::string("\x81\xff\x40\0\0\0\0\0\0\0\0\0\0\0", 14) + std::string(70000, ' '), 1009},
        {"the announcement of 2^63 bytes",
         std::string("\x81\xff\x80\0\0\0\0\0\0\0\0\0\0\0", 14) + std::string(70000, ' '), 1009},
        {"the announcement of 2^63 bytes, and nothing",
         std::string("\x81\xff\x80\0\0\0\0\0\0\0\0\0\0\0", 14), 1009},
    };
    for (const int opcode : {3, 4, 5, 6, 7, 11, 12, 13, 14, 15})
        cases.push_back(
            {"opcode " + std::to_string(opcode), frame(fin | opcode, "what is this"), 1002});
    for (const unsigned code : {0u, 1u, 999u, 1004u, 1005u, 1006u, 1015u, 1016u, 2999u})
        cases.push_back({"a close with code " + std::to_string(code),
                         frame(fin | closing, close_payload(code)), 1002});
    for (const auto& [what, bytes, code] : cases)
        EXPECT_EQ(closed_with(bytes), code) << what;
    WebSocketClient client(*server_, "");
    EXPECT_EQ(client.result("server.ping"), json::object()) << "the others are served";
}

TEST_F(WebSocketRules, EchoTheCodeOfACloseAndThenTheConnectionEnds) {
    for (const unsigned code : {1000u, 1001u, 1003u, 1007u, 1011u, 3000u, 4999u}) {
        WebSocketClient client(*server_, "");
        client.socket().send(frame(fin | closing, close_payload(code, "goodbye")) +
                             frame(fin | text, ping_call(1)));
        const auto message = client.receive();
        EXPECT_EQ(message.opcode, closing) << code;
        EXPECT_EQ(message.close_code(), code);
        EXPECT_EQ(client.receive().opcode, 0) << "what comes after a close is nobody's";
    }
    WebSocketClient client(*server_, "");
    client.socket().send(frame(fin | closing, ""));
    EXPECT_EQ(client.receive().opcode, closing);
}

TEST_F(WebSocketRules, AnswerPingsBetweenTheFragmentsOfAMessage) {
    WebSocketClient client(*server_, "");
    const std::string call = ping_call(5);
    const std::string payload(125, 'p');
    client.socket().send(frame(text, call.substr(0, 10)) + frame(fin | ping, payload) +
                         frame(fin | pong, "nobody asked") + frame(0, "") +
                         frame(0, call.substr(10, 7)) + frame(fin | ping, "") +
                         frame(fin | 0, call.substr(17)));
    const auto first = client.receive();
    EXPECT_EQ(first.opcode, pong);
    EXPECT_EQ(first.payload, payload);
    EXPECT_EQ(client.receive().opcode, pong);
    EXPECT_EQ(json::parse(client.receive().payload)["id"], 5);
}

TEST_F(WebSocketRules, UnderstandTextHoweverItIsCutUp) {
    const std::string call = R"({"jsonrpc":"2.0","id":"κῶμα €😀","method":"server.ping"})";
    WebSocketClient client(*server_, "");
    for (std::size_t cut = 1; cut < call.size(); ++cut) {
        client.socket().send(frame(text, call.substr(0, cut)) + frame(fin | 0, call.substr(cut)));
        EXPECT_EQ(json::parse(client.receive().payload)["id"], "κῶμα €😀") << cut;
    }
    std::string bytewise;
    for (std::size_t i = 0; i < call.size(); ++i)
        bytewise +=
            frame((i == 0 ? text : 0) | (i + 1 == call.size() ? fin : 0), call.substr(i, 1));
    for (const char byte : bytewise)
        client.socket().send(std::string(1, byte));
    EXPECT_EQ(json::parse(client.receive().payload)["id"], "κῶμα €😀");
    client.socket().send(
        frame(fin | text, ping_call(1) + std::string(65536 - ping_call(1).size(), ' ')));
    EXPECT_EQ(json::parse(client.receive().payload)["id"], 1) << "as long as a message may be";
    client.socket().send(frame(fin | text, ""));
    EXPECT_EQ(json::parse(client.receive().payload)["error"]["code"], -32700);
}

TEST_F(WebSocketRules, TakeFramesThatComeWithTheHandshake) {
    for (const std::size_t size : {std::size_t{10}, std::size_t{3000}}) {
        RawSocket socket(server_->port());
        std::string call = ping_call(9);
        call.resize(std::max(call.size(), size), ' ');
        socket.send("GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer " +
                    server_->token() +
                    "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n" +
                    frame(fin | text, call) + frame(fin | ping, "and this"));
        EXPECT_NE(socket.receive_until("\r\n\r\n").find("101"), std::string::npos);
        const std::string answer = R"({"jsonrpc":"2.0","id":9,"result":{}})";
        EXPECT_NE(socket.receive_until(answer).find(answer), std::string::npos);
    }
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
    EXPECT_EQ(upgrade("GET", both + key).status, 400) << "no version";
    for (const char* wrong : {"short", "dGhlIHNhbXBsZSBub25jZQ=", "dGhlIHNhbXBsZSBub25jZQ==A",
                              "dGhlIHNhbXBsZSBub25jZ!==", "dGhlIHNhbXBsZSBub25jZTEy"})
        EXPECT_EQ(upgrade("GET", both + version + "Sec-WebSocket-Key: " + wrong + "\r\n").status,
                  400)
            << wrong;
    EXPECT_EQ(upgrade("GET", both + key + key + version).status, 400) << "two keys";
    EXPECT_EQ(upgrade("GET", "Upgrade: websocket\r\n" + key + version).status, 426);
    EXPECT_EQ(upgrade("GET", "Connection: Upgrade\r\nUpgrade: h2c\r\n" + key + version).status,
              426);
    EXPECT_EQ(upgrade("POST", both + key + version + "Content-Length: 0\r\n").status, 405);
}

} // namespace wakesurf::tests
