// RFC 6455 case by case over raw sockets. After every case that may go on, a marker shows that the connection does.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_cases.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>

namespace wakesurf::tests::websocket_conformance_test {

using nlohmann::json;
using namespace ws;

namespace {

class WebSocketConformance : public testing::TestWithParam<Case> {
  protected:
    static void SetUpTestSuite() { server_ = new ServerProcess({"flow:abc"}); }

    static void TearDownTestSuite() { delete server_; }

    static ServerProcess* server_;
};

ServerProcess* WebSocketConformance::server_ = nullptr;

void send_in_chunks(RawSocket& socket, const std::string& bytes, std::size_t chunk) {
    for (std::size_t at = 0; at < bytes.size(); at += chunk)
        socket.send(bytes.substr(at, chunk));
}

std::string said(const WebSocketClient::Message& message) {
    return fmt::format("opcode {}, `{}`", message.opcode, message.payload.substr(0, 200));
}

} // namespace

TEST_P(WebSocketConformance, IsAnsweredAsTheStandardSays) {
    const Case& each = GetParam();
    WebSocketClient client(*server_, "");
    send_in_chunks(client.socket(), each.bytes, each.chunk == 0 ? each.bytes.size() : each.chunk);
    std::optional<WebSocketClient::Message> held; ///< received, not judged yet
    for (const Expected& wanted : each.expected) {
        const auto message = held ? *std::exchange(held, std::nullopt) : client.receive();
        switch (wanted.kind) {
        case Expected::Kind::Pong:
            ASSERT_EQ(message.opcode, pong) << said(message);
            EXPECT_EQ(message.payload, wanted.payload);
            break;
        case Expected::Kind::Echo:
            ASSERT_EQ(message.opcode, text) << said(message);
            EXPECT_EQ(json::parse(message.payload)["id"], wanted.payload);
            break;
        case Expected::Kind::EchoIfSent:
            if (message.opcode == text)
                EXPECT_EQ(json::parse(message.payload)["id"], wanted.payload);
            else
                held = message;
            break;
        case Expected::Kind::ParseError:
            ASSERT_EQ(message.opcode, text) << said(message);
            EXPECT_EQ(json::parse(message.payload)["error"]["code"], -32700);
            break;
        case Expected::Kind::Close:
            ASSERT_EQ(message.opcode, closing) << said(message);
            EXPECT_EQ(message.close_code(), wanted.code) << said(message);
            client.socket().send(frame(fin | closing, close_payload(1000)));
            EXPECT_TRUE(client.socket().closes());
            return;
        }
    }
    client.socket().send(frame(fin | text, call("marker")));
    const auto marker = client.receive();
    ASSERT_EQ(marker.opcode, text) << said(marker);
    EXPECT_EQ(json::parse(marker.payload)["id"], "marker")
        << "the connection goes on, and nothing else was said";
}

INSTANTIATE_TEST_SUITE_P(Rfc6455,
                         WebSocketConformance,
                         testing::ValuesIn(all_cases()),
                         [](const auto& each) { return each.param.name; });

} // namespace wakesurf::tests::websocket_conformance_test
