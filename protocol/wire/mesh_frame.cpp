#include "protocol/wire/mesh_frame.hpp"

#include "core/base/crc32c.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace wakesurf::protocol {

namespace {

using core::Error;

constexpr std::size_t frame_crc_at = 60;
constexpr std::size_t range_bytes = 8;

/// The header but for its own four bytes, then the body.
std::uint32_t frame_crc(std::span<const std::byte> bytes) {
    return core::crc32c(bytes.subspan(frame_header_bytes), core::crc32c(bytes.first(frame_crc_at)));
}

tl::unexpected<Error> corrupt(std::string message) {
    return core::fail(Error::Code::Corrupt, std::move(message), "subscribe to the surface again");
}

FrameHeader parse(std::span<const std::byte> b) {
    FrameHeader h;
    h.flags = number_at<std::uint8_t>(b, 3);
    h.surface = number_at<std::uint32_t>(b, 4);
    h.epoch = number_at<std::uint32_t>(b, 8);
    h.seq = number_at<std::uint32_t>(b, 12);
    h.base_seq = number_at<std::uint32_t>(b, 16);
    h.frame_index = number_at<std::uint16_t>(b, 20);
    h.frame_count = number_at<std::uint16_t>(b, 22);
    h.phase = static_cast<Phase>(number_at<std::uint8_t>(b, 24));
    h.lattice_bits = number_at<std::uint8_t>(b, 25);
    h.attribute_count = number_at<std::uint8_t>(b, 26);
    h.vertices = number_at<std::uint32_t>(b, 28);
    h.cells = number_at<std::uint32_t>(b, 32);
    h.topology_size = number_at<std::uint32_t>(b, 36);
    h.time = number_at<double>(b, 40);
    h.topology_bytes = number_at<std::uint32_t>(b, 48);
    h.points_bytes = number_at<std::uint32_t>(b, 52);
    h.state_sum = number_at<std::uint32_t>(b, 56);
    return h;
}

std::size_t ranges_in(const FrameHeader& h) {
    return h.is_key() && h.frame_index == 0 ? h.attribute_count : 0u;
}

core::Result<void> check_limits(const FrameHeader& h) {
    if (h.vertices > max_mesh_vertices || h.cells > max_mesh_cells ||
        h.attribute_count > max_attributes)
        return core::fail(Error::Code::OverLimit,
                          fmt::format("a mesh frame announces {} vertices, {} cells and {} "
                                      "attributes",
                                      h.vertices, h.cells, h.attribute_count));
    return {};
}

core::Result<void> check_consistency(const FrameHeader& h, std::span<const std::byte> bytes) {
    const std::uint64_t expected = frame_header_bytes + range_bytes * std::uint64_t{ranges_in(h)} +
                                   h.topology_bytes + h.points_bytes;
    if (bytes.size() != expected)
        return corrupt(
            fmt::format("a mesh frame of {} bytes announces {}", bytes.size(), expected));
    constexpr unsigned known = FrameHeader::key | FrameHeader::lossless | FrameHeader::history;
    const bool history = (h.flags & FrameHeader::history) != 0;
    if ((h.flags & ~known) != 0 || (history && !h.is_key()) || h.phase > Phase::Live ||
        number_at<std::uint8_t>(bytes, 27) != 0)
        return corrupt("a mesh frame has flags or a phase that this version does not know");
    const bool base_fits = h.is_key() ? h.base_seq == h.seq : h.base_seq < h.seq;
    if (h.frame_index >= h.frame_count || !base_fits || h.lattice_bits < 1 ||
        h.lattice_bits > max_lattice_bits || h.topology_bytes > h.topology_size ||
        !std::isfinite(h.time))
        return corrupt("a mesh frame's header contradicts itself");
    return {};
}

core::Result<void> check_ranges(std::span<const AttributeRange> ranges) {
    for (const AttributeRange& range : ranges)
        if (!std::isfinite(range.lo) || !std::isfinite(range.hi) || range.lo > range.hi)
            return corrupt("a mesh frame has an attribute without a range");
    return {};
}

void append_header(Bytes& bytes, const FrameHeader& h) {
    append(bytes, frame_magic);
    append(bytes, frame_version);
    append(bytes, h.flags);
    append(bytes, h.surface);
    append(bytes, h.epoch);
    append(bytes, h.seq);
    append(bytes, h.base_seq);
    append(bytes, h.frame_index);
    append(bytes, h.frame_count);
    append(bytes, static_cast<std::uint8_t>(h.phase));
    append(bytes, h.lattice_bits);
    append(bytes, h.attribute_count);
    append(bytes, std::uint8_t{0});
    append(bytes, h.vertices);
    append(bytes, h.cells);
    append(bytes, h.topology_size);
    append(bytes, h.time);
}

} // namespace

bool same_update(FrameHeader a, const FrameHeader& b) {
    a.frame_index = b.frame_index;
    a.topology_bytes = b.topology_bytes;
    a.points_bytes = b.points_bytes;
    return a == b;
}

Bytes write_frame(const MeshFrame& frame) {
    Bytes bytes;
    bytes.reserve(frame_header_bytes + range_bytes * frame.ranges.size() + frame.topology.size() +
                  frame.points.size());
    append_header(bytes, frame.header);
    append(bytes, static_cast<std::uint32_t>(frame.topology.size()));
    append(bytes, static_cast<std::uint32_t>(frame.points.size()));
    append(bytes, frame.header.state_sum);
    append(bytes, std::uint32_t{0});
    for (const AttributeRange& range : frame.ranges) {
        append(bytes, range.lo);
        append(bytes, range.hi);
    }
    bytes.insert(bytes.end(), frame.topology.begin(), frame.topology.end());
    bytes.insert(bytes.end(), frame.points.begin(), frame.points.end());
    const std::uint32_t crc = frame_crc(bytes);
    std::memcpy(bytes.data() + frame_crc_at, &crc, sizeof crc);
    return bytes;
}

core::Result<MeshFrame> read_frame(std::span<const std::byte> bytes) {
    if (bytes.size() > max_frame_bytes)
        return core::fail(Error::Code::OverLimit,
                          fmt::format("a mesh frame has {} bytes", bytes.size()));
    if (bytes.size() < 3 || number_at<std::uint16_t>(bytes, 0) != frame_magic)
        return corrupt("a binary message is not a mesh frame");
    if (const auto version = number_at<std::uint8_t>(bytes, 2); version != frame_version)
        return core::fail(
            Error::Code::Unsupported,
            fmt::format("a mesh frame has version {}, not {}", version, frame_version),
            "use a client of the server's version");
    if (bytes.size() < frame_header_bytes ||
        frame_crc(bytes) != number_at<std::uint32_t>(bytes, frame_crc_at))
        return corrupt("a mesh frame does not match its checksum");
    MeshFrame frame;
    frame.header = parse(bytes);
    if (auto fine = check_limits(frame.header).and_then([&] {
            return check_consistency(frame.header, bytes);
        });
        !fine)
        return tl::unexpected(fine.error());
    std::size_t at = frame_header_bytes;
    for (std::size_t i = 0; i < ranges_in(frame.header); ++i, at += range_bytes)
        frame.ranges.push_back({number_at<float>(bytes, at), number_at<float>(bytes, at + 4)});
    if (auto fine = check_ranges(frame.ranges); !fine)
        return tl::unexpected(fine.error());
    frame.topology = bytes.subspan(at, frame.header.topology_bytes);
    frame.points = bytes.subspan(at + frame.header.topology_bytes);
    return frame;
}

} // namespace wakesurf::protocol
