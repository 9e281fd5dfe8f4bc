#include "protocol/mesh_decoder.hpp"

#include "protocol/cells_code.hpp"
#include "protocol/draco_points.hpp"

#include <fmt/format.h>

namespace wakesurf::protocol {

namespace {

using core::Error;

tl::unexpected<Error> corrupt(std::string message) {
    return core::fail(Error::Code::Corrupt, std::move(message), "subscribe to the surface again");
}

} // namespace

core::Result<void> MeshDecoder::fold(std::span<const std::byte> bytes) {
    const auto frame = read_frame(bytes);
    if (!frame) {
        intact_ = false;
        return tl::unexpected(frame.error());
    }
    auto result = check_order(*frame).and_then([&] { return append(*frame); });
    intact_ = result.has_value();
    return result;
}

core::Result<void> MeshDecoder::check_order(const MeshFrame& frame) const {
    const FrameHeader& h = frame.header;
    const bool first = (h.flags & FrameHeader::first) != 0;
    if (started_ && h.surface != mesh_.surface)
        return corrupt(
            fmt::format("a frame of surface {} came to surface {}", h.surface, mesh_.surface));
    if (first) {
        if (started_ && (h.epoch < mesh_.epoch || (h.epoch == mesh_.epoch && h.seq <= mesh_.seq)))
            return corrupt(fmt::format("epoch {} frame {} came after epoch {} frame {}", h.epoch,
                                       h.seq, mesh_.epoch, mesh_.seq));
        return {};
    }
    if (!intact_ || mesh_.complete || h.epoch != mesh_.epoch || h.seq != mesh_.seq + 1 ||
        h.vertex_base != mesh_.position.size() || h.cell_base != mesh_.cells.size() ||
        h.lattice_bits != mesh_.lattice_bits || frame.ranges.size() != mesh_.attributes.size())
        return corrupt(
            fmt::format("epoch {} frame {} does not continue the mesh so far", h.epoch, h.seq));
    for (std::size_t i = 0; i < frame.ranges.size(); ++i)
        if (frame.ranges[i] != mesh_.attributes[i].range)
            return corrupt("an attribute's range changed within a mesh");
    return {};
}

core::Result<void> MeshDecoder::append(const MeshFrame& frame) {
    const FrameHeader& h = frame.header;
    if ((h.flags & FrameHeader::first) != 0) {
        mesh_ = {};
        crc_ = {};
        started_ = true;
        mesh_.surface = h.surface;
        mesh_.epoch = h.epoch;
        mesh_.lattice_bits = h.lattice_bits;
        for (const AttributeRange& range : frame.ranges)
            mesh_.attributes.push_back({range, {}});
    }
    mesh_.seq = h.seq;
    const std::size_t vertices = h.vertex_base + h.vertex_count;
    mesh_.position.resize(vertices);
    const auto added = std::span(mesh_.position).subspan(h.vertex_base);
    std::vector<std::span<std::uint16_t>> codes;
    for (WireAttribute& attribute : mesh_.attributes) {
        attribute.code.resize(vertices);
        codes.push_back(std::span(attribute.code).subspan(h.vertex_base));
    }
    if (h.vertex_count > 0)
        if (auto points = decode_points(frame.draco, added, codes); !points)
            return points;
    const std::int32_t last = (std::int32_t{1} << h.lattice_bits) - 1;
    for (const LatticePoint& node : added)
        for (const std::int32_t coordinate : node)
            if (coordinate < 0 || coordinate > last)
                return corrupt("a mesh frame has a vertex outside its lattice");
    if (auto cells = decode_cells(frame.cells, h.cell_count, static_cast<std::uint32_t>(vertices),
                                  mesh_.cells);
        !cells)
        return cells;
    crc_.add(added);
    crc_.add(std::span(mesh_.cells).subspan(h.cell_base));
    if (crc_.value() != h.state_crc)
        return corrupt("the mesh does not match the server's checksum");
    mesh_.state_crc = h.state_crc;
    mesh_.complete = (h.flags & FrameHeader::last) != 0;
    mesh_.final = mesh_.complete && (h.flags & FrameHeader::final) != 0;
    return {};
}

} // namespace wakesurf::protocol
