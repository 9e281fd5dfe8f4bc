// What goes to a WebSocket in one write, beside frames put together by the letter of RFC 6455.
#include "server/net/websocket_connection.hpp"
#include "tests/server/live/sample_updates.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace wakesurf::server::message_batch_test {

namespace {

std::string sent(std::span<const boost::asio::const_buffer> buffers) {
    std::string out;
    for (const auto& each : buffers)
        out.append(static_cast<const char*>(each.data()), each.size());
    return out;
}

std::string as_text(const std::string& payload) {
    const std::size_t n = payload.size();
    std::string out{'\x81'};
    if (n < 126) {
        out += static_cast<char>(n);
    } else if (n < 65536) {
        out += {'\x7e', static_cast<char>(n >> 8), static_cast<char>(n)};
    } else {
        out += {'\x7f', 0, 0, 0, 0};
        for (const int shift : {24, 16, 8, 0})
            out += static_cast<char>(n >> shift);
    }
    return out + payload;
}

} // namespace

TEST(MessageBatch, PutsEachLengthBehindTheHeaderThatSaysIt) {
    for (const std::size_t length : {0u, 1u, 125u, 126u, 65535u, 65536u, 70000u}) {
        Outbox outbox;
        const std::string text(length, 'x');
        ASSERT_TRUE(outbox.push(text));
        MessageBatch batch;
        batch.fill(outbox);
        EXPECT_EQ(sent(batch.buffers()), as_text(text)) << length;
    }
}

TEST(MessageBatch, TakesAllThatOneEventGivesAViewerIntoOneWrite) {
    HandClock clock;
    const auto ring = std::make_shared<UpdateRing>(1, clock, [] {});
    ring->begin(1);
    Outbox outbox;
    outbox.follow(FrameCursor(ring, {}, [](bool) {}));
    ring->add(make_update({1, 7, true}));
    ASSERT_TRUE(outbox.push("progress"));
    ASSERT_TRUE(outbox.push("done"));
    MessageBatch batch;
    batch.fill(outbox);
    EXPECT_EQ(sent(batch.buffers()),
              as_text("progress") + as_text("done") + std::string("\x82\x03\x07\x00\x01", 5));
    EXPECT_FALSE(batch.full());
    EXPECT_FALSE(outbox.pop());
}

TEST(MessageBatch, LeavesWhatIsTooMuchForOneWriteForTheNext) {
    Outbox many, large;
    for (std::size_t i = 0; i <= MessageBatch::most_messages; ++i)
        ASSERT_TRUE(many.push("m"));
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(large.push(std::string(MessageBatch::enough_bytes / 2, 'l')));
    for (Outbox* outbox : {&many, &large}) {
        MessageBatch batch;
        batch.fill(*outbox);
        EXPECT_TRUE(batch.full());
        EXPECT_TRUE(outbox->pop());
        EXPECT_FALSE(outbox->pop());
    }
}

TEST(MessageBatch, GoesOnWhereTheSocketStopped) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        Outbox outbox;
        std::string whole;
        for (auto left = 1 + random() % 5; left > 0; --left) {
            const std::string text(random() % 300, static_cast<char>('a' + left));
            ASSERT_TRUE(outbox.push(text));
            whole += as_text(text);
        }
        MessageBatch batch;
        batch.fill(outbox);
        std::string taken;
        while (!batch.buffers().empty()) {
            const std::string rest = sent(batch.buffers());
            ASSERT_EQ(taken + rest, whole);
            const std::size_t some = std::min<std::size_t>(random() % 200, rest.size());
            taken += rest.substr(0, some);
            batch.consume(some);
        }
        EXPECT_EQ(taken, whole);
    }
}

} // namespace wakesurf::server::message_batch_test
