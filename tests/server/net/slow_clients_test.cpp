// Clients that take their time, in every phase a connection has: each is ended when the time of that
// phase is over, and not before. They all wait at the same time, so that the test takes no longer than
// the longest. What is too late is told by the server's own pings to one that is served, every 20 s: a
// busy machine holds these up as well.
#include "server/base/limits.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <future>
#include <string>
#include <vector>

namespace wakesurf::tests::slow_clients_test {

using nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How long the connection stays while `drip` is sent again and again.
double lasts(RawSocket& socket, const std::string& drip) {
    const auto start = Clock::now();
    while (seconds_since(start) < 120.0) {
        if (socket.closed_within(std::chrono::milliseconds(200)))
            break;
        socket.send(drip);
    }
    return seconds_since(start);
}

/// Of /metrics; asking every quarter of a second is often enough.
int rejected(const ServerProcess& server, const std::string& reason) {
    RawSocket pause(server.port());
    (void)pause.closed_within(std::chrono::milliseconds(250));
    const std::string text = http(server.port(), "GET", "/metrics", server.bearer()).body;
    const std::string name = "wakesurf_rejected_total{reason=\"" + reason + "\"} ";
    const auto at = text.find(name);
    return at == std::string::npos ? 0 : std::stoi(text.substr(at + name.size()));
}

} // namespace

TEST(SlowClientsTest, AreEndedWhenTheTimeOfTheirPhaseIsOver) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "large.bin") << std::string(std::size_t{2} << 20, 'x');
    const ServerProcess server({"flow:lamb-oseen", "--web", folder.path().string()});
    const std::string host = "Host: 127.0.0.1\r\n";
    const std::string posting =
        "POST /rpc HTTP/1.1\r\n" + host + "Authorization: Bearer " + server.token() + "\r\n";

    struct Case {
        const char* what;
        std::string first;
        std::string drip;
        double least;     ///< seconds
        std::size_t ping; ///< before which it is ended
    };

    const std::vector<Case> cases{
        {"says nothing", "", "", 9, 1},
        {"drips its header", "GET /healthz HTTP/1.1\r\nX: ", "x", 9, 1},
        {"drips its body", posting + "Content-Length: 60000\r\n\r\n{", " ", 9, 1},
        {"drips its chunks", posting + "Transfer-Encoding: chunked\r\n\r\n", "1\r\n \r\n", 9, 1},
        {"is kept alive and asks for nothing more", "GET /healthz HTTP/1.1\r\n" + host + "\r\n", "",
         39, 3},
    };
    std::atomic<std::size_t> pings{0};
    auto attentive = std::async(std::launch::async, [&] {
        WebSocketClient client(server, "");
        std::vector<double> at;
        const auto start = Clock::now();
        while (pings < 3) {
            EXPECT_EQ(client.socket().receive(std::chrono::minutes(1)), std::string("\x89\0", 2));
            at.push_back(seconds_since(start));
            ++pings;
            client.send_frame(10, "");
        }
        EXPECT_EQ(client.result("server.ping"), json::object());
        return at;
    });

    struct End {
        double after = 0.0;    ///< seconds
        std::size_t pings = 0; ///< of the attentive one by then
    };

    const auto end_of = [&](RawSocket& socket, const std::string& drip) {
        const double after = lasts(socket, drip);
        return End{after, pings};
    };
    std::vector<std::future<End>> waiting;
    for (const Case& each : cases)
        waiting.push_back(std::async(std::launch::async, [&] {
            RawSocket socket(server.port());
            socket.send(each.first);
            return end_of(socket, each.drip);
        }));

    auto deaf = std::async(std::launch::async, [&] {
        WebSocketClient client(server, ""); // answers no ping
        return end_of(client.socket(), "");
    });

    // Three that ask for more than the kernel keeps for them, and read none of it; the last one for more than the server keeps, too.
    RawSocket download(server.port());
    for (int i = 0; i < 20; ++i)
        download.send("GET /large.bin HTTP/1.1\r\n" + host + "\r\n");
    const auto ask = [](WebSocketClient& client, std::size_t times) {
        for (std::size_t i = 0; i < times; ++i)
            client.send({{"jsonrpc", "2.0"}, {"id", i}, {"method", "rpc.discover"}});
    };
    WebSocketClient questions(server, "");
    ask(questions, server::limits::outbox_message_bytes * 3 / 2 /
                       questions.result("rpc.discover").dump().size());
    WebSocketClient more_questions(server, "");
    ask(more_questions, 1000);
    const auto stalling = Clock::now();
    while (pings < 3 && (rejected(server, "stalled") < 2 || rejected(server, "overflow") < 1))
        continue;
    EXPECT_GT(seconds_since(stalling), 25.0);
    EXPECT_LT(pings, 3u) << "stalled";

    for (std::size_t i = 0; i < cases.size(); ++i) {
        const End end = waiting[i].get();
        EXPECT_GT(end.after, cases[i].least) << cases[i].what;
        EXPECT_LT(end.pings, cases[i].ping) << cases[i].what;
    }
    const End heard = deaf.get();
    EXPECT_GT(heard.after, 38.0);
    EXPECT_LT(heard.pings, 3u);
    const std::vector<double> pinged = attentive.get();
    for (std::size_t i = 0; i < pinged.size(); ++i)
        EXPECT_GT(pinged[i], 18.0 * static_cast<double>(i + 1));
}

} // namespace wakesurf::tests::slow_clients_test
