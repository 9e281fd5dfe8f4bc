#include "protocol/wire/draco_points.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace wakesurf::protocol::draco_points_test {
namespace {

using Values = std::vector<std::vector<std::int32_t>>;

/// The first channel has three components, the others one.
Values random_values(std::uint32_t points, std::size_t channels, std::uint32_t seed, int bits) {
    std::mt19937 random(seed);
    Values values;
    for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t i = 0, n = (c == 0 ? 3 : 1) * points, first = values.size(); i < n; ++i) {
            if (i == 0)
                values.emplace_back();
            values[first].push_back(static_cast<std::int32_t>(random() >> (32 - bits)) -
                                    (1 << (bits - 1)));
        }
    return values;
}

core::Result<Bytes> encoded(const Values& values, std::uint32_t points) {
    std::vector<Channel<const std::int32_t>> channels;
    for (const auto& each : values)
        channels.push_back({each, each.size() / points});
    return encode_points(channels, points);
}

core::Result<Values>
decoded(std::span<const std::byte> bytes, std::uint32_t points, std::size_t channels) {
    Values values(channels);
    std::vector<Channel<std::int32_t>> spans;
    for (std::size_t c = 0; c < channels; ++c) {
        const std::size_t components = c == 0 ? 3 : 1;
        values[c].resize(components * points);
        spans.push_back({values[c], components});
    }
    return decode_points(bytes, spans, points).map([&] { return values; });
}

TEST(DracoPoints, KeepTheirOrderAndEveryBit) {
    std::uint32_t seed = 0;
    for (const int bits : {1, 4, 12, 16})
        for (const std::uint32_t points : {1u, 2u, 3u, 100u, 5000u})
            for (const std::size_t channels : {1u, 2u, 4u}) {
                const Values values = random_values(points, channels, ++seed, bits);
                const auto bytes = encoded(values, points);
                ASSERT_TRUE(bytes.has_value()) << bytes.error().message;
                const auto back = decoded(*bytes, points, channels);
                ASSERT_TRUE(back.has_value()) << back.error().message;
                EXPECT_EQ(*back, values) << points << " points of " << bits << " bits";
            }
}

TEST(DracoPoints, CostNextToNothingWhereThePredictionWasRight) {
    Values values{std::vector<std::int32_t>(30'000), std::vector<std::int32_t>(10'000)};
    EXPECT_LT(encoded(values, 10'000)->size(), 60u);
}

TEST(DracoPoints, AreRefusedWhenTheirCountsAreNotTheExpectedOnes) {
    const auto bytes = encoded(random_values(100, 3, 3, 10), 100);
    EXPECT_TRUE(decoded(*bytes, 100, 3).has_value());
    const std::string other = "the Draco block of a mesh frame is not what its header announces";
    EXPECT_EQ(decoded(*bytes, 99, 3).error().message, other);
    EXPECT_EQ(decoded(*bytes, 101, 3).error().message, other);
    EXPECT_EQ(decoded(*bytes, 100, 2).error().message, other);
    EXPECT_EQ(decoded(*bytes, 100, 4).error().message, other);
    Bytes huge = *bytes;
    huge[14] = std::byte{0x7f}; // top byte of Draco's own point count
    EXPECT_EQ(decoded(huge, 100, 3).error().message, other);
}

} // namespace
} // namespace wakesurf::protocol::draco_points_test
