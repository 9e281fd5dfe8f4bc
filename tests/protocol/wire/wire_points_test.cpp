#include "protocol/wire/wire_points.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace wakesurf::protocol::wire_points_test {
namespace {

/// Mostly small residuals; one in `rare` is of any size.
Residuals
random_residuals(std::uint32_t seed, std::uint32_t count, PointKind kind, std::uint32_t rare) {
    std::mt19937 random(seed);
    const auto any = [&] {
        if (random() % rare == 0)
            return static_cast<std::int32_t>(random() % (1u << (random() % 20))) - (1 << 10);
        return static_cast<std::int32_t>(random() % 7) - 3;
    };
    Residuals residuals;
    residuals.count = count;
    residuals.coding.kind = kind;
    residuals.coding.attributes = 3;
    residuals.coding.predictor = {3, 2, 1, 0};
    residuals.coding.tolerance = {2, 128, 0, 32767};
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        residuals.position.push_back(any());
    for (std::uint32_t i = 0; kind == PointKind::Added && i < 3 * count; ++i)
        residuals.change.push_back(any());
    for (std::size_t a = 0; a < residuals.coding.attributes; ++a)
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i == 0)
                residuals.codes.emplace_back();
            residuals.codes.back().push_back(a == 1 ? 0 : any());
        }
    return residuals;
}

/// Reads a block of its own.
core::Result<Residuals> read_back(const PointBlock& block,
                                  PointKind kind,
                                  std::uint32_t most,
                                  std::uint8_t attributes = 3) {
    Numbers numbers(block.numbers);
    std::span<const std::byte> draco = block.draco;
    auto read = read_block(numbers, draco, {kind, attributes, most});
    if (read) {
        EXPECT_EQ(numbers.left(), 0u);
        EXPECT_TRUE(draco.empty());
    }
    return read;
}

const std::string damaged = "a block of points in a mesh update is damaged or too long";

constexpr PointKind kinds[] = {PointKind::Moved, PointKind::Added};

TEST(WirePoints, ReadBackEveryResidualSmallOrLarge) {
    std::uint32_t seed = 0;
    for (const PointKind kind : kinds)
        for (const std::uint32_t count : {1u, 2u, 5u, 100u, 3000u})
            for (const std::uint32_t rare : {2u, 50u, 1000000u}) {
                const Residuals residuals = random_residuals(++seed, count, kind, rare);
                const auto block = write_block(residuals, 0, count);
                ASSERT_TRUE(block.has_value()) << block.error().message;
                const auto back = read_back(*block, kind, count);
                ASSERT_TRUE(back.has_value()) << back.error().message;
                EXPECT_EQ(*back, residuals);
            }
}

TEST(WirePoints, NeedNoDracoForAFewResidualsOrNone) {
    Residuals residuals = random_residuals(1, 30'000, PointKind::Moved, 1000);
    residuals.position.assign(90'000, 0);
    for (auto& codes : residuals.codes)
        codes.assign(30'000, 0);
    const auto none = write_block(residuals, 0, 30'000);
    EXPECT_LE(none->numbers.size(), 11u);
    EXPECT_TRUE(none->draco.empty());
    residuals.position[4000] = 7;
    residuals.codes[2][9000] = -40'000;
    const auto few = write_block(residuals, 0, 30'000);
    EXPECT_LE(few->numbers.size(), 11u + 2u * 7u);
    EXPECT_TRUE(few->draco.empty());
    EXPECT_EQ(*read_back(*few, PointKind::Moved, 30'000), residuals);
}

TEST(WirePoints, StandSideBySideAndAreHeldToTheVerticesLeft) {
    const Residuals residuals = random_residuals(7, 300, PointKind::Added, 40);
    PointBlock both = *write_block(residuals, 0, 100);
    const PointBlock second = *write_block(residuals, 100, 300);
    both.numbers.insert(both.numbers.end(), second.numbers.begin(), second.numbers.end());
    both.draco.insert(both.draco.end(), second.draco.begin(), second.draco.end());
    EXPECT_EQ(read_back(both, PointKind::Added, 99).error().message, damaged);
    EXPECT_EQ(read_back(both, PointKind::Added, 300, 2).error().message, damaged)
        << "another number of attributes";
    Numbers numbers(both.numbers);
    std::span<const std::byte> draco = both.draco;
    ASSERT_TRUE(read_block(numbers, draco, {PointKind::Added, 3, 300}).has_value());
    EXPECT_EQ(read_block(numbers, draco, {PointKind::Added, 3, 200})->count, 200u);
    EXPECT_EQ(numbers.left(), 0u);
    EXPECT_TRUE(draco.empty());
}

TEST(WirePoints, AreRefusedCutOff) {
    for (const PointKind kind : kinds) {
        const PointBlock good = *write_block(random_residuals(5, 200, kind, 30), 0, 200);
        for (std::size_t size = 0; size < good.numbers.size(); ++size) {
            PointBlock cut = good;
            cut.numbers.resize(size);
            EXPECT_EQ(read_back(cut, kind, 200).error().message, damaged) << size;
        }
        for (std::size_t size = 0; size < good.draco.size(); ++size) {
            PointBlock cut = good;
            cut.draco.resize(size);
            EXPECT_EQ(read_back(cut, kind, 200).error().message, damaged) << size;
        }
    }
}

TEST(WirePoints, RefuseUnknownPredictorsChannelsTolerancesAndEscapes) {
    const PointBlock good = *write_block(random_residuals(5, 200, PointKind::Moved, 30), 0, 200);
    ASSERT_TRUE(read_back(good, PointKind::Moved, 200).has_value());
    // count, channels, predictor and tolerance of each channel, escapes, the first one's vertex
    for (const auto& [at, value] : {std::pair{0u, 0u},
                                    {0u, 201u},
                                    {1u, 16u},
                                    {2u, 4u},
                                    {8u, 4u},
                                    {3u, 32768u},
                                    {10u, 201u},
                                    {11u, 200u}}) {
        PointBlock bad = good;
        bad.numbers[at] = value;
        EXPECT_EQ(read_back(bad, PointKind::Moved, 200).error().message, damaged) << at;
    }
}

} // namespace
} // namespace wakesurf::protocol::wire_points_test
