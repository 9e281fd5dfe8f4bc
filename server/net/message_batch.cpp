#include "server/net/message_batch.hpp"

#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;

namespace {

constexpr std::uint8_t final_fragment = 0x80;
constexpr std::uint8_t text_opcode = 0x1;
constexpr std::uint8_t binary_opcode = 0x2;
constexpr std::size_t longest_short = 125;
constexpr std::uint8_t two_byte_length = 126;
constexpr std::uint8_t eight_byte_length = 127;

/// Writes an unmasked header, as servers do, and returns its size in bytes.
std::size_t
write_header(std::array<std::uint8_t, 10>& header, std::uint8_t opcode, std::size_t length) {
    header[0] = final_fragment | opcode;
    if (length <= longest_short) {
        header[1] = static_cast<std::uint8_t>(length);
        return 2;
    }
    const bool fits = length <= 0xffff;
    const std::size_t size = fits ? 2 : 8;
    header[1] = fits ? two_byte_length : eight_byte_length;
    for (std::size_t i = 0; i < size; ++i) // the most significant byte first
        header[2 + i] = static_cast<std::uint8_t>(length >> (8 * (size - 1 - i)));
    return 2 + size;
}

} // namespace

std::span<const std::byte> bytes_of(const Outbox::Item& item) {
    if (const auto* text = std::get_if<Outbox::Message>(&item))
        return std::as_bytes(std::span(**text));
    return *std::get<Outbox::Frame>(item);
}

bool is_text(const Outbox::Item& item) {
    return std::holds_alternative<Outbox::Message>(item);
}

void MessageBatch::fill(Outbox& outbox) {
    while (!full()) {
        auto item = outbox.pop();
        if (!item)
            return;
        add(std::move(*item));
    }
}

void MessageBatch::add(Outbox::Item item) {
    items_[count_] = std::move(item);
    const auto payload = bytes_of(items_[count_]);
    auto& header = headers_[count_];
    const std::uint8_t opcode = is_text(items_[count_]) ? text_opcode : binary_opcode;
    buffers_[2 * count_] =
        asio::buffer(header.data(), write_header(header, opcode, payload.size()));
    buffers_[2 * count_ + 1] = asio::buffer(payload.data(), payload.size());
    bytes_ += payload.size();
    ++count_;
}

void MessageBatch::consume(std::size_t bytes) {
    while (first_ < 2 * count_ && bytes >= buffers_[first_].size())
        bytes -= buffers_[first_++].size();
    if (first_ < 2 * count_)
        buffers_[first_] += bytes;
}

} // namespace wakesurf::server
