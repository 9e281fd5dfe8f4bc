#include "protocol/wire/wire_quantise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace wakesurf::protocol {

namespace {

struct Ends {
    double lo, hi;
};

/// Returns the ends in four lanes, because one comparison waits for the one before. REQUIRES: some values.
Ends ends_of(std::span<const double> values) {
    std::array<double, 4> lo{}, hi{};
    lo.fill(values.front());
    hi.fill(values.front());
    for (std::size_t at = 0; at + 4 <= values.size(); at += 4)
        for (std::size_t lane = 0; lane < 4; ++lane) {
            lo[lane] = std::min(lo[lane], values[at + lane]);
            hi[lane] = std::max(hi[lane], values[at + lane]);
        }
    for (const double value : values.last(values.size() % 4)) {
        lo[0] = std::min(lo[0], value);
        hi[0] = std::max(hi[0], value);
    }
    return {std::ranges::min(lo), std::ranges::max(hi)};
}

bool is_none(double value) {
    return !std::isfinite(value);
}

AttributeRange range_for(std::span<const double> values, const AttributeRange* held) {
    if (values.empty())
        return held != nullptr ? *held : AttributeRange{};
    if (std::ranges::any_of(values, is_none)) {
        std::vector<double> some;
        std::ranges::remove_copy_if(values, std::back_inserter(some), is_none);
        AttributeRange range = range_for(some, held);
        range.gaps = true;
        return range;
    }
    const auto [lo, hi] = ends_of(values);
    if (held == nullptr)
        return {lo, hi};
    AttributeRange range = *held;
    const double width = std::max(hi, held->hi) - std::min(lo, held->lo);
    if (lo < held->lo)
        range.lo = lo - 0.5 * width;
    if (hi > held->hi)
        range.hi = hi + 0.5 * width;
    return std::isfinite(range.lo) && std::isfinite(range.hi) ? range
                                                              : AttributeRange{lo, hi, held->gaps};
}

} // namespace

AttributeValues::AttributeValues(const core::QuadComplex& mesh, const MeshFields& fields) {
    own_.reserve(1 + fields.size());
    auto& speed = own_.emplace_back(mesh.vertices());
    for (std::size_t i = 0; i < speed.size(); ++i)
        speed[i] = glm::length(core::Vec3(mesh.velocity[i]));
    for (const auto& field : fields) {
        auto& values = own_.emplace_back(field.begin(), field.end());
        std::ranges::replace_if(values, is_none, std::numeric_limits<double>::quiet_NaN());
    }
    all_ = {own_.front(), mesh.s, mesh.t};
    all_.insert(all_.end(), own_.begin() + 1, own_.end());
}

std::vector<AttributeRange> ranges_for(const AttributeValues& values,
                                       std::span<const AttributeRange> held) {
    std::vector<AttributeRange> ranges;
    for (const auto each : values.all())
        ranges.push_back(range_for(each, held.empty() ? nullptr : &held[ranges.size()]));
    return ranges;
}

WireMesh quantise_mesh(const core::QuadComplex& mesh,
                       const Lattice& lattice,
                       const AttributeValues& values,
                       std::span<const AttributeRange> ranges,
                       std::span<const std::uint32_t> place) {
    WireMesh result;
    result.lattice_bits = lattice.bits;
    result.ranges.assign(ranges.begin(), ranges.end());
    result.position.resize(place.size());
    const LatticeRounding rounding(lattice);
    for (std::size_t i = 0; i < place.size(); ++i)
        result.position[place[i]] = rounding.nearest(mesh.position[i]);
    for (std::size_t a = 0; a < ranges.size(); ++a) {
        auto& codes = result.codes.emplace_back(place.size());
        const auto all = values.all()[a];
        const AttributeRange range = ranges[a];
        const double scale = range.scale();
        for (std::size_t i = 0; i < place.size(); ++i)
            codes[place[i]] = range.code(all[i], scale);
    }
    return result;
}

} // namespace wakesurf::protocol
