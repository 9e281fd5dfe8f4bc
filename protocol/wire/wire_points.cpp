#include "protocol/wire/wire_points.hpp"

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

tl::unexpected<Error> corrupt(const char* message) {
    return core::fail(Error::Code::Corrupt, message, "subscribe to the surface again");
}

std::size_t channels_of(const PointCoding& coding) {
    return std::size_t{1} + coding.attributes;
}

std::size_t components_of(std::size_t channel) {
    return channel == 0 ? 3 : 1;
}

using Slice = Channel<const std::int32_t>;

std::vector<Slice> slices_of(const Residuals& all, std::uint32_t begin, std::uint32_t end) {
    std::vector<Slice> slices{{std::span(all.position).subspan(3 * begin, 3 * (end - begin)), 3}};
    for (const auto& codes : all.codes)
        slices.push_back({std::span(codes).subspan(begin, end - begin), 1});
    return slices;
}

/// Which vertices escape, and which channels are left for Draco.
struct Division {
    std::vector<std::uint32_t> escaped; ///< ascending
    std::uint8_t channels = 0;
};

void sort_unique(std::vector<std::uint32_t>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Whether no vertex escapes, by sums that need no vertex looked at: nearly always so.
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
            division.channels = static_cast<std::uint8_t>(division.channels | (1u << c));
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
            division.channels = static_cast<std::uint8_t>(division.channels | (1u << c));
    }
    sort_unique(division.escaped);
    return division;
}

void append_signed(Bytes& bytes, std::int32_t value) {
    append_varint(bytes, zigzag(static_cast<std::uint32_t>(value)));
}

void append_escapes(Bytes& bytes,
                    std::span<const Slice> slices,
                    std::span<const std::uint32_t> escaped) {
    append_varint(bytes, static_cast<std::uint32_t>(escaped.size()));
    std::uint32_t at = 0;
    for (const std::uint32_t i : escaped) {
        append_varint(bytes, i - at);
        for (const Slice& slice : slices)
            for (std::size_t k = 0; k < slice.components; ++k)
                append_signed(bytes, slice.values[i * slice.components + k]);
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

/// Reads a block's numbers; once one does not fit, all that follow are 0.
class BlockReader {
  public:
    BlockReader(std::span<const std::byte> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    std::size_t at() const { return at_; }

    bool failed() const { return failed_; }

    std::uint8_t byte() {
        failed_ = failed_ || at_ == bytes_.size();
        return failed_ ? std::uint8_t{0} : std::to_integer<std::uint8_t>(bytes_[at_++]);
    }

    std::uint32_t number(std::uint32_t most) {
        const auto value = failed_ ? std::nullopt : take_varint(bytes_, at_);
        failed_ = !value || *value > most;
        return failed_ ? 0 : *value;
    }

    std::int32_t signed_number() {
        return static_cast<std::int32_t>(unzigzag(number(0xffffffffu)));
    }

    std::span<const std::byte> take(std::size_t count) {
        failed_ = failed_ || count > bytes_.size() - at_;
        if (failed_)
            return {};
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_;
    bool failed_ = false;
};

struct BlockHead {
    PointCoding coding;
    std::uint32_t count = 0;
    std::uint8_t channels = 0;
};

BlockHead read_head(BlockReader& in, std::uint8_t attributes, std::uint32_t most, bool& known) {
    BlockHead head;
    const std::uint8_t kind = in.byte();
    known = kind < predictors_of_kind.size();
    if (!known)
        return head;
    head.coding.kind = static_cast<PointKind>(kind);
    head.coding.attributes = head.coding.kind == PointKind::Change ? std::uint8_t{0} : attributes;
    head.count = in.number(most);
    head.channels = in.byte();
    const std::size_t channels = channels_of(head.coding);
    for (std::size_t c = 0; c < channels; ++c) {
        head.coding.predictor[c] = in.byte();
        known = known && head.coding.predictor[c] < predictors_of_kind[kind];
    }
    if (head.coding.kind != PointKind::Change)
        for (std::size_t c = 0; c < channels; ++c)
            head.coding.tolerance[c] = static_cast<std::uint16_t>(in.number(max_tolerance));
    known = known && (head.channels >> channels) == 0;
    return head;
}

/// (vertex, its residuals) one after the other.
struct Escapes {
    std::vector<std::uint32_t> vertex;
    std::vector<std::int32_t> residual;
};

Escapes read_escapes(BlockReader& in, std::uint32_t count, std::size_t components) {
    Escapes escapes;
    const std::uint32_t announced = in.number(count);
    std::uint32_t at = 0;
    for (std::uint32_t e = 0; e < announced && !in.failed() && at < count; ++e) {
        const std::uint32_t vertex = at + in.number(count - 1 - at);
        escapes.vertex.push_back(vertex);
        for (std::size_t k = 0; k < components; ++k)
            escapes.residual.push_back(in.signed_number());
        at = vertex + 1;
    }
    if (escapes.vertex.size() < announced)
        in.take(static_cast<std::size_t>(-1)); // more escapes than vertices
    return escapes;
}

std::span<std::int32_t> values_of(Residuals& residuals, std::size_t channel) {
    return channel == 0 ? std::span(residuals.position) : std::span(residuals.codes[channel - 1]);
}

void put_escapes(Residuals& residuals, const Escapes& escapes) {
    auto source = escapes.residual.begin();
    for (const std::uint32_t v : escapes.vertex)
        for (std::size_t c = 0; c < channels_of(residuals.coding); ++c)
            for (std::size_t k = 0; k < components_of(c); ++k)
                values_of(residuals, c)[v * components_of(c) + k] = *source++;
}

} // namespace

core::Result<Bytes>
write_block(const Residuals& residuals, std::uint32_t begin, std::uint32_t end) {
    const PointCoding& coding = residuals.coding;
    const auto slices = slices_of(residuals, begin, end);
    const Division division = divide(slices, end - begin);
    auto draco = draco_block(slices, division, end - begin);
    if (!draco)
        return draco;
    Bytes bytes;
    append(bytes, static_cast<std::uint8_t>(coding.kind));
    append_varint(bytes, end - begin);
    append(bytes, division.channels);
    for (std::size_t c = 0; c < channels_of(coding); ++c)
        append(bytes, coding.predictor[c]);
    if (coding.kind != PointKind::Change)
        for (std::size_t c = 0; c < channels_of(coding); ++c)
            append_varint(bytes, coding.tolerance[c]);
    append_escapes(bytes, slices, division.escaped);
    append_varint(bytes, static_cast<std::uint32_t>(draco->size()));
    bytes.insert(bytes.end(), draco->begin(), draco->end());
    return bytes;
}

core::Result<Residuals> read_block(std::span<const std::byte> bytes,
                                   std::size_t& at,
                                   std::uint8_t attributes,
                                   std::uint32_t most) {
    BlockReader in(bytes, at);
    bool known = false;
    const BlockHead head = read_head(in, attributes, most, known);
    if (!known || in.failed() || head.count == 0)
        return corrupt("a block of points in a mesh frame is of an unknown kind or too long");
    const Escapes escapes = read_escapes(in, head.count, 3u + head.coding.attributes);
    const auto draco = in.take(in.number(0xffffffffu));
    if (in.failed() || draco.empty() != (head.channels == 0))
        return corrupt("a block of points in a mesh frame is damaged");
    Residuals residuals{head.coding, head.count, std::vector<std::int32_t>(3 * head.count), {}};
    residuals.codes.assign(head.coding.attributes, std::vector<std::int32_t>(head.count));
    std::vector<Channel<std::int32_t>> coded;
    for (std::size_t c = 0; c < channels_of(head.coding); ++c)
        if ((head.channels & (1u << c)) != 0)
            coded.push_back({values_of(residuals, c), components_of(c)});
    if (!coded.empty())
        if (auto decoded = decode_points(draco, coded, head.count); !decoded)
            return tl::unexpected(decoded.error());
    put_escapes(residuals, escapes);
    at = in.at();
    return residuals;
}

} // namespace wakesurf::protocol
