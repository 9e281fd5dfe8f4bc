#include "protocol/mesh_encoder.hpp"

#include "protocol/cells_code.hpp"
#include "protocol/draco_points.hpp"
#include "protocol/mesh_frame.hpp"
#include "protocol/mesh_guard.hpp"
#include "protocol/state_crc.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

namespace wakesurf::protocol {

namespace {

// Points cost 12.5 bytes at the very worst, so a frame stays below 512 KiB.
constexpr std::size_t chunk_vertices = 1u << 15;
constexpr std::size_t cell_budget = 96u << 10;

/// A mesh in wire units, its cells in the order of the frames that can first draw them.
struct Quantised {
    std::vector<LatticePoint> position;
    std::vector<AttributeRange> ranges;
    std::vector<std::vector<std::uint16_t>> attributes;
    std::vector<core::Cell> cells;
    std::vector<std::size_t> cells_end; ///< for each chunk of vertices, one past its last cell
};

struct CellBlock {
    Bytes code;
    std::uint32_t count = 0;
};

struct Chunk {
    core::Result<Bytes> points;
    std::vector<CellBlock> cells; ///< at least one, perhaps empty
};

void add_attribute(Quantised& mesh, std::span<const double> values) {
    const auto [lo, hi] = std::ranges::minmax(values);
    const AttributeRange range{static_cast<float>(lo), static_cast<float>(hi)};
    const double scale =
        range.hi > range.lo ? 65535.0 / (double{range.hi} - double{range.lo}) : 0.0;
    std::vector<std::uint16_t> codes;
    codes.reserve(values.size());
    for (const double value : values)
        codes.push_back(static_cast<std::uint16_t>(
            std::clamp((value - double{range.lo}) * scale + 0.5, 0.0, 65535.0)));
    mesh.ranges.push_back(range);
    mesh.attributes.push_back(std::move(codes));
}

void add_attributes(Quantised& result, const core::QuadComplex& mesh) {
    std::vector<double> speed;
    speed.reserve(mesh.vertices());
    for (const core::Vec3f& velocity : mesh.velocity)
        speed.push_back(glm::length(core::Vec3(velocity)));
    add_attribute(result, speed);
    add_attribute(result, mesh.s);
    add_attribute(result, mesh.t);
}

std::size_t chunk_of(const core::Cell& cell) {
    core::VertexId newest = std::ranges::max(cell.corner);
    for (const core::VertexId mid : cell.mid)
        if (mid != core::no_vertex)
            newest = std::max(newest, mid);
    return newest / chunk_vertices;
}

/// A stable counting sort by the chunk with the cell's newest vertex.
void sort_cells(Quantised& mesh, std::span<const core::Cell> cells, std::size_t chunks) {
    std::vector<std::size_t> next(chunks + 1, 0);
    for (const core::Cell& cell : cells)
        ++next[chunk_of(cell) + 1];
    for (std::size_t i = 1; i <= chunks; ++i)
        next[i] += next[i - 1];
    mesh.cells_end.assign(next.begin() + 1, next.end());
    mesh.cells.resize(cells.size());
    for (const core::Cell& cell : cells)
        mesh.cells[next[chunk_of(cell)]++] = cell;
}

Quantised quantise_mesh(const core::QuadComplex& mesh, const Lattice& lattice, bool attributes) {
    Quantised result;
    const std::size_t n = mesh.cells.empty() ? 0 : mesh.vertices();
    result.position.reserve(n);
    for (std::size_t i = 0; i < n; ++i)
        result.position.push_back(quantise(lattice, mesh.position[i]));
    if (attributes && n > 0) {
        add_attributes(result, mesh);
    } else if (attributes) {
        result.ranges.resize(surface_attributes.size());
    }
    sort_cells(result, mesh.cells,
               std::max<std::size_t>(1, (n + chunk_vertices - 1) / chunk_vertices));
    return result;
}

std::vector<CellBlock> encode_cell_blocks(std::span<const core::Cell> cells) {
    std::vector<CellBlock> blocks(1);
    CellsEncoder encoder;
    for (const core::Cell& cell : cells) {
        if (encoder.size() > cell_budget || blocks.back().count == max_frame_cells) {
            blocks.back().code = encoder.finish();
            blocks.emplace_back();
        }
        encoder.put(cell);
        ++blocks.back().count;
    }
    blocks.back().code = encoder.finish();
    return blocks;
}

std::span<const LatticePoint> positions_of(const Quantised& mesh, std::size_t chunk) {
    const std::size_t begin = chunk * chunk_vertices;
    const std::size_t end = std::min(mesh.position.size(), begin + chunk_vertices);
    return std::span(mesh.position).subspan(begin, end - begin);
}

std::span<const core::Cell> cells_of(const Quantised& mesh, std::size_t chunk) {
    const std::size_t begin = chunk == 0 ? 0 : mesh.cells_end[chunk - 1];
    return std::span(mesh.cells).subspan(begin, mesh.cells_end[chunk] - begin);
}

Chunk encode_chunk(const Quantised& mesh, std::size_t chunk) {
    const auto positions = positions_of(mesh, chunk);
    std::vector<std::span<const std::uint16_t>> attributes;
    for (const auto& values : mesh.attributes)
        attributes.push_back(std::span(values).subspan(chunk * chunk_vertices, positions.size()));
    return {positions.empty() ? Bytes{} : encode_points(positions, attributes),
            encode_cell_blocks(cells_of(mesh, chunk))};
}

/// Strings the chunks together: one frame a block of cells, the first of a chunk with its points.
EncodedState assemble(const Quantised& mesh, std::span<const Chunk> chunks, FrameHeader header) {
    EncodedState state;
    StateCrc crc;
    const std::uint8_t final = header.flags;
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
        auto positions = positions_of(mesh, chunk);
        std::span<const std::byte> points = *chunks[chunk].points;
        for (const CellBlock& block : chunks[chunk].cells) {
            const bool first = state.frames.empty();
            const bool last = chunk + 1 == chunks.size() && &block == &chunks[chunk].cells.back();
            crc.add(positions);
            crc.add(std::span(mesh.cells).subspan(header.cell_base, block.count));
            header.flags = static_cast<std::uint8_t>(final | (first ? FrameHeader::first : 0) |
                                                     (last ? FrameHeader::last : 0));
            header.vertex_count = static_cast<std::uint32_t>(positions.size());
            header.cell_count = block.count;
            header.state_crc = crc.value();
            state.frames.push_back(std::make_shared<const Bytes>(
                write_frame({header, mesh.ranges, points, block.code})));
            ++header.seq;
            header.vertex_base += header.vertex_count;
            header.cell_base += header.cell_count;
            positions = {};
            points = {};
        }
    }
    state.state_crc = crc.value();
    return state;
}

core::Result<void> check_size(const core::QuadComplex& mesh) {
    if (mesh.vertices() <= max_mesh_vertices && mesh.cells.size() <= max_mesh_cells)
        return {};
    return core::fail(core::Error::Code::OverLimit,
                      fmt::format("a mesh of {} vertices and {} cells is too large to send",
                                  mesh.vertices(), mesh.cells.size()),
                      "ask for fewer quads or a larger separation");
}

} // namespace

core::Result<EncodedState>
encode_state(const core::QuadComplex& mesh, const Lattice& lattice, const EncodeOptions& options) {
    if (auto fine = check_size(mesh).and_then(
            [&] { return guard_mesh(mesh, lattice, options.attributes); });
        !fine)
        return tl::unexpected(fine.error());
    const Quantised quantised = quantise_mesh(mesh, lattice, options.attributes);
    std::vector<Chunk> chunks(quantised.cells_end.size());
    tbb::parallel_for(std::size_t{0}, chunks.size(),
                      [&](std::size_t i) { chunks[i] = encode_chunk(quantised, i); });
    for (const Chunk& chunk : chunks)
        if (!chunk.points)
            return tl::unexpected(chunk.points.error());
    FrameHeader header;
    header.flags = options.final ? FrameHeader::final : std::uint8_t{0};
    header.surface = options.surface;
    header.epoch = options.epoch;
    header.seq = options.first_seq;
    header.lattice_bits = static_cast<std::uint8_t>(lattice.bits);
    return assemble(quantised, chunks, header);
}

} // namespace wakesurf::protocol
