// WebSocket frames as a client writes them, right or wrong: RFC 6455, section 5.2.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace wakesurf::tests::ws {

inline constexpr int fin = 0x80;
inline constexpr int continuation = 0;
inline constexpr int text = 1;
inline constexpr int binary = 2;
inline constexpr int closing = 8;
inline constexpr int ping = 9;
inline constexpr int pong = 10;

/// Returns the head of a masked frame that announces `size` bytes; `first` is its whole first byte.
inline std::string head(int first, std::uint64_t size) {
    const int extra = size < 126 ? 0 : size < 65536 ? 2 : 8;
    const auto seven_bits = extra == 0 ? size : extra == 2 ? 126u : 127u;
    std::string bytes{static_cast<char>(first), static_cast<char>(0x80 | seven_bits)};
    for (int i = extra - 1; i >= 0; --i)
        bytes += static_cast<char>((size >> (8 * i)) & 0xff);
    return bytes + std::string("\x37\xfa\x21\x3d", 4); // a mask that is seen to be applied
}

/// Returns a masked frame.
inline std::string frame(int first, const std::string& payload) {
    const std::string mask("\x37\xfa\x21\x3d", 4);
    std::string bytes = head(first, payload.size());
    for (std::size_t i = 0; i < payload.size(); ++i)
        bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
    return bytes;
}

inline std::string close_payload(unsigned code, const std::string& reason = {}) {
    return std::string{static_cast<char>(code >> 8), static_cast<char>(code & 0xff)} + reason;
}

/// Returns a call of server.ping whose text has `size` bytes, padded behind; 0: as short as it is. `id` goes
/// in as raw bytes.
inline std::string call(const std::string& id, std::size_t size = 0) {
    std::string words = R"({"jsonrpc":"2.0","method":"server.ping","id":")" + id + "\"}";
    words.resize(std::max(size, words.size()), ' ');
    return words;
}

} // namespace wakesurf::tests::ws
