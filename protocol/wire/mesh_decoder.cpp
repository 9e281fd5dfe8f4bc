#include "protocol/wire/mesh_decoder.hpp"

#include "protocol/wire/bytes.hpp"
#include "protocol/wire/wire_edit.hpp"
#include "protocol/wire/wire_points.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

namespace {

using core::Error;

bool has_gaps(const FrameHeader& header, std::size_t attribute) {
    return (header.gaps >> attribute & 1U) != 0;
}

core::Result<std::vector<AttributeRange>> read_ranges(Numbers& numbers, const FrameHeader& header) {
    const std::size_t count = header.attribute_count;
    const auto halves = numbers.take(4 * count);
    const auto end_at = [&](std::size_t i) {
        return std::bit_cast<double>(std::uint64_t{halves[i]} | std::uint64_t{halves[i + 1]} << 32);
    };
    std::vector<AttributeRange> ranges;
    for (std::size_t i = 0; i + 3 < halves.size(); i += 4)
        ranges.push_back({end_at(i), end_at(i + 2), has_gaps(header, ranges.size())});
    for (const AttributeRange& range : ranges)
        if (!std::isfinite(range.lo) || !std::isfinite(range.hi) || range.lo > range.hi)
            return corrupt("a mesh update has an attribute without a range");
    if (ranges.size() < count)
        return corrupt("a mesh update ends within its ranges");
    return ranges;
}

/// Reads the points of moved vertices, then those of added ones.
core::Result<void> read_points(Numbers& numbers,
                               std::span<const std::byte> draco,
                               const TopologyEdit& edit,
                               WireDraft& draft) {
    std::array<std::vector<std::uint32_t>, 2> coded;
    for (const Run& run : edit.moved_vertices.all())
        for (std::uint32_t v = run.begin; v < run.end; ++v)
            coded[0].push_back(v);
    for (std::uint32_t v = draft.stay; v < draft.vertices(); ++v)
        coded[1].push_back(v);
    const auto attributes = static_cast<std::uint8_t>(draft.after.codes.size());
    for (const PointKind kind : {PointKind::Moved, PointKind::Added})
        for (std::span<const std::uint32_t> left = coded[static_cast<std::size_t>(kind)];
             !left.empty();) {
            const auto most = static_cast<std::uint32_t>(left.size());
            const auto block = read_block(numbers, draco, {kind, attributes, most});
            if (!block)
                return tl::unexpected(block.error());
            apply_residuals(draft, *block, left.first(block->count));
            left = left.subspan(block->count);
        }
    if (numbers.left() > 0 || !draco.empty())
        return corrupt("a mesh update goes on after its last vertex");
    return {};
}

/// Returns the state after an update of which all bytes have arrived.
core::Result<WireMesh>
decoded(const FrameHeader& header, std::span<const std::byte> bytes, WireMesh before) {
    auto numbers = unpack_numbers(bytes);
    if (!numbers)
        return tl::unexpected(numbers.error());
    if (header.is_key()) {
        auto ranges = read_ranges(*numbers, header);
        if (!ranges)
            return tl::unexpected(ranges.error());
        before = {};
        before.lattice_bits = header.lattice_bits;
        before.ranges = std::move(*ranges);
        before.codes.resize(header.attribute_count);
    }
    for (std::size_t a = 0; a < before.ranges.size(); ++a)
        if (before.ranges[a].gaps != has_gaps(header, a))
            return corrupt("a mesh update has other gaps than the one before");
    const auto vertices = static_cast<std::uint32_t>(before.vertices());
    auto read = read_edit(*numbers, {vertices, before.cells()}, {header.vertices, header.cells});
    if (!read)
        return tl::unexpected(read.error());
    const TopologyEdit& edit = read->edit;
    if (edit.moved_vertices.count() + std::uint64_t{edit.added_vertices} >
        std::uint64_t{max_block_vertices} * header.frame_count)
        return corrupt("a mesh update announces more vertices than its frames may hold");
    auto topology = before.topology;
    if (!edit.keeps_topology())
        topology = std::make_shared<const WireTopology>(
            edit.only_adds() ? *before.topology : WireTopology(),
            edited_cells(std::move(read->kept), edit), header.vertices);
    WireDraft draft = begin_draft(before, edit, std::move(topology));
    if (auto points = read_points(*numbers, bytes, edit, draft); !points)
        return tl::unexpected(points.error());
    draft.after.time = header.time;
    if (state_sum(draft.after) != header.state_sum)
        return corrupt("the mesh does not match the server's checksum");
    return std::move(draft.after);
}

} // namespace

/// Holds the frames of an update that have arrived.
struct MeshDecoder::Update {
    FrameHeader header; ///< of the newest frame
    Bytes bytes;        ///< of all
};

MeshDecoder::MeshDecoder() = default;
MeshDecoder::~MeshDecoder() = default;
MeshDecoder::MeshDecoder(MeshDecoder&&) noexcept = default;
MeshDecoder& MeshDecoder::operator=(MeshDecoder&&) noexcept = default;

core::Result<bool> MeshDecoder::fold(std::span<const std::byte> bytes) {
    auto result = read_frame(bytes).and_then([&](const MeshFrame& frame) {
        return check_order(frame.header).and_then([&] { return take(frame); });
    });
    if (!result) {
        update_.reset();
        intact_ = false;
    }
    return result;
}

core::Result<void> MeshDecoder::check_order(const FrameHeader& h) const {
    if (newest_ && h.surface != newest_->header.surface)
        return corrupt(fmt::format("a frame of surface {} came to surface {}", h.surface,
                                   newest_->header.surface));
    if (h.frame_index > 0) {
        if (!update_ || h.frame_index != update_->header.frame_index + 1 ||
            !same_update(update_->header, h))
            return corrupt(
                fmt::format("epoch {} update {} frame {} does not follow the frame before", h.epoch,
                            h.seq, h.frame_index));
        return {};
    }
    if (h.is_key()) {
        if (newest_ && (h.epoch < newest_->header.epoch ||
                        (h.epoch == newest_->header.epoch && h.seq < newest_->header.seq)))
            return corrupt(fmt::format("epoch {} update {} came after epoch {} update {}", h.epoch,
                                       h.seq, newest_->header.epoch, newest_->header.seq));
        return {};
    }
    if (!intact_ || update_ || !newest_ || h.epoch != newest_->header.epoch ||
        h.seq != newest_->header.seq + 1 || h.lattice_bits != newest_->mesh->lattice_bits ||
        h.attribute_count != newest_->mesh->codes.size())
        return corrupt(fmt::format("epoch {} update {} does not start from the current state",
                                   h.epoch, h.seq));
    return {};
}

core::Result<bool> MeshDecoder::take(const MeshFrame& frame) {
    const FrameHeader& h = frame.header;
    if (h.frame_index == 0)
        update_ = std::make_unique<Update>();
    update_->header = h;
    update_->bytes.insert(update_->bytes.end(), frame.body.begin(), frame.body.end());
    if (h.frame_index + 1 < h.frame_count)
        return false;
    const std::unique_ptr<Update> whole = std::move(update_);
    auto mesh = decoded(h, whole->bytes, h.is_key() ? WireMesh() : *newest_->mesh);
    if (!mesh)
        return tl::unexpected(mesh.error());
    newest_ = DecodedState{h, std::make_shared<const WireMesh>(std::move(*mesh))};
    intact_ = true;
    return true;
}

} // namespace wakesurf::protocol
