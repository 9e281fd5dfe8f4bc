#include "server/net/io_loop.hpp"

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server::io_loop_test {

TEST(IoLoop, RunsWhatIsPostedInTheOrderOfPosting) {
    boost::asio::io_context context;
    IoLoop loop(context);
    std::string order;
    for (const char c : {'a', 'b', 'c'})
        loop.post([&order, c] { order += c; });
    loop.post([&] { loop.post([&] { context.stop(); }); });
    loop.post([&order] { order += 'd'; });
    context.run();
    EXPECT_EQ(order, "abcd");
}

TEST(IoLoop, LosesNothingThatManyThreadsPost) {
    constexpr int threads = 4, each = 2'000;
    boost::asio::io_context context;
    IoLoop loop(context);
    int ran = 0;
    std::vector<std::jthread> posters;
    for (int t = 0; t < threads; ++t)
        posters.emplace_back([&] {
            for (int i = 0; i < each; ++i)
                loop.post([&] {
                    if (++ran == threads * each)
                        context.stop();
                });
        });
    context.run();
    EXPECT_EQ(ran, threads * each);
}

TEST(IoLoop, LetsGoOfWhatNeverRan) {
    const auto held = std::make_shared<int>(1);
    {
        boost::asio::io_context context;
        IoLoop loop(context);
        loop.post([held] {});
        EXPECT_EQ(held.use_count(), 2);
    }
    EXPECT_EQ(held.use_count(), 1);
}

TEST(IoLoop, RunsNoTaskWhoseTicketIsDropped) {
    boost::asio::io_context context;
    IoLoop loop(context);
    bool ran = false;
    auto dropped = loop.after(std::chrono::milliseconds(1), [&] { ran = true; });
    dropped.reset();
    const auto last = loop.after(std::chrono::milliseconds(20), [&] { context.stop(); });
    context.run();
    EXPECT_FALSE(ran);
}

} // namespace wakesurf::server::io_loop_test
