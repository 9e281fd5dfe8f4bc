#include "protocol/wire/wire_points.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace wakesurf::protocol {
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
    residuals.coding.attributes = kind == PointKind::Change ? 0 : 3;
    if (kind != PointKind::Change) {
        residuals.coding.predictor = {4, 2, 1, 5};
        residuals.coding.tolerance = {2, 128, 0, 32767};
    }
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        residuals.position.push_back(any());
    for (std::size_t a = 0; a < residuals.coding.attributes; ++a)
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i == 0)
                residuals.codes.emplace_back();
            residuals.codes.back().push_back(a == 1 ? 0 : any());
        }
    return residuals;
}

/// Why a block is refused; empty where it is read.
std::string refusal(std::span<const std::byte> bytes,
                    std::size_t& at,
                    std::uint32_t most,
                    std::uint8_t attributes = 3) {
    const auto read = read_block(bytes, at, attributes, most);
    return read ? std::string() : read.error().message;
}

const std::string unknown_or_too_long =
    "a block of points in a mesh frame is of an unknown kind or too long";
const std::string damaged = "a block of points in a mesh frame is damaged";

constexpr PointKind kinds[] = {PointKind::Moved, PointKind::Added, PointKind::Change};

TEST(WirePoints, ReadBackEveryResidualSmallOrLarge) {
    std::uint32_t seed = 0;
    for (const PointKind kind : kinds)
        for (const std::uint32_t count : {1u, 2u, 5u, 100u, 3000u})
            for (const std::uint32_t rare : {2u, 50u, 1000000u}) {
                const Residuals residuals = random_residuals(++seed, count, kind, rare);
                const auto bytes = write_block(residuals, 0, count);
                ASSERT_TRUE(bytes.has_value()) << bytes.error().message;
                std::size_t at = 0;
                const auto back = read_block(*bytes, at, 3, count);
                ASSERT_TRUE(back.has_value()) << back.error().message;
                EXPECT_EQ(*back, residuals);
                EXPECT_EQ(at, bytes->size());
            }
}

TEST(WirePoints, NeedNoDracoForAFewResidualsOrNone) {
    Residuals residuals = random_residuals(1, 30'000, PointKind::Moved, 1000);
    residuals.position.assign(90'000, 0);
    for (auto& codes : residuals.codes)
        codes.assign(30'000, 0);
    EXPECT_LE(write_block(residuals, 0, 30'000)->size(), 20u);
    residuals.position[4000] = 7;
    residuals.codes[2][9000] = -40'000;
    const auto bytes = write_block(residuals, 0, 30'000);
    EXPECT_LE(bytes->size(), 40u);
    std::size_t at = 0;
    EXPECT_EQ(*read_block(*bytes, at, 3, 30'000), residuals);
}

TEST(WirePoints, StandSideBySideAndAreHeldToTheVerticesLeft) {
    const Residuals residuals = random_residuals(7, 300, PointKind::Added, 40);
    Bytes both = *write_block(residuals, 0, 100);
    const Bytes second = *write_block(residuals, 100, 300);
    both.insert(both.end(), second.begin(), second.end());
    std::size_t at = 0;
    EXPECT_EQ(refusal(both, at, 99), unknown_or_too_long);
    EXPECT_EQ(at, 0u);
    ASSERT_TRUE(read_block(both, at, 3, 300).has_value());
    EXPECT_EQ(read_block(both, at, 3, 200)->count, 200u);
    EXPECT_EQ(at, both.size());
    at = 0;
    EXPECT_EQ(refusal(both, at, 300, 2), unknown_or_too_long) << "another number of attributes";
}

TEST(WirePoints, AreRefusedCutOffAndNeverReadBeyondTheirEnd) {
    for (const PointKind kind : kinds) {
        const Bytes good = *write_block(random_residuals(5, 200, kind, 30), 0, 200);
        // kind, count in two bytes, channels, a predictor of each, and their tolerances in seven
        const std::size_t head = kind == PointKind::Change ? 5 : 15;
        for (std::size_t size = 0; size < good.size(); ++size) {
            std::size_t at = 0;
            EXPECT_EQ(refusal(std::span(good).first(size), at, 200),
                      size < head ? unknown_or_too_long : damaged)
                << size;
        }
    }
}

TEST(WirePoints, RefuseUnknownKindsPredictorsAndChannels) {
    const Bytes good = *write_block(random_residuals(5, 200, PointKind::Moved, 30), 0, 200);
    // kind, count in two bytes, channels, predictors
    for (const auto& [at, value] : {std::pair{0, 3}, {1, 0x80}, {3, 0x10}, {4, 6}, {7, 6}}) {
        Bytes bad = good;
        bad[static_cast<std::size_t>(at)] = static_cast<std::byte>(value);
        if (at == 1)
            bad[2] = std::byte{0}; // no vertices
        std::size_t begin = 0;
        EXPECT_EQ(refusal(bad, begin, 200), unknown_or_too_long) << at;
    }
}

} // namespace
} // namespace wakesurf::protocol
