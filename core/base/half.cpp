#include "core/base/half.hpp"

#include <bit>
#include <cmath>

namespace wakesurf::core {

namespace {

std::uint16_t rounded(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u)
        return static_cast<std::uint16_t>(sign | 0x7e00u);
    if (magnitude >= 0x477ff000u) // rounds to 65536 or more
        return static_cast<std::uint16_t>(sign | 0x7c00u);
    if (magnitude < 0x38800000u) { // below 2^-14: steps of 2^-24
        const float scaled = std::nearbyint(std::abs(value) * 0x1p24f);
        return static_cast<std::uint16_t>(sign | static_cast<std::uint16_t>(scaled));
    }
    const std::uint32_t odd = magnitude >> 13 & 1u;
    return static_cast<std::uint16_t>(sign | ((magnitude - 0x38000000u + 0xfffu + odd) >> 13));
}

float widened(std::uint16_t half) {
    const std::uint32_t sign = std::uint32_t{half} << 16 & 0x80000000u;
    const std::uint32_t magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00u)
        return std::bit_cast<float>(sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
    // The exponents' biases differ by 112; multiplying handles what is below 2^-14 as well.
    const float value = std::bit_cast<float>(magnitude << 13) * 0x1p112f;
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(value));
}

} // namespace

void to_half(std::span<const float> values, std::span<std::uint16_t> halves) {
    for (std::size_t i = 0; i < values.size(); ++i)
        halves[i] = rounded(values[i]);
}

void from_half(std::span<const std::uint16_t> halves, std::span<float> values) {
    for (std::size_t i = 0; i < halves.size(); ++i)
        values[i] = widened(halves[i]);
}

} // namespace wakesurf::core
