#include "protocol/wire/state_sum.hpp"

#include <array>
#include <bit>
#include <cstddef>

namespace wakesurf::protocol {

namespace {

constexpr std::size_t lanes = 4;

std::uint32_t stir(std::uint32_t sum, std::uint32_t value) {
    return std::rotl(sum ^ value, 13) * 0x9e3779b1u;
}

template <class Word>
std::uint32_t sum_of(std::span<const Word> words) {
    std::array<std::uint32_t, lanes> sum{};
    std::array<std::uint32_t, lanes> of_sums{};
    const std::size_t whole = words.size() / lanes * lanes;
    for (std::size_t at = 0; at < whole; at += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sum[lane] += words[at + lane];
            of_sums[lane] += sum[lane];
        }
    for (std::size_t at = whole; at < words.size(); ++at) {
        sum[at - whole] += words[at];
        of_sums[at - whole] += sum[at - whole];
    }
    auto result = static_cast<std::uint32_t>(words.size());
    for (std::size_t lane = 0; lane < lanes; ++lane)
        result = stir(stir(result, sum[lane]), of_sums[lane]);
    return result ^ (result >> 15);
}

} // namespace

std::uint32_t word_sum(std::span<const std::uint32_t> words) {
    return sum_of(words);
}

std::uint32_t word_sum(std::span<const std::uint16_t> codes) {
    return sum_of(codes);
}

} // namespace wakesurf::protocol
