#include "protocol/wire/wire_update.hpp"

#include "protocol/wire/wire_points.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::uint32_t block_vertices = 1u << 15;
constexpr std::size_t body_budget = (512u << 10) - frame_header_bytes; ///< of a frame

struct Piece {
    const Residuals* residuals;
    std::uint32_t begin, end;
};

/// Cuts the residuals into pieces of about equal size.
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

core::Result<std::vector<PointBlock>> encode_all(std::span<const Residuals> points) {
    const auto pieces = cut(points);
    std::vector<core::Result<PointBlock>> results(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        results[i] = write_block(*pieces[i].residuals, pieces[i].begin, pieces[i].end);
    });
    std::vector<PointBlock> blocks;
    for (auto& result : results) {
        if (!result)
            return tl::unexpected(result.error());
        blocks.push_back(std::move(*result));
    }
    return blocks;
}

/// Returns the bytes of an update, before they are cut into frames.
core::Result<Bytes> whole_update(std::vector<std::uint32_t> numbers,
                                 std::span<const Residuals> points) {
    return encode_all(points).and_then([&](const std::vector<PointBlock>& blocks) {
        for (const PointBlock& block : blocks)
            numbers.insert(numbers.end(), block.numbers.begin(), block.numbers.end());
        return pack_numbers(numbers).map([&](Bytes bytes) {
            for (const PointBlock& block : blocks)
                bytes.insert(bytes.end(), block.draco.begin(), block.draco.end());
            return bytes;
        });
    });
}

/// Returns the number of frames for so many bytes, but not fewer than readers demand for so many vertices.
std::size_t frames_for(std::size_t bytes, std::span<const Residuals> points) {
    std::size_t vertices = 0;
    for (const Residuals& residuals : points)
        vertices += residuals.count;
    return std::max({(bytes + body_budget - 1) / body_budget,
                     (vertices + max_block_vertices - 1) / max_block_vertices, std::size_t{1}});
}

} // namespace

core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::vector<std::uint32_t> numbers,
                                        std::span<const Residuals> points) {
    const auto update = whole_update(std::move(numbers), points);
    if (!update)
        return tl::unexpected(update.error());
    const std::size_t count = frames_for(update->size(), points);
    if (count > std::numeric_limits<std::uint16_t>::max())
        return core::over_limit(std::numeric_limits<std::uint16_t>::max(),
                                "an update needs too many frames",
                                "ask for fewer quads or a larger separation");
    header.frame_count = static_cast<std::uint16_t>(count);
    SharedFrames frames;
    for (std::size_t i = 0; i < count; ++i) {
        header.frame_index = static_cast<std::uint16_t>(i);
        const std::size_t begin = i * update->size() / count;
        const std::size_t end = (i + 1) * update->size() / count;
        frames.push_back(std::make_shared<const Bytes>(
            write_frame({header, std::span(*update).subspan(begin, end - begin)})));
    }
    return frames;
}

} // namespace wakesurf::protocol
