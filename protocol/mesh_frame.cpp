#include "protocol/mesh_frame.hpp"

#include "core/base/crc32c.hpp"
#include "protocol/lattice.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wakesurf::protocol {

namespace {

using core::Error;

constexpr std::size_t frame_crc_at = 48;
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
    h.vertex_base = number_at<std::uint32_t>(b, 16);
    h.vertex_count = number_at<std::uint32_t>(b, 20);
    h.cell_base = number_at<std::uint32_t>(b, 24);
    h.cell_count = number_at<std::uint32_t>(b, 28);
    h.attribute_count = number_at<std::uint8_t>(b, 32);
    h.lattice_bits = number_at<std::uint8_t>(b, 33);
    h.draco_bytes = number_at<std::uint32_t>(b, 36);
    h.cell_bytes = number_at<std::uint32_t>(b, 40);
    h.state_crc = number_at<std::uint32_t>(b, 44);
    return h;
}

/// Counts that memory is reserved for, or that later sums could overflow with.
core::Result<void> check_limits(const FrameHeader& h) {
    if (h.vertex_count > max_frame_vertices || h.cell_count > max_frame_cells ||
        h.vertex_base > max_mesh_vertices - h.vertex_count ||
        h.cell_base > max_mesh_cells - h.cell_count || h.attribute_count > max_attributes)
        return core::fail(
            Error::Code::OverLimit,
            fmt::format("a mesh frame announces {} vertices after {}, {} cells after {} "
                        "and {} attributes",
                        h.vertex_count, h.vertex_base, h.cell_count, h.cell_base,
                        h.attribute_count));
    return {};
}

core::Result<void> check_consistency(const FrameHeader& h, std::size_t size) {
    const std::uint64_t expected = frame_header_bytes +
                                   range_bytes * std::uint64_t{h.attribute_count} + h.draco_bytes +
                                   h.cell_bytes;
    if (size != expected)
        return corrupt(fmt::format("a mesh frame of {} bytes announces {}", size, expected));
    if (h.lattice_bits < 1 || h.lattice_bits > max_lattice_bits)
        return corrupt(fmt::format("a mesh frame has a lattice of {} bits", h.lattice_bits));
    if ((h.flags & ~(FrameHeader::first | FrameHeader::last | FrameHeader::final)) != 0)
        return corrupt(fmt::format("a mesh frame has unknown flags {:#x}", h.flags));
    if ((h.vertex_count == 0) != (h.draco_bytes == 0) || (h.cell_count == 0) != (h.cell_bytes == 0))
        return corrupt("a mesh frame announces vertices or cells without bytes for them");
    if ((h.flags & FrameHeader::first) != 0 && (h.vertex_base != 0 || h.cell_base != 0))
        return corrupt("the first frame of a mesh does not start at vertex 0 and cell 0");
    return {};
}

core::Result<void> check_ranges(std::span<const AttributeRange> ranges) {
    for (const AttributeRange& range : ranges)
        if (!std::isfinite(range.lo) || !std::isfinite(range.hi) || range.lo > range.hi)
            return corrupt("a mesh frame has an attribute without a usable range");
    return {};
}

} // namespace

double AttributeRange::value(std::uint16_t code) const {
    return double{lo} + (double{hi} - double{lo}) * code / 65535.0;
}

Bytes write_frame(const MeshFrame& frame) {
    const FrameHeader& h = frame.header;
    Bytes bytes;
    bytes.reserve(frame_header_bytes + range_bytes * frame.ranges.size() + frame.draco.size() +
                  frame.cells.size());
    append(bytes, frame_magic);
    append(bytes, frame_version);
    append(bytes, h.flags);
    for (const std::uint32_t field :
         {h.surface, h.epoch, h.seq, h.vertex_base, h.vertex_count, h.cell_base, h.cell_count})
        append(bytes, field);
    append(bytes, static_cast<std::uint8_t>(frame.ranges.size()));
    append(bytes, h.lattice_bits);
    append(bytes, std::uint16_t{0});
    append(bytes, static_cast<std::uint32_t>(frame.draco.size()));
    append(bytes, static_cast<std::uint32_t>(frame.cells.size()));
    append(bytes, h.state_crc);
    append(bytes, std::uint32_t{0});
    for (const AttributeRange& range : frame.ranges) {
        append(bytes, range.lo);
        append(bytes, range.hi);
    }
    bytes.insert(bytes.end(), frame.draco.begin(), frame.draco.end());
    bytes.insert(bytes.end(), frame.cells.begin(), frame.cells.end());
    const std::uint32_t crc = frame_crc(bytes);
    std::memcpy(bytes.data() + frame_crc_at, &crc, sizeof crc);
    return bytes;
}

core::Result<MeshFrame> read_frame(std::span<const std::byte> bytes) {
    if (bytes.size() > max_frame_bytes)
        return core::fail(Error::Code::OverLimit,
                          fmt::format("a mesh frame has {} bytes", bytes.size()));
    if (bytes.size() < frame_header_bytes || number_at<std::uint16_t>(bytes, 0) != frame_magic)
        return corrupt("a binary message is not a mesh frame");
    if (const auto version = number_at<std::uint8_t>(bytes, 2); version != frame_version)
        return core::fail(
            Error::Code::Unsupported,
            fmt::format("a mesh frame has version {}, not {}", version, frame_version),
            "use a client of the server's version");
    if (frame_crc(bytes) != number_at<std::uint32_t>(bytes, frame_crc_at))
        return corrupt("a mesh frame does not match its checksum");
    MeshFrame frame;
    frame.header = parse(bytes);
    if (auto fine = check_limits(frame.header); !fine)
        return tl::unexpected(fine.error());
    if (auto fine = check_consistency(frame.header, bytes.size()); !fine)
        return tl::unexpected(fine.error());
    std::size_t at = frame_header_bytes;
    for (unsigned i = 0; i < frame.header.attribute_count; ++i, at += range_bytes)
        frame.ranges.push_back({number_at<float>(bytes, at), number_at<float>(bytes, at + 4)});
    if (auto fine = check_ranges(frame.ranges); !fine)
        return tl::unexpected(fine.error());
    frame.draco = bytes.subspan(at, frame.header.draco_bytes);
    frame.cells = bytes.subspan(at + frame.header.draco_bytes);
    return frame;
}

} // namespace wakesurf::protocol
