// HTTP as no one should send it: smuggled bodies, endless headers, methods that are none. Each gets a short answer at once, and never two
// where a proxy saw one request. What Beast's parser takes for HTTP is Beast's to test.
#include "tests/support/server/processor_time.hpp"
#include "tests/support/server/server_suite.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

namespace wakesurf::tests::http_bombs_test {

namespace {

/// Of the server's processors, for any of these: the same whatever else the machine does.
constexpr std::chrono::milliseconds patience{100};

std::string repeat(const std::string& part, std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i)
        out += part;
    return out;
}

class HttpBombs : public ServerSuite {
  protected:
    static void SetUpTestSuite() {
        folder_.emplace();
        std::ofstream(folder_->path() / "index.html") << "page";
        start({"flow:abc", "--web", folder_->path().string()});
    }

    static void ping() { EXPECT_EQ(http(server_->port(), "GET", "/healthz").body, "ok"); }

    /// All the statuses `bytes` are answered with until the server ends the connection; -1 where it waits for more.
    static std::vector<int> statuses(const std::string& bytes) {
        RawSocket socket(server_->port());
        socket.send(bytes);
        std::vector<int> out;
        for (;;) {
            if (!socket.readable_within(std::chrono::seconds(30))) {
                out.push_back(-1);
                return out;
            }
            const HttpReply reply = read_reply(socket);
            if (reply.status == 0)
                return out;
            out.push_back(reply.status);
            if (reply.header("connection") == "close")
                return out;
        }
    }
};

} // namespace

TEST_F(HttpBombs, EndInAShortAnswerAtOnce) {
    const std::string host = "Host: 127.0.0.1\r\n";
    const std::string with = host + "Authorization: Bearer " + server_->token() + "\r\n";
    const std::string ping = R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})";
    const std::string size = std::to_string(ping.size());
    const auto post = [&](const std::string& headers, const std::string& body) {
        return "POST /rpc HTTP/1.1\r\n" + with + headers + "\r\n" + body;
    };
    const std::string last = "Connection: close\r\n"; // of requests that are answered

    struct Case {
        std::string what;
        std::string bytes;
        std::vector<int> statuses;
    };

    const std::vector<Case> cases{
        {"a length that is a list", post("Content-Length: 5, 6\r\n", ping), {400}},
        {"a length that is a list of one",
         post("Content-Length: " + size + ", " + size + "\r\n", ping),
         {400}},
        {"two lengths", post("Content-Length: 5\r\nContent-Length: 6\r\n", ping), {400}},
        {"the same length twice",
         post("Content-Length: " + size + "\r\nContent-Length: " + size + "\r\n", ping),
         {400}},
        {"a length of 10^18", post("Content-Length: 1000000000000000000\r\n", ping), {413}},
        {"a length and chunks",
         post("Content-Length: 3\r\nTransfer-Encoding: chunked\r\n", "0\r\n\r\nGET / HTTP/1.1\r\n"),
         {400}},
        {"chunks and a length",
         post("Transfer-Encoding: chunked\r\nContent-Length: 3\r\n", "0\r\n\r\nGET / HTTP/1.1\r\n"),
         {400}},
        {"two codings", post("Transfer-Encoding: gzip, chunked\r\n", "0\r\n\r\n"), {400}},
        {"a coding twice",
         post("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n", "0\r\n\r\n"),
         {400}},
        {"a coding no one knows", post("Transfer-Encoding: xchunked\r\n", "0\r\n\r\n"), {400}},
        {"chunks",
         post("Transfer-Encoding: chunked\r\n" + last, "4\r\n{   \r\n3\r\nabc\r\n0\r\n\r\n"),
         {200}},
        {"chunks beyond the limit",
         post("Transfer-Encoding: chunked\r\n",
              repeat("400\r\n" + std::string(1024, ' ') + "\r\n", 65)),
         {413}},
        {"a header of 20,000 bytes",
         "GET /healthz HTTP/1.1\r\n" + host + "X: " + std::string(20000, 'x') + "\r\n\r\n",
         {431}},
        {"lines without returns", "GET /healthz HTTP/1.1\nHost: 127.0.0.1\n\n", {400}},
        {"HTTP/1.0 without a host", "GET / HTTP/1.0\r\n\r\n", {403}},
        {"HTTP/1.1 without a host", "GET / HTTP/1.1\r\n" + last + "\r\n", {403}},
        {"two hosts", "GET / HTTP/1.1\r\n" + host + host + last + "\r\n", {403}},
        {"another server's address",
         "GET http://evil.example/ HTTP/1.1\r\n" + with + last + "\r\n",
         {404}},
        {"a tunnel", "CONNECT evil.example:80 HTTP/1.1\r\n" + with + last + "\r\n", {405}},
        {"a post to nothing",
         "POST /nothing HTTP/1.1\r\n" + with + last + "Content-Length: 0\r\n\r\n",
         {404}},
        {"a post to a file",
         "POST /openrpc.json HTTP/1.1\r\n" + with + last + "Content-Length: 0\r\n\r\n",
         {405}},
        {"a method no one knows", "BREW /healthz HTTP/1.1\r\n" + host + last + "\r\n", {405}},
        {"a path of slashes",
         "GET " + std::string(4000, '/') + " HTTP/1.1\r\n" + with + last + "\r\n",
         {404}},
        {"a mesh of a path",
         "GET /api/v1/sessions/../surfaces/../mesh.vtp HTTP/1.1\r\n" + with + last + "\r\n",
         {404}},
        {"1,000 requests at once",
         repeat("GET /healthz HTTP/1.1\r\n" + host + "\r\n", 999) + "GET /healthz HTTP/1.1\r\n" +
             host + last + "\r\n",
         std::vector<int>(1000, 200)},
    };
    for (const auto& [what, bytes, expected] : cases) {
        const auto before = processor_time_of(server_->pid());
        const auto got = statuses(bytes);
        const auto took = processor_time_of(server_->pid()) - before;
        EXPECT_EQ(got, expected) << what;
        EXPECT_LT(took, patience) << what << " takes the server's processors";
    }
    EXPECT_TRUE(server_->running());
}

TEST_F(HttpBombs, ThatStopHalfWayHoldNothingUp) {
    std::vector<RawSocket> half;
    for (int i = 0; i < 200; ++i) {
        half.emplace_back(server_->port());
        half.back().send("POST /rpc HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 60000\r\n\r\n{");
    }
    ping();
    EXPECT_FALSE(half.front().readable_within(std::chrono::milliseconds(0)))
        << "the others are served before the time of these is over";
    for (int i = 0; i < 100; ++i)
        half[static_cast<std::size_t>(i)].reset();
    half.clear();
    ping();
}

TEST_F(HttpBombs, SayTheSameToBrowsersWhateverTheAnswer) {
    const auto bearer = server_->bearer();
    Headers websocket = bearer;
    for (const auto& [name, value] : Headers{{"Upgrade", "websocket"},
                                             {"Connection", "Upgrade"},
                                             {"Sec-WebSocket-Version", "13"},
                                             {"Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="}})
        websocket.emplace_back(name, value);

    struct Case {
        const char* method;
        const char* target;
        Headers headers;
        std::string body;
        int status;
    };

    const std::vector<Case> cases{
        {"GET", "/", {}, {}, 200},
        {"HEAD", "/", {}, {}, 200},
        {"GET", "/healthz", {}, {}, 200},
        {"GET", "/openrpc.json", bearer, {}, 200},
        {"GET", "/metrics", bearer, {}, 200},
        {"POST", "/rpc", bearer, R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})", 200},
        {"POST", "/rpc", bearer, R"({"jsonrpc":"2.0","method":"server.ping"})", 204},
        {"GET", "/ws", websocket, {}, 101},
        {"POST", "/api/v1/login", {}, "{", 400},
        {"GET", "/metrics", {}, {}, 401},
        {"GET", "/", {{"Host", "evil.example"}}, {}, 403},
        {"GET", "/nothing", bearer, {}, 404},
        {"DELETE", "/", bearer, {}, 405},
        {"POST", "/rpc", bearer, std::string(70000, ' '), 413},
        {"GET", "/ws", bearer, {}, 426},
        {"GET", "/", {{"X", std::string(9000, 'x')}}, {}, 431},
    };
    for (const auto& [method, target, headers, body, status] : cases) {
        const HttpReply reply = http(server_->port(), method, target, headers, body);
        const std::string what = std::string(method) + " " + target + " " + std::to_string(status);
        EXPECT_EQ(reply.status, status) << what;
        EXPECT_EQ(reply.header("x-content-type-options"), "nosniff") << what;
        EXPECT_EQ(reply.header("x-frame-options"), "DENY") << what;
        EXPECT_EQ(reply.header("referrer-policy"), "no-referrer") << what;
        EXPECT_EQ(reply.header("cross-origin-resource-policy"), "same-origin") << what;
        EXPECT_EQ(reply.header("cross-origin-opener-policy"), "same-origin") << what;
        EXPECT_TRUE(holds(reply.header("permissions-policy"), "camera=()")) << what;
        EXPECT_TRUE(holds(reply.header("content-security-policy"), "default-src 'self'")) << what;
        EXPECT_EQ(reply.header("strict-transport-security"), "") << what;
        EXPECT_EQ(reply.header("server"), "wakesurf") << what << ": no version";
        if (status != 101) {
            EXPECT_NE(reply.header("cache-control"), "") << what;
        }
        if (status >= 400) {
            EXPECT_TRUE(nlohmann::json::parse(reply.body)["error"]["data"]["hint"].is_string())
                << what;
        }
    }
}

} // namespace wakesurf::tests::http_bombs_test
