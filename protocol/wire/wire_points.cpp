#include "protocol/wire/wire_points.hpp"

#include "protocol/wire/bytes.hpp"
#include "protocol/wire/draco_points.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Error;

/// Larger residuals escape, lest Draco make tables for them.
constexpr std::int32_t draco_limit = 1 << 12;
/// A channel with no more residuals than these is not worth Draco's own header and table.
constexpr std::size_t few = 4;
constexpr std::uint32_t max_tolerance = 32767;

using Slice = Channel<const std::int32_t>;

/// Returns the position, the attributes, and the change of added vertices.
std::vector<Slice> slices_of(const Residuals& all, std::uint32_t begin, std::uint32_t end) {
    const auto slice = [&](const std::vector<std::int32_t>& values, std::size_t components) {
        return Slice{std::span(values).subspan(components * begin, components * (end - begin)),
                     components};
    };
    std::vector<Slice> slices{slice(all.position, 3)};
    for (const auto& codes : all.codes)
        slices.push_back(slice(codes, 1));
    if (all.coding.kind == PointKind::Added)
        slices.push_back(slice(all.change, 3));
    return slices;
}

std::vector<Channel<std::int32_t>> channels_of(Residuals& all) {
    std::vector<Channel<std::int32_t>> channels{{all.position, 3}};
    for (auto& codes : all.codes)
        channels.push_back({codes, 1});
    if (all.coding.kind == PointKind::Added)
        channels.push_back({all.change, 3});
    return channels;
}

/// Divides vertices into those that escape and the channels left for Draco.
struct Division {
    std::vector<std::uint32_t> escaped; ///< ascending
    std::uint32_t channels = 0;
};

void sort_unique(std::vector<std::uint32_t>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Says whether no vertex escapes, by sums that visit no single vertex: nearly always true.
bool all_for_draco(const Slice& slice) {
    static_assert((draco_limit & (draco_limit - 1)) == 0);
    std::int32_t bits = 0;
    std::size_t nonzero = 0;
    for (const std::int32_t value : slice.values) {
        bits |= std::abs(value);
        nonzero += value != 0 ? 1u : 0u;
    }
    return bits < draco_limit && nonzero > few * slice.components;
}

Division divide(std::span<const Slice> slices, std::uint32_t count) {
    Division division;
    for (std::size_t c = 0; c < slices.size(); ++c) {
        const auto [values, components] = slices[c];
        if (all_for_draco(slices[c])) {
            division.channels |= 1u << c;
            continue;
        }
        std::vector<std::uint32_t> large;
        std::vector<std::uint32_t> small;
        for (std::uint32_t i = 0; i < count; ++i) {
            std::int32_t size = 0;
            for (std::size_t k = 0; k < components; ++k)
                size |= std::abs(values[i * components + k]);
            if (size >= draco_limit)
                large.push_back(i);
            else if (size != 0 && small.size() <= few)
                small.push_back(i);
        }
        division.escaped.insert(division.escaped.end(), large.begin(), large.end());
        if (small.size() <= few)
            division.escaped.insert(division.escaped.end(), small.begin(), small.end());
        else
            division.channels |= 1u << c;
    }
    sort_unique(division.escaped);
    return division;
}

void append_escapes(std::vector<std::uint32_t>& numbers,
                    std::span<const Slice> slices,
                    std::span<const std::uint32_t> escaped) {
    numbers.push_back(static_cast<std::uint32_t>(escaped.size()));
    std::uint32_t at = 0;
    for (const std::uint32_t i : escaped) {
        numbers.push_back(i - at);
        for (const Slice& slice : slices)
            for (std::size_t k = 0; k < slice.components; ++k)
                numbers.push_back(
                    zigzag(static_cast<std::uint32_t>(slice.values[i * slice.components + k])));
        at = i + 1;
    }
}

core::Result<Bytes>
draco_block(std::span<const Slice> slices, const Division& division, std::uint32_t count) {
    std::vector<std::vector<std::int32_t>> cleared; // of what escapes
    cleared.reserve(slices.size());
    std::vector<Slice> coded;
    for (std::size_t c = 0; c < slices.size(); ++c) {
        if ((division.channels & (1u << c)) == 0)
            continue;
        coded.push_back(slices[c]);
        if (division.escaped.empty())
            continue;
        const auto [values, components] = slices[c];
        auto& copy = cleared.emplace_back(values.begin(), values.end());
        for (const std::uint32_t i : division.escaped)
            std::fill_n(copy.begin() + static_cast<std::ptrdiff_t>(i * components), components, 0);
        coded.back().values = copy;
    }
    return coded.empty() ? Bytes{} : encode_points(coded, count);
}

/// Holds pairs (vertex, its residuals).
struct Escapes {
    std::vector<std::uint32_t> vertex;
    std::vector<std::int32_t> residual;
};

Escapes read_escapes(Numbers& numbers, std::uint32_t count, std::size_t components) {
    Escapes escapes;
    std::uint32_t at = 0;
    for (std::uint32_t left = numbers.next(count); left > 0 && !numbers.failed(); --left) {
        if (at == count)
            numbers.take(numbers.left() + 1); // more escapes than vertices
        const std::uint32_t vertex = at + numbers.next(count - at - 1);
        escapes.vertex.push_back(vertex);
        for (std::size_t k = 0; k < components; ++k)
            escapes.residual.push_back(numbers.next_signed());
        at = vertex + 1;
    }
    return escapes;
}

void put_escapes(std::span<const Channel<std::int32_t>> channels, const Escapes& escapes) {
    auto source = escapes.residual.begin();
    for (const std::uint32_t v : escapes.vertex)
        for (const auto& [values, components] : channels)
            for (std::size_t k = 0; k < components; ++k)
                values[v * components + k] = *source++;
}

} // namespace

core::Result<PointBlock>
write_block(const Residuals& residuals, std::uint32_t begin, std::uint32_t end) {
    const PointCoding& coding = residuals.coding;
    const auto slices = slices_of(residuals, begin, end);
    const Division division = divide(slices, end - begin);
    auto draco = draco_block(slices, division, end - begin);
    if (!draco)
        return tl::unexpected(draco.error());
    std::vector<std::uint32_t> numbers{end - begin, division.channels};
    for (std::size_t c = 0; c <= coding.attributes; ++c) {
        numbers.push_back(coding.predictor[c]);
        numbers.push_back(coding.tolerance[c]);
    }
    append_escapes(numbers, slices, division.escaped);
    if (division.channels != 0)
        numbers.push_back(static_cast<std::uint32_t>(draco->size()));
    return PointBlock{std::move(numbers), std::move(*draco)};
}

core::Result<Residuals>
read_block(Numbers& numbers, std::span<const std::byte>& draco, const BlockPlace& place) {
    Residuals residuals;
    PointCoding& coding = residuals.coding;
    coding.kind = place.kind;
    coding.attributes = place.attributes;
    residuals.count = numbers.next(std::min(place.most, max_block_vertices));
    const bool added = place.kind == PointKind::Added;
    const std::uint32_t bits = numbers.next((2u << (place.attributes + (added ? 1u : 0u))) - 1u);
    for (std::size_t c = 0; c <= place.attributes; ++c) {
        const auto known = predictors_of_kind[static_cast<std::size_t>(place.kind)];
        coding.predictor[c] = static_cast<std::uint8_t>(numbers.next(known - 1u));
        coding.tolerance[c] = static_cast<std::uint16_t>(numbers.next(max_tolerance));
    }
    const std::size_t components = 3u + place.attributes + (added ? 3u : 0u);
    const Escapes escapes = read_escapes(numbers, residuals.count, components);
    const std::size_t size = bits == 0 ? 0u : numbers.next();
    if (numbers.failed() || residuals.count == 0 || size > draco.size())
        return corrupt("a block of points in a mesh update is damaged or too long");
    residuals.position.resize(3 * std::size_t{residuals.count});
    residuals.codes.assign(place.attributes, std::vector<std::int32_t>(residuals.count));
    residuals.change.resize(added ? residuals.position.size() : 0u);
    const auto channels = channels_of(residuals);
    std::vector<Channel<std::int32_t>> coded;
    for (std::size_t c = 0; c < channels.size(); ++c)
        if ((bits >> c & 1u) != 0)
            coded.push_back(channels[c]);
    if (!coded.empty())
        if (auto decoded = decode_points(draco.first(size), coded, residuals.count); !decoded)
            return tl::unexpected(decoded.error());
    put_escapes(channels, escapes);
    draco = draco.subspan(size);
    return residuals;
}

} // namespace wakesurf::protocol
