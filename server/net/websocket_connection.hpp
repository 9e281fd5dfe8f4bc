// One WebSocket: text is JSON-RPC, binary is frames and goes one way only. It writes from the outbox, one
// batch at a time, so that a slow client delays no other.
#pragma once

#include "server/net/byte_stream.hpp"
#include "server/net/http_message.hpp"
#include "server/net/net_services.hpp"
#include "server/net/outbox.hpp"

#include <boost/asio/buffer.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace wakesurf::server {

/// A single write to one WebSocket: messages and frames behind their headers (RFC 6455 5.2), as one list of
/// buffers. A frame and the messages about it reach a viewer in one system call.
/// Owns what it sends. Neither copied nor moved: its buffers point into it.
class MessageBatch {
  public:
    static constexpr std::size_t most_messages = 16;
    static constexpr std::size_t enough_bytes = std::size_t{64} << 10;

    MessageBatch() = default;
    MessageBatch(const MessageBatch&) = delete;
    MessageBatch& operator=(const MessageBatch&) = delete;

    /// Takes messages and frames out of the outbox in their order, until it is empty or the batch is full.
    void fill(Outbox& outbox);

    std::span<const Outbox::Item> items() const { return {items_.data(), count_}; }

    bool empty() const { return count_ == 0; }

    /// Says that the outbox may hold more.
    bool full() const { return count_ == most_messages || bytes_ >= enough_bytes; }

    /// Returns the buffers that have not been sent.
    std::span<const boost::asio::const_buffer> buffers() const {
        return {buffers_.data() + first_, 2 * count_ - first_};
    }

    /// Removes the first `bytes`, which have been sent.
    void consume(std::size_t bytes);

  private:
    void add(Outbox::Item item);

    std::array<Outbox::Item, most_messages> items_;
    std::array<std::array<std::uint8_t, 10>, most_messages> headers_;
    std::array<boost::asio::const_buffer, 2 * most_messages> buffers_;
    std::size_t count_ = 0;
    std::size_t bytes_ = 0;
    std::size_t first_ = 0; ///< index of the first buffer that has not been sent
};

/// Returns the bytes of a message or frame.
std::span<const std::byte> bytes_of(const Outbox::Item& item);

/// Says whether an item is a message, which is text on the wire.
bool is_text(const Outbox::Item& item);

/// Answers the upgrade request, already admitted, and serves the stream until it closes.
void serve_websocket(ByteStream stream,
                     const HttpRequest& upgrade,
                     const Admitted& admitted,
                     NetServices services,
                     std::unique_ptr<Admission::Permit> permit);

} // namespace wakesurf::server
