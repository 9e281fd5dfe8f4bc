#include "protocol/wire/mesh_decoder.hpp"

#include "protocol/wire/wire_draft.hpp"
#include "protocol/wire/wire_edit.hpp"
#include "protocol/wire/wire_points.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Error;

tl::unexpected<Error> corrupt(std::string message) {
    return core::fail(Error::Code::Corrupt, std::move(message), "subscribe to the surface again");
}

std::vector<std::uint32_t> numbers_from(std::uint32_t first, std::uint32_t last) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t v = first; v < last; ++v)
        all.push_back(v);
    return all;
}

} // namespace

/// The frames of an update so far.
struct MeshDecoder::Update {
    FrameHeader header; ///< of the newest frame
    WireMesh before;    ///< of a KEY: nothing, else the state it starts from
    Bytes topology;
    WireDraft draft; ///< once the topology is whole
    bool drafted = false;
    /// Vertices to come of each kind, and how many of them have.
    std::array<std::vector<std::uint32_t>, 3> coded;
    std::array<std::size_t, 3> done{};

    core::Result<void> take(const MeshFrame& frame);
    core::Result<void> begin();
    core::Result<void> take_points(std::span<const std::byte> points);
    bool all_points_in() const;
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
        h.base_seq != newest_->header.seq || h.lattice_bits != newest_->mesh->lattice_bits ||
        h.attribute_count != newest_->mesh->codes.size())
        return corrupt(fmt::format("epoch {} update {} does not start from the state there is",
                                   h.epoch, h.seq));
    return {};
}

core::Result<bool> MeshDecoder::take(const MeshFrame& frame) {
    const FrameHeader& h = frame.header;
    if (h.frame_index == 0) {
        update_ = std::make_unique<Update>();
        if (h.is_key()) {
            update_->before.lattice_bits = h.lattice_bits;
            update_->before.ranges = frame.ranges;
            update_->before.codes.resize(h.attribute_count);
        } else {
            update_->before = *newest_->mesh;
        }
    }
    if (auto taken = update_->take(frame); !taken)
        return tl::unexpected(taken.error());
    if (h.frame_index + 1 < h.frame_count)
        return false;
    const std::unique_ptr<Update> whole = std::move(update_);
    if (!whole->drafted || !whole->all_points_in())
        return corrupt("a mesh update ended before all of it was there");
    WireMesh& mesh = whole->draft.after;
    mesh.time = h.time;
    if ((h.flags & FrameHeader::history) == 0)
        finish_changes(whole->draft);
    if (state_sum(mesh) != h.state_sum)
        return corrupt("the mesh does not match the server's checksum");
    newest_ = DecodedState{h, std::make_shared<const WireMesh>(std::move(mesh))};
    intact_ = true;
    return true;
}

core::Result<void> MeshDecoder::Update::take(const MeshFrame& frame) {
    header = frame.header;
    topology.insert(topology.end(), frame.topology.begin(), frame.topology.end());
    if (topology.size() > header.topology_size)
        return corrupt("a mesh update has more topology than it announced");
    if (!drafted && topology.size() == header.topology_size)
        if (auto begun = begin(); !begun)
            return begun;
    if (!drafted && !frame.points.empty())
        return corrupt("points of a mesh update came before its topology was whole");
    return take_points(frame.points);
}

core::Result<void> MeshDecoder::Update::begin() {
    const MeshSize after{header.vertices, header.cells};
    auto read =
        read_edit(topology, {static_cast<std::uint32_t>(before.vertices()), before.cells()}, after);
    if (!read)
        return tl::unexpected(read.error());
    const TopologyEdit& edit = read->edit;
    if (edit.moved_vertices.count() + std::uint64_t{edit.added_vertices} >
        std::uint64_t{max_frame_vertices} * header.frame_count)
        return corrupt("a mesh update announces more vertices than its frames can hold");
    auto shared = before.topology;
    if (!edit.keeps_topology()) {
        auto cells = edited_cells(std::move(read->kept.cells), edit);
        shared = std::make_shared<const WireTopology>(*before.topology, read->kept, edit,
                                                      std::move(cells), after.vertices);
    }
    draft = begin_draft(before, edit, std::move(shared));
    for (const Run& run : edit.moved_vertices.all())
        for (std::uint32_t v = run.begin; v < run.end; ++v)
            coded[0].push_back(v);
    coded[1] = numbers_from(draft.stay, draft.vertices());
    if ((header.flags & FrameHeader::history) != 0)
        coded[2] = coded[1];
    drafted = true;
    return {};
}

core::Result<void> MeshDecoder::Update::take_points(std::span<const std::byte> points) {
    std::uint32_t left_in_frame = max_frame_vertices;
    for (std::size_t at = 0; at < points.size();) {
        auto block = read_block(points, at, header.attribute_count, left_in_frame);
        if (!block)
            return tl::unexpected(block.error());
        const auto kind = static_cast<std::size_t>(block->coding.kind);
        for (std::size_t earlier = 0; earlier < kind; ++earlier)
            if (done[earlier] < coded[earlier].size())
                return corrupt("the points of a mesh update are out of order");
        if (block->count > coded[kind].size() - done[kind])
            return corrupt("a mesh update has more points than its topology says");
        apply_residuals(draft, *block, std::span(coded[kind]).subspan(done[kind], block->count));
        done[kind] += block->count;
        left_in_frame -= block->count;
    }
    return {};
}

bool MeshDecoder::Update::all_points_in() const {
    for (std::size_t kind = 0; kind < coded.size(); ++kind)
        if (done[kind] < coded[kind].size())
            return false;
    return true;
}

} // namespace wakesurf::protocol
