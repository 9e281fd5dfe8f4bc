#include "protocol/range_coder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wakesurf::protocol {
namespace {

TEST(RangeCoder, GivesBackDecisionsOfEveryLikelihoodAndEndsWhereItEnded) {
    std::mt19937 random(1);
    for (const double likely : {0.0, 1e-4, 0.03, 0.5, 0.9, 1.0}) {
        std::bernoulli_distribution draw(likely);
        std::vector<bool> bits(20'000);
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = draw(random);
        RangeEncoder encoder;
        AdaptiveBit one, other;
        for (std::size_t i = 0; i < bits.size(); ++i) {
            encoder.bit(i % 3 == 0 ? one : other, bits[i]);
            encoder.even(bits[bits.size() - 1 - i]);
        }
        const Bytes bytes = encoder.finish();
        RangeDecoder decoder(bytes);
        one = other = {};
        for (std::size_t i = 0; i < bits.size(); ++i) {
            ASSERT_EQ(decoder.bit(i % 3 == 0 ? one : other), bits[i]) << likely << " " << i;
            ASSERT_EQ(decoder.even(), bits[bits.size() - 1 - i]);
        }
        EXPECT_TRUE(decoder.exhausted());
        EXPECT_FALSE(decoder.overrun());
    }
}

TEST(RangeCoder, NeedsAQuarterMoreThanTheEntropyAtMost) {
    std::mt19937 random(2);
    for (const double likely : {0.01, 0.1, 0.3, 0.5}) {
        constexpr int count = 100'000;
        std::bernoulli_distribution draw(likely);
        RangeEncoder encoder;
        AdaptiveBit bit;
        for (int i = 0; i < count; ++i)
            encoder.bit(bit, draw(random));
        const double entropy =
            -likely * std::log2(likely) - (1.0 - likely) * std::log2(1.0 - likely);
        const double bits = 8.0 * static_cast<double>(encoder.finish().size());
        EXPECT_LE(bits, 1.25 * entropy * count + 100.0) << likely;
    }
}

TEST(RangeCoder, CarriesThroughAnyNumberOfFullBytes) {
    // Unlikely decisions at the very end of the range are what makes a long row of bytes 0xff that a carry then reaches.
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        std::vector<bool> bits(400);
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = i > 300 ? random() % 2 == 0 : false;
        RangeEncoder encoder;
        AdaptiveBit bit;
        for (const bool value : bits) {
            encoder.even(false);
            encoder.bit(bit, value);
        }
        const Bytes bytes = encoder.finish();
        RangeDecoder decoder(bytes);
        bit = {};
        for (const bool value : bits) {
            ASSERT_FALSE(decoder.even());
            ASSERT_EQ(decoder.bit(bit), value) << seed;
        }
        EXPECT_TRUE(decoder.exhausted());
    }
}

TEST(AdaptiveNumber, GivesBackNumbersOfEverySize) {
    std::mt19937 random(3);
    std::vector<std::uint32_t> numbers{0, 1, 2, 0xffffffffu, 0x80000000u, 0x7fffffffu};
    for (int i = 0; i < 5'000; ++i)
        numbers.push_back(static_cast<std::uint32_t>(random()) >> (random() % 32));
    RangeEncoder encoder;
    AdaptiveNumber writing;
    for (const std::uint32_t number : numbers)
        writing.code(encoder, number);
    const Bytes bytes = encoder.finish();
    RangeDecoder decoder(bytes);
    AdaptiveNumber reading;
    for (const std::uint32_t number : numbers)
        ASSERT_EQ(reading.code(decoder, 0), number);
    EXPECT_TRUE(decoder.exhausted());
}

TEST(RangeCoder, SeesZerosBehindTheEndAndSaysSo) {
    RangeDecoder decoder({});
    AdaptiveBit bit;
    for (int i = 0; i < 100; ++i)
        decoder.bit(bit);
    EXPECT_TRUE(decoder.overrun());
    EXPECT_FALSE(decoder.exhausted());
}

} // namespace
} // namespace wakesurf::protocol
