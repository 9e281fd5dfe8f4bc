// RFC 6455 over raw sockets. Beast reads frames, and its own tests go through all of the standard: here is what is ours: parts and
// limits of messages, what is answered, how the bytes are cut up on the way. server.ping answers with the id
// of the call, which makes it the echo of such tests.
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/server/websocket_frames.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests::websocket_conformance_test {

using nlohmann::json;
using namespace ws;

namespace {

/// Says what a connection answers, in order: "echo ID", "parse error" or "close CODE", which
/// ends it. With a question mark an answer need not be there: the standard lets a server that ends a
/// connection drop what it has not sent yet.
using Answers = std::vector<std::string>;

struct Case {
    std::string name;
    std::string bytes;
    Answers answers;
    std::size_t chunk = 0; ///< bytes sent at a time; 0: all at once
};

void PrintTo(const Case& each, std::ostream* out) {
    *out << each.name;
}

std::string whole(const std::string& payload) {
    return frame(fin | text, payload);
}

/// A text message in frames of at most `size` bytes.
std::string in_fragments(const std::string& payload, std::size_t size) {
    std::string bytes;
    for (std::size_t at = 0; at < payload.size(); at += size)
        bytes += frame((at == 0 ? text : continuation) | (at + size >= payload.size() ? fin : 0),
                       payload.substr(at, size));
    return bytes;
}

const std::string goodbye = frame(fin | closing, close_payload(1000));
const std::string too_long(65537, ' ');

/// What we do with messages that Beast has read.
const std::vector<Case> ours{
    {"an_empty_message", whole(""), {"parse error"}},
    {"a_binary_message", frame(fin | binary, "draco"), {"close 1003"}},
    {"an_empty_binary_message", frame(fin | binary, ""), {"close 1003"}},
    {"a_binary_message_in_fragments",
     frame(binary, "dr") + frame(fin | continuation, "aco"),
     {"close 1003"}},
    {"a_call_then_a_close", whole(call("a")) + goodbye, {"echo? a", "close 1000"}},
    {"a_close_within_a_message", frame(text, "{") + goodbye, {"close 1000"}},
    {"calls_behind_a_close",
     goodbye + whole(call("late")) + frame(fin | ping, "late"),
     {"close 1000"}},
    {"a_thousand_fragments", in_fragments(call("many", 1000), 1), {"echo many"}},
    {"one_byte_too_much", whole(too_long), {"close 1009"}},
    {"one_byte_too_much_in_fragments", in_fragments(too_long, 65000), {"close 1009"}},
    {"one_byte_too_much_in_small_fragments", in_fragments(too_long, 1024), {"close 1009"}},
    {"fragments_announced_beyond_the_limit",
     frame(text, std::string(40000, ' ')) + head(fin | continuation, std::uint64_t{2} << 20),
     {"close 1009"}},
};

std::vector<Case> all_cases() {
    std::vector<Case> cases = ours;
    for (const std::size_t size : {1024u, 65536u})
        for (const std::size_t chunk : {0u, 997u})
            cases.push_back({fmt::format("a_call_of_{}_bytes_sent_by_{}", size, chunk),
                             whole(call("one", size)),
                             {"echo one"},
                             chunk});
    // An announcement alone is enough: the server does not wait for bytes that it could not take.
    for (const std::uint64_t size :
         {std::uint64_t{2} << 20, std::uint64_t{1} << 32, ~std::uint64_t{0}})
        cases.push_back({fmt::format("the_announcement_of_{}_bytes", size),
                         head(fin | text, size),
                         {"close 1009"}});
    std::string calls;
    Answers echoes;
    for (unsigned i = 0; i < 12; ++i) {
        calls += whole(call(fmt::format("id{}", i), 30u + 90u * i));
        echoes.push_back(fmt::format("echo id{}", i));
    }
    for (const std::size_t chunk : {0u, 1u, 7u, 125u, 1460u})
        cases.push_back({fmt::format("twelve_calls_sent_by_{}", chunk), calls, echoes, chunk});
    return cases;
}

std::string said(const WebSocketClient::Message& message) {
    if (message.opcode == closing)
        return fmt::format("close {}", message.close_code());
    const json answer = json::parse(message.payload);
    return answer.contains("error") ? "parse error" : "echo " + answer["id"].get<std::string>();
}

class WebSocketConformance : public ServerSuite, public testing::WithParamInterface<Case> {
  protected:
    static void SetUpTestSuite() { start({"flow:abc"}); }
};

} // namespace

TEST_P(WebSocketConformance, IsAnsweredAsTheStandardSays) {
    const Case& each = GetParam();
    WebSocketClient client(*server_, "");
    const std::size_t chunk = each.chunk == 0 ? each.bytes.size() : each.chunk;
    for (std::size_t at = 0; at < each.bytes.size(); at += chunk)
        client.socket().send(each.bytes.substr(at, chunk));
    std::optional<std::string> held; ///< received, not judged yet
    for (std::string wanted : each.answers) {
        const std::string answer =
            held ? *std::exchange(held, std::nullopt) : said(client.receive());
        if (const auto mark = wanted.find('?'); mark != std::string::npos) {
            wanted.erase(mark, 1);
            if (answer != wanted)
                held = answer;
            continue;
        }
        ASSERT_EQ(answer, wanted);
        if (answer.starts_with("close")) {
            client.socket().send(frame(fin | closing, close_payload(1000)));
            EXPECT_TRUE(client.socket().closes());
            return;
        }
    }
    client.socket().send(whole(call("marker")));
    EXPECT_EQ(said(client.receive()), "echo marker")
        << "the connection goes on, and nothing else was said";
}

INSTANTIATE_TEST_SUITE_P(Rfc6455,
                         WebSocketConformance,
                         testing::ValuesIn(all_cases()),
                         [](const auto& each) { return each.param.name; });

} // namespace wakesurf::tests::websocket_conformance_test
