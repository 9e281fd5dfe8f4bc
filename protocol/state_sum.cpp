#include "protocol/state_sum.hpp"

#include "protocol/bytes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace wakesurf::protocol {

namespace {

constexpr std::size_t word = sizeof(std::uint32_t);

std::uint32_t stir(std::uint32_t lane, std::uint32_t value) {
    return std::rotl(lane ^ value, 13) * 0x9e3779b1u;
}

} // namespace

std::uint32_t word_sum(std::span<const std::byte> bytes) {
    std::uint32_t a = 0x9e3779b1u, b = 0x85ebca77u, c = 0xc2b2ae3du, d = 0x27d4eb2fu;
    std::size_t at = 0;
    for (; at + 4 * word <= bytes.size(); at += 4 * word) {
        a = stir(a, number_at<std::uint32_t>(bytes, at));
        b = stir(b, number_at<std::uint32_t>(bytes, at + word));
        c = stir(c, number_at<std::uint32_t>(bytes, at + 2 * word));
        d = stir(d, number_at<std::uint32_t>(bytes, at + 3 * word));
    }
    std::array<std::uint32_t, 4> lane{a, b, c, d};
    for (std::size_t i = 0; at < bytes.size(); ++i, at += word) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, std::min(word, bytes.size() - at));
        lane[i] = stir(lane[i], value);
    }
    auto result = static_cast<std::uint32_t>((bytes.size() + word - 1) / word);
    for (const std::uint32_t value : lane)
        result = stir(result, value);
    return result ^ (result >> 15);
}

} // namespace wakesurf::protocol
