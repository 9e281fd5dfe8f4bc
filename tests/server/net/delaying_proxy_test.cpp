#include "tests/support/server/delaying_proxy.hpp"
#include "tests/support/server/server_process.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::delaying_proxy_test {

namespace {

using namespace std::chrono_literals;

const char* const health = "GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";

} // namespace

TEST(DelayingProxy, AddsItsDelayOnTheWayThereAndOnTheWayBack) {
    const ServerProcess server;
    const DelayingProxy proxy(server.port(), {.delay = 40ms});
    RawSocket socket(proxy.port());
    for (int i = 0; i < 2; ++i) {
        const auto start = std::chrono::steady_clock::now();
        socket.send(health);
        EXPECT_EQ(read_reply(socket).status, 200);
        EXPECT_GE(std::chrono::steady_clock::now() - start, 80ms);
    }
}

TEST(DelayingProxy, CutsWhatIsOpenAndTakesNewConnections) {
    const ServerProcess server;
    DelayingProxy proxy(server.port(), {});
    RawSocket before(proxy.port());
    before.send(health);
    EXPECT_EQ(read_reply(before).status, 200);
    proxy.cut();
    EXPECT_TRUE(before.closes());
    RawSocket after(proxy.port());
    after.send(health);
    EXPECT_EQ(read_reply(after).status, 200);
}

TEST(DelayingProxy, LetsNothingThroughWhileItIsStalledAndLosesNothing) {
    const ServerProcess server;
    DelayingProxy proxy(server.port(), {});
    RawSocket socket(proxy.port());
    socket.send(health);
    EXPECT_EQ(read_reply(socket).status, 200);
    proxy.stall(true);
    socket.send(health);
    EXPECT_FALSE(socket.closed_within(100ms));
    proxy.stall(false);
    EXPECT_EQ(read_reply(socket).status, 200);
}

} // namespace wakesurf::tests::delaying_proxy_test
