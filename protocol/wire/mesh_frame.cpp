#include "protocol/wire/mesh_frame.hpp"

#include "protocol/wire/bytes.hpp"
#include "protocol/wire/lattice.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cmath>
#include <cstring>

namespace wakesurf::protocol {

namespace {

using core::Error;

FrameHeader parse(std::span<const std::byte> b) {
    FrameHeader h;
    h.flags = number_at<std::uint8_t>(b, 3);
    h.surface = number_at<std::uint32_t>(b, 4);
    h.epoch = number_at<std::uint32_t>(b, 8);
    h.seq = number_at<std::uint32_t>(b, 12);
    h.frame_index = number_at<std::uint16_t>(b, 16);
    h.frame_count = number_at<std::uint16_t>(b, 18);
    h.phase = static_cast<Phase>(number_at<std::uint8_t>(b, 20));
    h.lattice_bits = number_at<std::uint8_t>(b, 21);
    h.attribute_count = number_at<std::uint8_t>(b, 22);
    h.gaps = number_at<std::uint8_t>(b, 23);
    h.vertices = number_at<std::uint32_t>(b, 24);
    h.cells = number_at<std::uint32_t>(b, 28);
    h.time = number_at<double>(b, 32);
    h.state_sum = number_at<std::uint32_t>(b, 40);
    return h;
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

core::Result<void> check_consistency(const FrameHeader& h) {
    constexpr unsigned known = FrameHeader::key | FrameHeader::lossless;
    if ((h.flags & ~known) != 0 || h.phase > Phase::Live)
        return corrupt("a mesh frame has flags or a phase that this version does not know");
    if (h.frame_index >= h.frame_count || (!h.is_key() && h.seq == 0) || h.lattice_bits < 1 ||
        h.lattice_bits > max_lattice_bits || !std::isfinite(h.time) ||
        h.gaps >> h.attribute_count != 0)
        return corrupt("a mesh frame's header contradicts itself");
    return {};
}

void append_header(Bytes& bytes, const FrameHeader& h) {
    append(bytes, frame_magic);
    append(bytes, frame_version);
    append(bytes, h.flags);
    append(bytes, h.surface);
    append(bytes, h.epoch);
    append(bytes, h.seq);
    append(bytes, h.frame_index);
    append(bytes, h.frame_count);
    append(bytes, static_cast<std::uint8_t>(h.phase));
    append(bytes, h.lattice_bits);
    append(bytes, h.attribute_count);
    append(bytes, h.gaps);
    append(bytes, h.vertices);
    append(bytes, h.cells);
    append(bytes, h.time);
    append(bytes, h.state_sum);
}

} // namespace

bool same_update(FrameHeader a, const FrameHeader& b) {
    a.frame_index = b.frame_index;
    return a == b;
}

std::uint32_t frame_crc(std::span<const std::byte> frame) {
    const auto more = [](uLong crc, std::span<const std::byte> bytes) {
        return crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    };
    return static_cast<std::uint32_t>(
        more(more(0, frame.first(frame_crc_at)), frame.subspan(frame_header_bytes)));
}

Bytes write_frame(const MeshFrame& frame) {
    Bytes bytes;
    bytes.reserve(frame_header_bytes + frame.body.size());
    append_header(bytes, frame.header);
    append(bytes, std::uint32_t{0});
    bytes.insert(bytes.end(), frame.body.begin(), frame.body.end());
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
    const FrameHeader header = parse(bytes);
    return check_limits(header).and_then([&] { return check_consistency(header); }).map([&] {
        return MeshFrame{header, bytes.subspan(frame_header_bytes)};
    });
}

} // namespace wakesurf::protocol
