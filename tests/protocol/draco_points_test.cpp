#include "protocol/draco_points.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::protocol {
namespace {

struct Points {
    std::vector<LatticePoint> positions;
    std::vector<std::vector<std::uint16_t>> attributes;

    bool operator==(const Points&) const = default;
};

Points random_points(std::size_t count, std::size_t attributes, std::uint32_t seed, int bits) {
    std::mt19937 random(seed);
    Points points;
    points.positions.resize(count);
    points.attributes.assign(attributes, std::vector<std::uint16_t>(count));
    for (auto& position : points.positions)
        for (auto& coordinate : position)
            coordinate = static_cast<std::int32_t>(random() >> (32 - bits));
    for (auto& values : points.attributes)
        for (auto& value : values)
            value = static_cast<std::uint16_t>(random());
    return points;
}

core::Result<Bytes> encoded(const Points& points) {
    const std::vector<std::span<const std::uint16_t>> attributes(points.attributes.begin(),
                                                                 points.attributes.end());
    return encode_points(points.positions, attributes);
}

core::Result<Points>
decoded(std::span<const std::byte> bytes, std::size_t count, std::size_t attributes) {
    Points points;
    points.positions.resize(count);
    points.attributes.assign(attributes, std::vector<std::uint16_t>(count));
    const std::vector<std::span<std::uint16_t>> spans(points.attributes.begin(),
                                                      points.attributes.end());
    return decode_points(bytes, points.positions, spans).map([&] { return points; });
}

TEST(DracoPoints, KeepTheirOrderAndEveryBit) {
    std::uint32_t seed = 0;
    for (const int bits : {1, 4, 16, 20})
        for (const std::size_t count : {1u, 2u, 3u, 100u, 5000u})
            for (const std::size_t attributes : {0u, 1u, 3u}) {
                const Points points = random_points(count, attributes, ++seed, bits);
                const auto bytes = encoded(points);
                ASSERT_TRUE(bytes.has_value()) << bytes.error().message;
                const auto back = decoded(*bytes, count, attributes);
                ASSERT_TRUE(back.has_value()) << back.error().message;
                EXPECT_EQ(*back, points) << count << " points of " << bits << " bits";
            }
}

TEST(DracoPoints, CostNextToNothingOnAStraightColumn) {
    Points points = random_points(10'000, 1, 1, 16);
    for (std::int32_t i = 0; i < 10'000; ++i) {
        points.positions[static_cast<std::size_t>(i)] = {3 * i, 7, 30'000 - 2 * i};
        points.attributes[0][static_cast<std::size_t>(i)] = 5;
    }
    EXPECT_LT(encoded(points)->size(), 200u);
}

TEST(DracoPoints, AreRefusedWhenTheirCountsAreNotTheExpectedOnes) {
    const auto bytes = encoded(random_points(100, 2, 3, 16));
    EXPECT_TRUE(decoded(*bytes, 100, 2).has_value());
    for (const auto& [count, attributes] : {std::pair{99, 2}, {101, 2}, {100, 1}, {100, 3}})
        EXPECT_FALSE(
            decoded(*bytes, static_cast<std::size_t>(count), static_cast<std::size_t>(attributes))
                .has_value());
    Bytes huge = *bytes;
    huge[14] = std::byte{0x7f}; // top byte of Draco's own point count
    EXPECT_FALSE(decoded(huge, 100, 2).has_value());
}

} // namespace
} // namespace wakesurf::protocol
