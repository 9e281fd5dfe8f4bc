// Clients that take their time, in every phase a connection has: each is ended when the time of that phase is over, and
// not before. They all wait at the same time, so that the test takes no longer than the longest.
#include "server/limits.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

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
    while (seconds_since(start) < 60.0) {
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
        double least, most; ///< seconds
    };

    const std::vector<Case> cases{
        {"says nothing", "", "", 9, 14},
        {"drips its header", "GET /healthz HTTP/1.1\r\nX: ", "x", 9, 14},
        {"drips its body", posting + "Content-Length: 60000\r\n\r\n{", " ", 9, 14},
        {"drips its chunks", posting + "Transfer-Encoding: chunked\r\n\r\n", "1\r\n \r\n", 9, 14},
        {"is kept alive and asks for nothing more", "GET /healthz HTTP/1.1\r\n" + host + "\r\n", "",
         39, 46},
    };
    std::vector<std::future<double>> waiting;
    for (const Case& each : cases)
        waiting.push_back(std::async(std::launch::async, [&] {
            RawSocket socket(server.port());
            socket.send(each.first);
            return lasts(socket, each.drip);
        }));

    auto deaf = std::async(std::launch::async, [&] {
        WebSocketClient client(server, ""); // answers no ping
        return lasts(client.socket(), "");
    });
    auto attentive = std::async(std::launch::async, [&] {
        WebSocketClient client(server, "");
        const auto start = Clock::now();
        EXPECT_EQ(client.socket().receive(std::chrono::seconds(30)), std::string("\x89\0", 2));
        const double pinged = seconds_since(start);
        client.send_frame(10, "");
        EXPECT_EQ(client.result("server.ping"), json::object());
        return pinged;
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
    while (seconds_since(stalling) < 60.0 &&
           (rejected(server, "stalled") < 2 || rejected(server, "overflow") < 1))
        continue;
    EXPECT_GT(seconds_since(stalling), 25.0);
    EXPECT_LT(seconds_since(stalling), 45.0);

    const double pinged = attentive.get();
    EXPECT_GT(pinged, 18.0);
    EXPECT_LT(pinged, 25.0);
    const double heard = deaf.get();
    EXPECT_GT(heard, 38.0);
    EXPECT_LT(heard, 46.0);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double took = waiting[i].get();
        EXPECT_GT(took, cases[i].least) << cases[i].what;
        EXPECT_LT(took, cases[i].most) << cases[i].what;
    }
}

} // namespace wakesurf::tests::slow_clients_test
