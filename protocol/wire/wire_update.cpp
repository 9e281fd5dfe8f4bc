#include "protocol/wire/wire_update.hpp"

#include "protocol/wire/wire_points.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::uint32_t block_vertices = 1u << 15;
constexpr std::size_t part_budget = 480u << 10; ///< of a frame of at most 512 KiB, or of one block

struct Block {
    Bytes bytes;
    std::uint32_t vertices = 0;
};

struct Piece {
    const Residuals* residuals;
    std::uint32_t begin, end;
};

/// The residuals in pieces of about equal size.
std::vector<Piece> cut(std::span<const Residuals> points) {
    std::vector<Piece> pieces;
    for (const Residuals& residuals : points) {
        const std::uint32_t parts = (residuals.count + block_vertices - 1) / block_vertices;
        for (std::uint64_t i = 0; i < parts; ++i)
            pieces.push_back({&residuals, static_cast<std::uint32_t>(i * residuals.count / parts),
                              static_cast<std::uint32_t>((i + 1) * residuals.count / parts)});
    }
    return pieces;
}

/// In halves, and again, where nothing could be predicted.
core::Result<void> encode(const Piece& piece, std::vector<Block>& blocks) {
    auto bytes = write_block(*piece.residuals, piece.begin, piece.end);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (bytes->size() <= part_budget || piece.end - piece.begin == 1) {
        blocks.push_back({std::move(*bytes), piece.end - piece.begin});
        return {};
    }
    const std::uint32_t middle = piece.begin + (piece.end - piece.begin) / 2;
    return encode({piece.residuals, piece.begin, middle}, blocks).and_then([&] {
        return encode({piece.residuals, middle, piece.end}, blocks);
    });
}

core::Result<std::vector<Block>> encode_all(std::span<const Residuals> points) {
    const auto pieces = cut(points);
    std::vector<std::vector<Block>> encoded(pieces.size());
    std::vector<core::Result<void>> results(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(),
                      [&](std::size_t i) { results[i] = encode(pieces[i], encoded[i]); });
    std::vector<Block> all;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!results[i])
            return tl::unexpected(results[i].error());
        std::ranges::move(encoded[i], std::back_inserter(all));
    }
    return all;
}

/// What goes into one frame.
struct Parts {
    std::span<const std::byte> topology;
    Bytes points;
    std::uint32_t vertices = 0;
};

std::vector<Parts> pack(std::span<const std::byte> topology, std::span<const Block> blocks) {
    std::vector<Parts> frames(1);
    for (; topology.size() > part_budget; topology = topology.subspan(part_budget)) {
        frames.back().topology = topology.first(part_budget);
        frames.emplace_back();
    }
    frames.back().topology = topology;
    for (const Block& block : blocks) {
        const Parts& open = frames.back();
        const std::size_t size = open.topology.size() + open.points.size();
        if (size > 0 && (size + block.bytes.size() > part_budget ||
                         open.vertices + block.vertices > max_frame_vertices))
            frames.emplace_back();
        Parts& frame = frames.back();
        frame.points.insert(frame.points.end(), block.bytes.begin(), block.bytes.end());
        frame.vertices += block.vertices;
    }
    return frames;
}

} // namespace

core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::span<const AttributeRange> ranges,
                                        std::span<const std::byte> topology,
                                        std::span<const Residuals> points) {
    const auto blocks = encode_all(points);
    if (!blocks)
        return tl::unexpected(blocks.error());
    const auto parts = pack(topology, *blocks);
    if (parts.size() > std::numeric_limits<std::uint16_t>::max())
        return core::over_limit(std::numeric_limits<std::uint16_t>::max(),
                                "an update needs too many frames",
                                "ask for fewer quads or a larger separation");
    header.topology_size = static_cast<std::uint32_t>(topology.size());
    header.frame_count = static_cast<std::uint16_t>(parts.size());
    SharedFrames frames;
    for (const Parts& part : parts) {
        header.frame_index = static_cast<std::uint16_t>(frames.size());
        const auto own_ranges = frames.empty() ? ranges : std::span<const AttributeRange>{};
        frames.push_back(std::make_shared<const Bytes>(write_frame(
            {header, {own_ranges.begin(), own_ranges.end()}, part.topology, part.points})));
    }
    return frames;
}

} // namespace wakesurf::protocol
