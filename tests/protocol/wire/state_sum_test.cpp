#include "protocol/wire/wire_mesh.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <vector>

namespace wakesurf::protocol::state_sum_test {
namespace {

std::uint32_t sum_of(const std::vector<std::uint32_t>& words) {
    return word_sum(std::span(words));
}

TEST(StateSum, OfSmallWordListsIsWhatTheReadmeSays) {
    EXPECT_EQ(sum_of({}), 0u);
    EXPECT_EQ(sum_of({1, 2, 3, 4, 5}), 0xe6b39396u);
}

TEST(StateSum, ChangesWithAnyBitAnyExchangeAndAnyLength) {
    std::vector<std::uint32_t> words(37);
    std::iota(words.begin(), words.end(), 1000u);
    const std::uint32_t whole = sum_of(words);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (unsigned bit = 0; bit < 32; ++bit) {
            words[i] ^= 1u << bit;
            EXPECT_NE(sum_of(words), whole) << "bit " << bit << " of word " << i;
            words[i] ^= 1u << bit;
        }
    for (std::size_t distance = 1; distance < 9; ++distance)
        for (std::size_t i = 0; i + distance < words.size(); ++i) {
            std::swap(words[i], words[i + distance]);
            EXPECT_NE(sum_of(words), whole) << "exchange of " << i << " and " << i + distance;
            std::swap(words[i], words[i + distance]);
        }
    EXPECT_EQ(sum_of(words), whole);
    std::vector<std::uint32_t> zeros;
    std::set<std::uint32_t> lengths;
    for (; zeros.size() < 50; zeros.push_back(0))
        lengths.insert(sum_of(zeros));
    EXPECT_EQ(lengths.size(), 50u);
}

TEST(StateSum, TakesEachCodeForAWord) {
    const std::array<std::uint16_t, 5> codes{7, 8, 9, 65535, 1};
    EXPECT_EQ(word_sum(std::span<const std::uint16_t>(codes)), sum_of({7, 8, 9, 65535, 1}));
}

TEST(StateSum, OfAMeshCoversPositionsCodesAndCells) {
    WireMesh mesh;
    mesh.ranges = {{0.f, 1.f}};
    mesh.position = {{1, 2, 3}, {4, 5, 6}};
    mesh.codes = {{7, 8}};
    core::Cell cell;
    cell.corner = {0, 1, 0, 1};
    mesh.topology = std::make_shared<const WireTopology>(std::vector{cell}, 2);
    std::set<std::uint32_t> seen{state_sum(mesh)};
    mesh.position[1][2] = 7;
    seen.insert(state_sum(mesh));
    mesh.codes[0][0] = 8;
    seen.insert(state_sum(mesh));
    cell.mid[3] = 1;
    mesh.topology = std::make_shared<const WireTopology>(std::vector{cell}, 2);
    seen.insert(state_sum(mesh));
    mesh.codes.clear();
    seen.insert(state_sum(mesh));
    EXPECT_EQ(seen.size(), 5u);
}

} // namespace
} // namespace wakesurf::protocol::state_sum_test
