// How soon a light client is answered while holders of a viewer's link ask for what is dear to answer.
#include "tests/support/server/running_program.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::tests::floods_timing_test {

using nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

class Floods : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        RunningProgram generate("generate tornado " + store() + " --grid 4,4,4 --times 0:1:20000");
        while (!generate.line().empty()) {
        }
        server_ = new ServerProcess({store(), "--state", (*folder_ / "state").string()});
        WebSocketClient(*server_).result("dataset.open", {{"dataset", "many"}});
    }

    static void TearDownTestSuite() {
        delete server_;
        delete folder_;
    }

    static std::string store() { return (*folder_ / "many").string(); }

    /// Runs `ask` on that many threads, prints how long pings take meanwhile, and returns the 99th percentile.
    static Milliseconds ping_beside(const char* what,
                                    std::size_t threads,
                                    const std::function<void(const std::atomic<bool>&)>& ask) {
        WebSocketClient host(*server_);
        std::atomic<bool> over{false};
        std::vector<std::jthread> asking;
        for (std::size_t i = 0; i < threads; ++i)
            asking.emplace_back([&] { ask(over); });
        std::vector<Milliseconds> took;
        for (const auto end = Clock::now() + std::chrono::seconds(4); Clock::now() < end;) {
            const auto begun = Clock::now();
            host.result("server.ping");
            took.push_back(Clock::now() - begun);
        }
        over = true;
        asking.clear();
        std::ranges::sort(took);
        std::printf("%s: a ping takes %.1f ms at the median, %.1f ms at p99, %.1f ms at worst\n",
                    what, took[took.size() / 2].count(), took[took.size() * 99 / 100].count(),
                    took.back().count());
        return took[took.size() * 99 / 100];
    }

    static Headers viewer() {
        WebSocketClient host(*server_);
        const json link = host.result("session.share", {{"role", "viewer"}});
        return {{"Authorization", "Bearer " + link["key"].get<std::string>()}};
    }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline ServerProcess* server_ = nullptr;
};

constexpr Milliseconds soon{50};

} // namespace

TEST_F(Floods, OfLongAnswersLeaveALightClientsPingsQuick) {
    for (const char* method : {"dataset.describe", "cache.status", "dataset.list"}) {
        const Headers key = viewer();
        const json of =
            method == std::string("dataset.list") ? json::object() : json{{"dataset", "many"}};
        const json request{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", of}};
        EXPECT_LT(ping_beside(method, 30,
                              [&](const std::atomic<bool>& over) {
                                  WebSocketClient client(*server_, "", key);
                                  while (!over) {
                                      client.send(request);
                                      (void)client.receive(); // not parsed: that takes a processor
                                  }
                              }),
                  soon);
    }
}

TEST_F(Floods, OfLoginsAndLogoutsLeaveALightClientsPingsQuick) {
    const Headers key = viewer();
    const std::string token = key.front().second.substr(7);
    EXPECT_LT(ping_beside("login and logout", 30,
                          [&](const std::atomic<bool>& over) {
                              while (!over) {
                                  const auto in = http(server_->port(), "POST", "/api/v1/login", {},
                                                       json{{"token", token}}.dump());
                                  const json answer = json::parse(in.body, nullptr, false);
                                  if (answer.is_object() && answer.contains("login"))
                                      http(server_->port(), "POST", "/api/v1/logout",
                                           {{"Authorization",
                                             "Bearer " + answer["login"].get<std::string>()}},
                                           "");
                              }
                          }),
              soon);
}

} // namespace wakesurf::tests::floods_timing_test
