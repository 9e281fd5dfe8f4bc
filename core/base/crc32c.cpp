// Slicing-by-8: eight tables turn eight bytes into eight independent look-ups. Source: Kounavis, Berry, Novel
// Table Lookup-Based Algorithms for High-Performance CRC Generation, IEEE Trans. Comput. 57(11), 2008.
// Processors with SSE 4.2 have an instruction for eight bytes, of which three can run at a time: three
// streams, whose sums are joined by the operator of zlib's crc32_combine.
#include "core/base/crc32c.hpp"

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstring>

namespace wakesurf::core {

namespace {

static_assert(std::endian::native == std::endian::little, "the slices below read words in place");

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
    constexpr std::uint32_t reflected_polynomial = 0x82f63b78u;
    Tables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? reflected_polynomial : 0u);
        tables[0][byte] = crc;
    }
    for (std::size_t slice = 1; slice < 8; ++slice)
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[slice - 1][byte];
            tables[slice][byte] = (before >> 8) ^ tables[0][before & 0xffu];
        }
    return tables;
}

constexpr Tables tables = make_tables();

// Each of the three streams is so many bytes long; what is left over at the end goes through one.
constexpr std::size_t stream_bytes = 4096;

using Shift = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr std::uint32_t shifted(const Shift& shift, std::uint32_t crc) {
    return shift[0][crc & 0xffu] ^ shift[1][(crc >> 8) & 0xffu] ^ shift[2][(crc >> 16) & 0xffu] ^
           shift[3][crc >> 24];
}

/// Returns what `stream_bytes` zero bytes make of a register, by the register's bytes. The map is linear, so
/// it is squared until the zeros are that many.
constexpr Shift make_shift() {
    using Images = std::array<std::uint32_t, 32>;
    const auto image = [](const Images& of, std::uint32_t bits) {
        std::uint32_t sum = 0;
        for (std::size_t bit = 0; bit < 32; ++bit)
            sum ^= (bits >> bit & 1u) != 0 ? of[bit] : 0u;
        return sum;
    };
    Images zeros{};
    for (std::size_t bit = 0; bit < 32; ++bit) {
        const std::uint32_t crc = std::uint32_t{1} << bit;
        zeros[bit] = (crc >> 8) ^ tables[0][crc & 0xffu];
    }
    for (std::size_t bytes = 1; bytes < stream_bytes; bytes *= 2) {
        const Images once = zeros;
        for (std::size_t bit = 0; bit < 32; ++bit)
            zeros[bit] = image(once, once[bit]);
    }
    Shift shift{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::uint32_t value = 0; value < 256; ++value)
            shift[byte][value] = image(zeros, value << (8 * byte));
    return shift;
}

constexpr Shift shift = make_shift();

#if defined(__x86_64__)

std::uint64_t word_at(const std::byte* from) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, sizeof(word));
    return word;
}

__attribute__((target("sse4.2"))) std::uint32_t by_instruction(std::span<const std::byte> bytes,
                                                               std::uint32_t so_far) {
    std::uint64_t crc = ~so_far;
    const std::byte* at = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 3 * stream_bytes; left -= 3 * stream_bytes, at += 3 * stream_bytes) {
        std::uint64_t second = 0;
        std::uint64_t third = 0;
        for (std::size_t i = 0; i < stream_bytes; i += 8) {
            crc = _mm_crc32_u64(crc, word_at(at + i));
            second = _mm_crc32_u64(second, word_at(at + stream_bytes + i));
            third = _mm_crc32_u64(third, word_at(at + 2 * stream_bytes + i));
        }
        crc = shifted(shift, static_cast<std::uint32_t>(crc)) ^ second;
        crc = shifted(shift, static_cast<std::uint32_t>(crc)) ^ third;
    }
    for (; left >= 8; left -= 8, at += 8)
        crc = _mm_crc32_u64(crc, word_at(at));
    auto last = static_cast<std::uint32_t>(crc);
    for (; left > 0; --left, ++at)
        last = _mm_crc32_u8(last, std::to_integer<unsigned char>(*at));
    return ~last;
}

bool has_instruction() {
    static const bool has = __builtin_cpu_supports("sse4.2") != 0;
    return has;
}

#else

std::uint32_t by_instruction(std::span<const std::byte> bytes, std::uint32_t so_far) {
    return crc32c_portable(bytes, so_far);
}

bool has_instruction() {
    return false;
}

#endif

} // namespace

std::uint32_t crc32c_portable(std::span<const std::byte> bytes, std::uint32_t so_far) {
    std::uint32_t crc = ~so_far;
    std::size_t at = 0;
    for (; at + 8 <= bytes.size(); at += 8) {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        std::memcpy(&low, bytes.data() + at, 4);
        std::memcpy(&high, bytes.data() + at + 4, 4);
        low ^= crc;
        crc = tables[7][low & 0xffu] ^ tables[6][(low >> 8) & 0xffu] ^
              tables[5][(low >> 16) & 0xffu] ^ tables[4][low >> 24] ^ tables[3][high & 0xffu] ^
              tables[2][(high >> 8) & 0xffu] ^ tables[1][(high >> 16) & 0xffu] ^
              tables[0][high >> 24];
    }
    for (; at < bytes.size(); ++at)
        crc = (crc >> 8) ^ tables[0][(crc ^ std::to_integer<std::uint32_t>(bytes[at])) & 0xffu];
    return ~crc;
}

std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t so_far) {
    return has_instruction() ? by_instruction(bytes, so_far) : crc32c_portable(bytes, so_far);
}

} // namespace wakesurf::core
