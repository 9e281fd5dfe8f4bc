// Two writers on one connection: messages, and the control frames between them.
#include "server/net/byte_stream.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

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
        stream = std::make_unique<ByteStream>(acceptor.accept(), nullptr);
    }

    void write_whole(const std::string& bytes) {
        const asio::const_buffer all = asio::buffer(bytes);
        buffers.assign({asio::buffer(all, 3), all + 3});
        stream->async_write_whole(buffers,
                                  [this](error_code, std::size_t) { order.emplace_back("whole"); });
    }

    void write_small(const std::string& bytes) {
        stream->async_write_some(asio::buffer(bytes),
                                 [this](error_code, std::size_t) { order.emplace_back("small"); });
    }

    /// All the other side gets, until so many bytes.
    std::string read(std::size_t bytes) {
        std::string got(bytes, '\0');
        bool there = false;
        asio::async_read(other, asio::buffer(got), [&](error_code, std::size_t) { there = true; });
        while (!there)
            context.run_one();
        return got;
    }

    asio::io_context context;
    tcp::socket other{context};
    std::unique_ptr<ByteStream> stream;
    std::vector<asio::const_buffer> buffers;
    std::vector<std::string> order;
};

const std::string large(std::size_t{16} << 20, 'l'); ///< more than a socket takes

} // namespace

TEST_F(ByteStreamTest, PutsNothingBetweenThePartsOfAWholeWrite) {
    const std::string small = "ping";
    write_whole(large);
    write_small(small);
    EXPECT_EQ(stream->write_at_once(buffers), 0U) << "not while another write is under way";
    EXPECT_TRUE(read(large.size() + small.size()) == large + small);
    context.poll();
    EXPECT_EQ(order, (std::vector<std::string>{"whole", "small"}));
}

TEST_F(ByteStreamTest, TakesNoMoreAtOnceThanTheSocketAndGoesOnFromThere) {
    const std::vector<asio::const_buffer> all{asio::buffer(large)};
    const std::size_t sent = stream->write_at_once(all);
    EXPECT_GT(sent, 0U);
    EXPECT_LT(sent, large.size());
    const std::string rest(large.size() - sent, 'r');
    write_whole(rest);
    EXPECT_TRUE(read(large.size()) == large.substr(0, sent) + rest);
}

TEST_F(ByteStreamTest, KnowsThatTheOtherSideHasHungUpAlsoBehindWhatNobodyHasRead) {
    EXPECT_FALSE(stream->peer_gone());
    asio::write(other, asio::buffer(std::string("more")));
    EXPECT_FALSE(stream->peer_gone());
    other.close();
    EXPECT_TRUE(stream->peer_gone());
}

TEST_F(ByteStreamTest, EndsWhatWaitsForAWriteWhenItIsClosed) {
    const std::string small = "ping";
    write_whole(large);
    write_small(small);
    stream->close();
    stream.reset();
    context.run();
    EXPECT_EQ(order, (std::vector<std::string>{"whole", "small"}));
}

} // namespace wakesurf::server::byte_stream_test
