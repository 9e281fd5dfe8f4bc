// What a connection gives beyond its socket: bytes that were read too early, whole writes beside the control
// frames between them, and whether anyone is still there.
#include "server/net/byte_stream.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace wakesurf::server::byte_stream_test {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

class ByteStreamTest : public testing::Test {
  protected:
    ByteStreamTest() {
        tcp::acceptor acceptor(context, {asio::ip::make_address("127.0.0.1"), 0});
        other.connect(acceptor.local_endpoint());
        stream = std::make_shared<ByteStream>(acceptor.accept(), nullptr);
    }

    /// What one read of at most four bytes gives.
    std::string read() {
        std::array<char, 4> buffer{};
        std::string got;
        bool done = false;
        stream->async_read_some(asio::buffer(buffer), [&](error_code, std::size_t bytes) {
            got.assign(buffer.data(), bytes);
            done = true;
        });
        EXPECT_FALSE(done) << "handlers are called later";
        context.restart();
        while (!done)
            context.run_one();
        return got;
    }

    void write_whole(const std::string& bytes) {
        const asio::const_buffer all = asio::buffer(bytes);
        stream->async_write_whole({asio::buffer(all, 3), all + 3},
                                  [this](error_code, std::size_t) { order.emplace_back("whole"); });
    }

    void write_small(const std::string& bytes) {
        stream->async_write_some(asio::buffer(bytes),
                                 [this](error_code, std::size_t) { order.emplace_back("small"); });
    }

    asio::io_context context;
    tcp::socket other{context};
    std::shared_ptr<ByteStream> stream;
    std::vector<std::string> order;
};

const std::string large(std::size_t{16} << 20, 'l'); ///< more than a socket takes
const std::string small = "ping";

} // namespace

TEST_F(ByteStreamTest, PutsNothingBetweenThePartsOfAWholeWrite) {
    write_whole(large);
    write_small(small);
    std::string got(large.size() + small.size(), '\0');
    bool there = false;
    asio::async_read(other, asio::buffer(got), [&](error_code, std::size_t) { there = true; });
    while (!there)
        context.run_one();
    EXPECT_TRUE(got == large + small);
    context.poll();
    EXPECT_EQ(order, (std::vector<std::string>{"whole", "small"}));
}

TEST_F(ByteStreamTest, EndsWhatWaitsForAWriteWhenItIsClosed) {
    write_whole(large);
    write_small(small);
    stream->close();
    context.run();
    EXPECT_EQ(order, (std::vector<std::string>{"whole", "small"}));
}

TEST_F(ByteStreamTest, ReadsFirstWhatWasPutBack) {
    asio::write(other, asio::buffer(std::string("next")));
    stream->put_back("before");
    EXPECT_EQ(read(), "befo");
    EXPECT_EQ(read(), "re");
    EXPECT_EQ(read(), "next");
}

TEST_F(ByteStreamTest, TakesTheProxyProtocolAndLeavesWhatComesWithIt) {
    asio::write(other, asio::buffer(std::string("PROXY TCP4 192.0.2.7 10.0.0.1 4711 443\r\nGET ")));
    std::string from;
    stream->async_proxy_header([&](error_code error, const ProxyHeader& header) {
        EXPECT_FALSE(error);
        from = header.from ? header.from->to_string() : "nobody";
    });
    while (from.empty())
        context.run_one();
    EXPECT_EQ(from, "192.0.2.7");
    EXPECT_EQ(read(), "GET ");
}

TEST_F(ByteStreamTest, KnowsThatTheOtherSideHasHungUpAlsoBehindWhatNobodyHasRead) {
    EXPECT_FALSE(stream->peer_gone());
    asio::write(other, asio::buffer(std::string("more")));
    EXPECT_FALSE(stream->peer_gone());
    other.close();
    EXPECT_TRUE(stream->peer_gone());
}

} // namespace wakesurf::server::byte_stream_test
