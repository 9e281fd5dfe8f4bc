#include "protocol/wire/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wakesurf::protocol::numbers_test {
namespace {

std::vector<std::uint32_t> some_numbers(std::uint32_t seed, std::size_t count) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> numbers(count);
    for (std::uint32_t& number : numbers)
        number = static_cast<std::uint32_t>(random()) >> (random() % 32);
    return numbers;
}

std::vector<std::uint32_t> all_of(Numbers numbers) {
    const auto all = numbers.take(numbers.left());
    return {all.begin(), all.end()};
}

TEST(Numbers, AreReadBackAndLeaveWhatFollowsThem) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const auto numbers = some_numbers(seed, seed < 20 ? seed : 1000 * seed);
        Bytes bytes = pack_numbers(numbers).value();
        bytes.push_back(std::byte{7});
        std::span<const std::byte> update = bytes;
        const auto back = unpack_numbers(update);
        ASSERT_TRUE(back.has_value()) << back.error().message;
        EXPECT_EQ(all_of(*back), numbers);
        ASSERT_EQ(update.size(), 1u);
    }
}

TEST(Numbers, ThatRepeatTakeHardlyAnyBytes) {
    EXPECT_LT(pack_numbers(std::vector<std::uint32_t>(100'000, 3))->size(), 200u);
}

TEST(Numbers, AreRefusedWhenCutOff) {
    const Bytes bytes = pack_numbers(some_numbers(1, 300)).value();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        std::span<const std::byte> update = std::span(bytes).first(size);
        EXPECT_EQ(unpack_numbers(update).error().message, "a mesh update ends within its numbers")
            << size;
    }
}

TEST(Numbers, ThatAreMoreThanDeflateCanMakeOfTheBytesAreRefusedBeforeMemoryIsTaken) {
    Bytes bytes;
    append_varint(bytes, 2);
    append_varint(bytes, 0xffffffffu);
    bytes.insert(bytes.end(), 2, std::byte{3});
    std::span<const std::byte> update = bytes;
    EXPECT_EQ(unpack_numbers(update).error().message, "a mesh update ends within its numbers");
}

TEST(Numbers, SurviveDamageWithAnErrorOrOtherNumbers) {
    std::mt19937 random(3);
    const Bytes good = pack_numbers(some_numbers(2, 500)).value();
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        Bytes bad = good;
        bad[random() % bad.size()] ^= static_cast<std::byte>(1 + random() % 255);
        std::span<const std::byte> update = bad;
        refused += unpack_numbers(update).has_value() ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
}

TEST(Numbers, OnceOneIsMissingOrTooLargeGiveZerosAndHaveFailed) {
    Numbers numbers({5, 6, 7});
    EXPECT_EQ(numbers.next(5), 5u);
    EXPECT_FALSE(numbers.failed());
    EXPECT_EQ(numbers.next(5), 0u);
    EXPECT_TRUE(numbers.failed());
    EXPECT_EQ(numbers.next(), 0u);
    EXPECT_TRUE(numbers.take(1).empty());
    Numbers few({1});
    EXPECT_TRUE(few.take(2).empty());
    EXPECT_TRUE(few.failed());
}

} // namespace
} // namespace wakesurf::protocol::numbers_test
