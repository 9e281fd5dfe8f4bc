// Many clients at once, and what happens to the rest when the process has no descriptor left for another one.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::tests::many_clients_test {

using nlohmann::json;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t per_client = 200; ///< KiB; the sanitizer's own
#else
constexpr std::size_t per_client = 20; ///< KiB
#endif

/// KiB
std::size_t resident(const ServerProcess& server) {
    std::ifstream status("/proc/" + std::to_string(server.pid()) + "/status");
    for (std::string word; status >> word;)
        if (std::size_t kibibytes = 0; word == "VmRSS:" && status >> kibibytes)
            return kibibytes;
    return 0;
}

std::string metric(const ServerProcess& server, const std::string& name) {
    const std::string text = "\n" + http(server.port(), "GET", "/metrics", server.bearer()).body;
    const auto at = text.find("\n" + name + " ");
    if (at == std::string::npos)
        return {};
    const auto begin = at + name.size() + 2;
    return text.substr(begin, text.find('\n', begin) - begin);
}

std::size_t descriptors(const ServerProcess& server) {
    const std::filesystem::directory_iterator all("/proc/" + std::to_string(server.pid()) + "/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

} // namespace

TEST(ManyClientsTest, AThousandIdleOnesTakeTwentyMegabytesAtMost) {
    const ServerProcess server({"flow:abc"});
    std::vector<std::unique_ptr<WebSocketClient>> clients;
    for (int i = 0; i < 20; ++i)
        clients.push_back(std::make_unique<WebSocketClient>(server, ""));
    const std::size_t before = resident(server);
    for (int i = 0; i < 1000; ++i) {
        clients.push_back(std::make_unique<WebSocketClient>(server, ""));
        clients.back()->result("server.ping");
    }
    const std::size_t each = (resident(server) - before) / 1000;
    RecordProperty("KiB", static_cast<int>(each));
    EXPECT_LE(each, per_client) << "KiB a client";
    EXPECT_EQ(metric(server, "wakesurf_clients"), "1020");
    clients.clear();
    const WebSocketClient after(server);
    for (int tries = 0; tries < 200 && metric(server, "wakesurf_clients") != "1"; ++tries)
        http(server.port(), "GET", "/healthz");
    EXPECT_EQ(metric(server, "wakesurf_clients"), "1");
}

TEST(ManyClientsTest, WithoutDescriptorsWaitForOneWhileTheOthersAreServed) {
    ServerProcess server({"flow:abc"});
    WebSocketClient served(server);
    constexpr std::size_t limit = 40;
    const rlimit few{limit, limit};
    ASSERT_EQ(::prlimit(server.pid(), RLIMIT_NOFILE, &few, nullptr), 0);
    std::vector<RawSocket> silent;
    for (int i = 0; i < 100; ++i)
        silent.emplace_back(server.port());
    for (int tries = 0; tries < 10'000 && descriptors(server) < limit; ++tries)
        served.result("server.ping"); // it takes some of them in between
    ASSERT_GE(descriptors(server), limit);
    EXPECT_EQ(served.result("server.ping"), json::object());
    const json rake = served.result(
        "rake.set", {{"kind", "line"}, {"points", {{0, 0, 0}, {1, 0, 0}}}, {"seeds", 8}});
    EXPECT_TRUE(rake.contains("rake"));
    silent.clear();
    EXPECT_EQ(http(server.port(), "GET", "/healthz").body, "ok");
    EXPECT_EQ(served.result("server.ping"), json::object());
    const auto end = server.stop();
    EXPECT_EQ(end.status, 0);
    EXPECT_NE(end.log.find("event=accept_paused"), std::string::npos) << end.log;
}

TEST(ManyClientsTest, BeyondTheDescriptorsThatAreKeptForFilesAreSentAway) {
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const rlimit soft{64, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &soft), 0);
    const ServerProcess server({"flow:abc"}); // raises its own
    ::setrlimit(RLIMIT_NOFILE, &before);
    std::vector<std::unique_ptr<WebSocketClient>> clients;
    for (int i = 0; i < 100; ++i)
        clients.push_back(std::make_unique<WebSocketClient>(server, ""));
    EXPECT_EQ(clients.back()->result("server.ping"), json::object());
}

TEST(ManyClientsTest, OfThisMachineThatShowNothingDoNotKeepOthersOut) {
    const ServerProcess server({"flow:abc"});
    WebSocketClient served(server);
    std::vector<RawSocket> silent;
    for (int i = 0; i < 2100; ++i)
        silent.emplace_back(server.port());
    EXPECT_TRUE(silent.front().closes()) << "it makes room";
    EXPECT_EQ(served.result("server.ping"), json::object());
    EXPECT_EQ(http(server.port(), "GET", "/healthz").body, "ok");
    EXPECT_EQ(WebSocketClient(server).result("server.ping"), json::object());
    EXPECT_NE(metric(server, R"(wakesurf_rejected_total{reason="too_many_pending"})"), "0");
}

TEST(ManyClientsTest, ByOneLinkLeaveRoomForAHostWhoTakesItBack) {
    const ServerProcess server({"flow:abc"});
    WebSocketClient first(server);
    const json link = first.result("session.share", {{"role", "viewer"}});
    const Headers bearer{{"Authorization", "Bearer " + link["key"].get<std::string>()}};
    std::vector<RawSocket> sockets;
    int let_in = 0;
    HttpReply refused;
    for (int i = 0; i < 600; ++i) {
        sockets.emplace_back(server.port());
        const HttpReply reply = handshake(sockets.back(), server.port(), bearer);
        let_in += reply.status == 101 ? 1 : 0;
        if (reply.status != 101)
            refused = reply;
    }
    EXPECT_EQ(let_in, 64) << "all from one address";
    EXPECT_EQ(refused.status, 503);
    EXPECT_NE(refused.header("retry-after"), "");
    EXPECT_EQ(json::parse(refused.body)["error"]["code"], -32014);
    WebSocketClient host(server);
    host.result("session.unshare", {{"grant", link["grant"]}});
    EXPECT_NE(sockets.front().receive().find("linkEnded"), std::string::npos);
    EXPECT_NE(metric(server, R"(wakesurf_rejected_total{reason="too_many_clients"})"), "0");
}

TEST(ManyClientsTest, BehindATrustedProxyAreCountedByTheAddressItForwards) {
    const ServerProcess server({"flow:abc", "--trusted-proxy", "127.0.0.1"});
    WebSocketClient first(server);
    const json link = first.result("session.share", {{"role", "viewer"}});
    const auto from = [&](const std::string& address) {
        return Headers{{"Authorization", "Bearer " + link["key"].get<std::string>()},
                       {"X-Forwarded-For", address}};
    };
    std::vector<RawSocket> sockets;
    const auto upgrade = [&](const std::string& address, const std::string& before = {}) {
        sockets.emplace_back(server.port());
        sockets.back().send(before);
        return handshake(sockets.back(), server.port(), from(address)).status;
    };
    for (int i = 0; i < 64; ++i)
        EXPECT_EQ(upgrade("198.51.100.1"), 101) << i;
    EXPECT_EQ(upgrade("198.51.100.1"), 503);
    EXPECT_EQ(upgrade("203.0.113.9, 198.51.100.1"), 503) << "what a client says of itself";
    EXPECT_EQ(upgrade("198.51.100.2"), 101);
    EXPECT_EQ(upgrade("198.51.100.2", "PROXY TCP4 198.51.100.1 10.0.0.1 4711 443\r\n"), 503)
        << "the connection is another's, which is no proxy";
    EXPECT_EQ(upgrade("198.51.100.1", "PROXY TCP4 198.51.100.3 10.0.0.1 4711 443\r\n"), 101);
    RawSocket nonsense(server.port());
    nonsense.send("PROXY TCP4 no one\r\n");
    EXPECT_TRUE(nonsense.closes());
    EXPECT_EQ(http(server.port(), "GET", "/healthz").body, "ok") << "without a word of a proxy";
}

} // namespace wakesurf::tests::many_clients_test
