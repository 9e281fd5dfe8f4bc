#include "protocol/wire/wire_mesh.hpp"

#include "protocol/wire/state_sum.hpp"

#include <limits>
#include <span>

namespace wakesurf::protocol {

static_assert(sizeof(LatticePoint) == 12 && sizeof(core::Cell) == 32,
              "summed as they lie in memory");

namespace {

/// Returns the sum of the 32 bit words of the values, which lie in memory without gaps.
template <class T>
std::uint32_t sum_of(const std::vector<T>& values) {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    return word_sum(std::span(reinterpret_cast<const std::uint32_t*>(values.data()),
                              values.size() * (sizeof(T) / sizeof(std::uint32_t))));
}

} // namespace

double AttributeRange::value(std::uint16_t code) const {
    if (gaps && code >= first_none)
        return std::numeric_limits<double>::quiet_NaN();
    return lo + (hi - lo) * code / last();
}

std::size_t WireMesh::bytes() const {
    std::size_t codes_bytes = 0;
    for (const auto& attribute : codes)
        codes_bytes += attribute.size() * sizeof(std::uint16_t);
    return (position.size() + change.size()) * sizeof(LatticePoint) + codes_bytes +
           topology->cells.size() * sizeof(core::Cell) +
           topology->neighbours.size() * sizeof(Neighbours);
}

std::uint32_t state_sum(const WireMesh& mesh) {
    std::vector<std::uint32_t> parts{
        static_cast<std::uint32_t>(mesh.vertices()), sum_of(mesh.position),
        static_cast<std::uint32_t>(mesh.cells().size()), sum_of(mesh.cells())};
    for (const auto& attribute : mesh.codes)
        parts.push_back(word_sum(std::span(attribute)));
    return sum_of(parts);
}

} // namespace wakesurf::protocol
