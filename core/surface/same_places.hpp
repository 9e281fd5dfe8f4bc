// Numbers points by their places: parts of a boundary that meet have points of their own there.
#pragma once

#include "core/base/vec3.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <vector>

namespace wakesurf::core {

/// Returns for each point the number of the first that lies at the same place, to the bit.
template <class V>
std::vector<std::uint32_t> same_places(const std::vector<V>& points) {
    const auto key =
        [&](std::uint32_t i) { // of bits: what is no number has a place in the order as well
            const auto bits = [](auto value) {
                using Bits = std::conditional_t<sizeof(value) == 4, std::uint32_t, std::uint64_t>;
                return std::bit_cast<Bits>(value + 0);
            };
            return std::tuple(bits(points[i].x), bits(points[i].y), bits(points[i].z), i);
        };
    std::vector<std::uint32_t> order(points.size()), places(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, key);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
        places[order[k]] = same ? places[order[k - 1]] : order[k];
    }
    return places;
}

} // namespace wakesurf::core
