#include "protocol/wire/range_coder.hpp"

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
        EXPECT_FALSE(decoder.failed());
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
    // The decisions that lead to the middle of the range from below: the encoder holds back a row of 0xff until it knows whether what
    // comes then lies above, which it does every second time.
    for (const std::size_t length : {3u, 4u, 9u, 40u})
        for (std::uint32_t seed = 0; seed < 40; ++seed) {
            Bytes path(length, std::byte{0xff});
            path[0] = std::byte{0x7f};
            RangeDecoder towards(path);
            std::vector<bool> bits;
            for (std::size_t i = 0; i + 2 < 8 * length; ++i)
                bits.push_back(towards.even());
            std::mt19937 random(seed);
            for (int i = 0; i < 64; ++i)
                bits.push_back(random() % 2 == 0);
            RangeEncoder encoder;
            for (const bool bit : bits)
                encoder.even(bit);
            const Bytes bytes = encoder.finish();
            RangeDecoder decoder(bytes);
            for (const bool bit : bits)
                ASSERT_EQ(decoder.even(), bit) << length << " " << seed;
            EXPECT_TRUE(decoder.exhausted());
        }
}

TEST(RangeCoder, RefusesABeginningAndAWidthThatNoEncoderWrites) {
    const Bytes full(8, std::byte{0xff});
    EXPECT_TRUE(RangeDecoder(full).failed());
    const Bytes zeros(8, std::byte{0}); // every decision is 1: a width of 63
    RangeDecoder decoder(zeros);
    EXPECT_FALSE(decoder.failed());
    AdaptiveNumber().code(decoder, 0);
    EXPECT_TRUE(decoder.failed());
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
    EXPECT_TRUE(decoder.failed());
    EXPECT_FALSE(decoder.exhausted());
}

} // namespace
} // namespace wakesurf::protocol
