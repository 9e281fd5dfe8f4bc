// Little-endian numbers and varints in byte strings: the atoms of the binary wire.
#pragma once

#include "core/base/result.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

/// The error for bytes that no server of ours wrote.
inline tl::unexpected<core::Error> corrupt(std::string message) {
    return core::fail(core::Error::Code::Corrupt, std::move(message),
                      "subscribe to the surface again");
}

static_assert(std::endian::native == std::endian::little,
              "numbers are copied as they lie in memory");

using Bytes = std::vector<std::byte>;

/// Holds the frames of an update, which many connections send.
using SharedFrames = std::vector<std::shared_ptr<const Bytes>>;

template <class T>
requires std::is_arithmetic_v<T>

void append(Bytes& bytes, T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// Reads a number at `offset`. REQUIRES: offset + sizeof(T) <= bytes.size().
template <class T>

requires std::is_arithmetic_v<T> T number_at(std::span<const std::byte> bytes, std::size_t offset) {
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// Appends seven bits a byte, lowest first, the top bit set on all but the last: 1 to 5 bytes.
inline void append_varint(Bytes& bytes, std::uint32_t value) {
    for (; value >= 0x80u; value >>= 7)
        bytes.push_back(static_cast<std::byte>((value & 0x7fu) | 0x80u));
    bytes.push_back(static_cast<std::byte>(value));
}

/// Reads a varint and moves `at` behind it; empty if it is cut off or does not fit 32 bits.
inline std::optional<std::uint32_t> take_varint(std::span<const std::byte> bytes, std::size_t& at) {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 35 && at < bytes.size(); shift += 7) {
        const auto byte = std::to_integer<std::uint32_t>(bytes[at++]);
        if (shift == 28 && byte > 0x0fu)
            return std::nullopt;
        value |= (byte & 0x7fu) << shift;
        if ((byte & 0x80u) == 0)
            return value;
    }
    return std::nullopt;
}

/// Maps differences modulo 2^32 near zero, of either sign, to small numbers: 0, -1, 1, -2 ... -> 0, 1, 2, 3
/// ...
inline std::uint32_t zigzag(std::uint32_t difference) {
    return (difference << 1) ^ ((difference >> 31) != 0 ? 0xffffffffu : 0u);
}

inline std::uint32_t unzigzag(std::uint32_t code) {
    return (code >> 1) ^ ((code & 1u) != 0 ? 0xffffffffu : 0u);
}

} // namespace wakesurf::protocol
