// Accepting when the process has no descriptor left: waits, and goes on once there is one.
#include "server/net/listener.hpp"
#include "tests/support/server/raw_socket.hpp"

#include <boost/asio/io_context.hpp>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <vector>

namespace wakesurf::tests::listener_test {

using namespace server;

TEST(ListenerTest, WithoutDescriptorsWaitsAndThenGoesOn) {
    boost::asio::io_context context;
    int accepted = 0;
    const auto listener = Listener::open(context, "127.0.0.1", 0,
                                         [&](const boost::asio::ip::tcp::socket&) { ++accepted; });
    ASSERT_TRUE(listener);
    (*listener)->start();
    const RawSocket client((*listener)->port());
    // The undefined-behaviour sanitizer opens a pipe to look at an object of a type that it meets for
    // the first time, and reports a fault when it cannot. The listener logs while there is no descriptor
    // left, so all types of a warning are met here.
    spdlog::warn("event=descriptors_taken but={}", 0);
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const int next = ::dup(0); // the lowest that is free
    ::close(next);
    rlimit none = before;
    none.rlim_cur = static_cast<rlim_t>(next);
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    context.run_for(std::chrono::milliseconds(50));
    EXPECT_EQ(accepted, 0);
    ::setrlimit(RLIMIT_NOFILE, &before);
    while (accepted == 0) // with its next try
        context.run_one();
    (*listener)->stop();
    context.run_for(std::chrono::milliseconds(10));
}

} // namespace wakesurf::tests::listener_test
