#include "core/base/half.hpp"

#include <bit>
#include <cmath>
#include <cstddef>

#if defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace wakesurf::core {

namespace {

std::uint16_t rounded(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) // NaN: quiet, with as much of its payload as fits
        return static_cast<std::uint16_t>(sign | 0x7e00u | (magnitude >> 13 & 0x3ffu));
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
    if (magnitude >= 0x7c00u) {
        const std::uint32_t quiet = magnitude > 0x7c00u ? 0x400000u : 0u;
        return std::bit_cast<float>(sign | 0x7f800000u | quiet | (magnitude & 0x3ffu) << 13);
    }
    // The exponents' biases differ by 112; multiplying handles what is below 2^-14 as well.
    const float value = std::bit_cast<float>(magnitude << 13) * 0x1p112f;
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(value));
}

// Eight at a time; what is left over is done one by one.
#if defined(__x86_64__)

__attribute__((target("avx,f16c"))) std::size_t to_half_in_eights(std::span<const float> values,
                                                                  std::uint16_t* halves) {
    std::size_t i = 0;
    for (; i + 8 <= values.size(); i += 8)
        _mm_storeu_si128(
            reinterpret_cast<__m128i*>(halves + i),
            _mm256_cvtps_ph(_mm256_loadu_ps(values.data() + i), _MM_FROUND_TO_NEAREST_INT));
    return i;
}

__attribute__((target("avx,f16c"))) std::size_t
from_half_in_eights(std::span<const std::uint16_t> halves, float* values) {
    std::size_t i = 0;
    for (; i + 8 <= halves.size(); i += 8)
        _mm256_storeu_ps(values + i, _mm256_cvtph_ps(_mm_loadu_si128(
                                         reinterpret_cast<const __m128i*>(halves.data() + i))));
    return i;
}

bool has_instructions() {
    // clang 14's __builtin_cpu_supports does not know f16c; that of avx asks the operating system too.
    static const bool has = [] {
        unsigned a = 0, b = 0, c = 0, d = 0;
        return __builtin_cpu_supports("avx") != 0 && __get_cpuid(1, &a, &b, &c, &d) != 0 &&
               (c & bit_F16C) != 0;
    }();
    return has;
}

#else

std::size_t to_half_in_eights(std::span<const float>, std::uint16_t*) {
    return 0;
}

std::size_t from_half_in_eights(std::span<const std::uint16_t>, float*) {
    return 0;
}

bool has_instructions() {
    return false;
}

#endif

} // namespace

void to_half_portable(std::span<const float> values, std::span<std::uint16_t> halves) {
    for (std::size_t i = 0; i < values.size(); ++i)
        halves[i] = rounded(values[i]);
}

void from_half_portable(std::span<const std::uint16_t> halves, std::span<float> values) {
    for (std::size_t i = 0; i < halves.size(); ++i)
        values[i] = widened(halves[i]);
}

void to_half(std::span<const float> values, std::span<std::uint16_t> halves) {
    const std::size_t done = has_instructions() ? to_half_in_eights(values, halves.data()) : 0;
    to_half_portable(values.subspan(done), halves.subspan(done));
}

void from_half(std::span<const std::uint16_t> halves, std::span<float> values) {
    const std::size_t done = has_instructions() ? from_half_in_eights(halves, values.data()) : 0;
    from_half_portable(halves.subspan(done), values.subspan(done));
}

} // namespace wakesurf::core
