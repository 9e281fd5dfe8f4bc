#include "core/base/crc32c.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace wakesurf::core::crc32c_test {
namespace {

std::uint32_t crc_of(std::string_view text) {
    return crc32c(std::as_bytes(std::span(text)));
}

/// The definition, a bit at a time.
std::uint32_t bitwise(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0x82f63b78u : crc >> 1;
    }
    return ~crc;
}

TEST(Crc32c, GivesThePublishedCheckValues) {
    EXPECT_EQ(crc_of("123456789"), 0xe3069283u);
    EXPECT_EQ(crc_of(""), 0u);
    // RFC 3720, B.4: 32 bytes of zeros, of ones, ascending.
    EXPECT_EQ(crc32c(std::vector(32, std::byte{0})), 0x8a9136aau);
    EXPECT_EQ(crc32c(std::vector(32, std::byte{0xff})), 0x62a8ab43u);
    std::vector<std::byte> ascending(32);
    for (std::size_t i = 0; i < ascending.size(); ++i)
        ascending[i] = static_cast<std::byte>(i);
    EXPECT_EQ(crc32c(ascending), 0x46dd794eu);
}

TEST(Crc32c, EqualsItsDefinitionForEveryLengthAndAlignment) {
    std::vector<std::byte> bytes(67);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(i * i * 31 + 7);
    for (std::size_t from = 0; from < 8; ++from)
        for (std::size_t to = from; to <= bytes.size(); ++to) {
            const auto part = std::span(bytes).subspan(from, to - from);
            ASSERT_EQ(crc32c(part), bitwise(part)) << "bytes " << from << " to " << to;
        }
}

TEST(Crc32c, OfAWholeIsThatOfItsPartsInTurn) {
    constexpr std::string_view text = "quads with hanging nodes, column by column";
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        EXPECT_EQ(crc32c(std::as_bytes(std::span(text.substr(cut))), crc_of(text.substr(0, cut))),
                  crc_of(text));
}

TEST(Crc32c, ProcessorsWithAndWithoutAnInstructionForItAgreeAtEveryLengthAndAlignment) {
    std::vector<std::byte> bytes(5 * 12288 + 64);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(i * i >> 3);
    const std::span<const std::byte> all(bytes);
    for (const std::size_t around : {0u, 8u, 4096u, 8192u, 12288u, 24576u, 36864u, 61440u})
        for (std::size_t size = around < 20 ? 0 : around - 20; size < around + 20; ++size)
            for (const std::size_t begin : {0u, 1u, 7u, 8u})
                ASSERT_EQ(crc32c(all.subspan(begin, size), 0x1234567u),
                          crc32c_portable(all.subspan(begin, size), 0x1234567u))
                    << size << " from " << begin;
}

} // namespace
} // namespace wakesurf::core::crc32c_test
