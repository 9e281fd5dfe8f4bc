#include "protocol/mesh_decoder.hpp"
#include "protocol/mesh_encoder.hpp"
#include "protocol/mesh_frame.hpp"
#include "tests/protocol/sample_meshes.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::protocol {
namespace {

constexpr std::size_t half_mebibyte = 512u << 10;

WireMesh decode(const EncodedState& state) {
    MeshDecoder decoder;
    for (const auto& frame : state.frames) {
        const auto folded = decoder.fold(*frame);
        EXPECT_TRUE(folded.has_value()) << folded.error().message;
    }
    EXPECT_TRUE(decoder.mesh().complete);
    EXPECT_EQ(decoder.mesh().state_crc, state.state_crc);
    return decoder.mesh();
}

std::vector<std::array<std::uint32_t, 8>> sorted(std::span<const core::Cell> cells) {
    std::vector<std::array<std::uint32_t, 8>> ids;
    for (const core::Cell& cell : cells) {
        auto& entry = ids.emplace_back();
        std::ranges::copy(cell.corner, entry.begin());
        std::ranges::copy(cell.mid, entry.begin() + 4);
    }
    std::ranges::sort(ids);
    return ids;
}

void expect_quantised(const WireMesh& wire, const core::QuadComplex& mesh) {
    const Lattice lattice = lattice_over(samples::domain);
    ASSERT_EQ(wire.position.size(), mesh.vertices());
    ASSERT_EQ(wire.attributes.size(), 3u);
    for (std::size_t i = 0; i < mesh.vertices(); ++i) {
        ASSERT_EQ(wire.position[i], quantise(lattice, mesh.position[i])) << "vertex " << i;
        const double truth[] = {mesh.speed(static_cast<core::VertexId>(i)), mesh.s[i], mesh.t[i]};
        for (std::size_t a = 0; a < 3; ++a) {
            const AttributeRange& range = wire.attributes[a].range;
            const double step = (double{range.hi} - range.lo) / 65535;
            const double float_rounding = 1e-6 * (1 + std::abs(truth[a]));
            ASSERT_NEAR(range.value(wire.attributes[a].code[i]), truth[a],
                        0.51 * step + float_rounding)
                << surface_attributes[a] << " of vertex " << i;
        }
    }
}

TEST(MeshEncoder, SendsTheQuantisedMeshAndNothingElse) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed)
        for (const auto& mesh : {samples::sheet(2 + seed % 9, 2 + seed),
                                 samples::hanging_sheet(2 + seed % 9, 3 + seed, seed),
                                 samples::chaos(1 + 7 * seed, 5 * seed, seed)}) {
            const WireMesh wire = decode(samples::encode(mesh));
            expect_quantised(wire, mesh);
            EXPECT_EQ(wire.cells, mesh.cells) << "one frame keeps the order of the cells";
        }
}

TEST(MeshEncoder, CutsALargeMeshIntoFramesThatEachUseOnlyVerticesSent) {
    const auto mesh = samples::hanging_sheet(310, 330, 5);
    const EncodedState state =
        samples::encode(mesh, {.surface = 3, .epoch = 9, .first_seq = 4, .final = true});
    ASSERT_GT(state.frames.size(), 1u);
    std::uint32_t seq = 4;
    for (const auto& bytes : state.frames) {
        EXPECT_LE(bytes->size(), half_mebibyte);
        const FrameHeader h = read_frame(*bytes)->header;
        EXPECT_EQ(h.surface, 3u);
        EXPECT_EQ(h.epoch, 9u);
        EXPECT_EQ(h.seq, seq++);
        EXPECT_EQ((h.flags & FrameHeader::first) != 0, bytes == state.frames.front());
        EXPECT_EQ((h.flags & FrameHeader::last) != 0, bytes == state.frames.back());
        EXPECT_NE(h.flags & FrameHeader::final, 0);
    }
    const WireMesh wire = decode(state);
    expect_quantised(wire, mesh);
    EXPECT_EQ(sorted(wire.cells), sorted(mesh.cells));
}

TEST(MeshEncoder, KeepsFramesSmallWhenNothingCanBePredicted) {
    const auto mesh = samples::chaos(40'000, 120'000, 1);
    const EncodedState state = samples::encode(mesh);
    for (const auto& bytes : state.frames)
        EXPECT_LE(bytes->size(), half_mebibyte + 128);
    EXPECT_EQ(sorted(decode(state).cells), sorted(mesh.cells));
}

TEST(MeshEncoder, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto mesh = samples::sheet(300, 300);
    EncodedState one;
    EncodedState two;
    tbb::task_arena(1).execute([&] { one = samples::encode(mesh); });
    tbb::task_arena(2).execute([&] { two = samples::encode(mesh); });
    ASSERT_EQ(one.frames.size(), two.frames.size());
    for (std::size_t i = 0; i < one.frames.size(); ++i)
        EXPECT_EQ(*one.frames[i], *two.frames[i]);
}

TEST(MeshEncoder, SendsAMeshWithoutCellsAsOneEmptyFrame) {
    auto mesh = samples::sheet(3, 3);
    mesh.cells.clear();
    for (const core::QuadComplex& empty : {mesh, core::QuadComplex{}}) {
        const EncodedState state = samples::encode(empty, {.final = true});
        ASSERT_EQ(state.frames.size(), 1u);
        const WireMesh wire = decode(state);
        EXPECT_TRUE(wire.position.empty());
        EXPECT_TRUE(wire.final);
        EXPECT_EQ(wire.attributes.size(), 3u);
    }
}

TEST(MeshEncoder, NeedsNoAttributesForAnObstacle) {
    auto mesh = samples::sheet(5, 6);
    mesh.s.clear();
    mesh.t.clear();
    mesh.velocity.clear();
    EXPECT_FALSE(encode_state(mesh, lattice_over(samples::domain), {}).has_value());
    const WireMesh wire = decode(samples::encode(mesh, {.attributes = false}));
    EXPECT_TRUE(wire.attributes.empty());
    EXPECT_EQ(wire.cells, mesh.cells);
}

TEST(MeshEncoder, SendsAConstantAttributeExactly) {
    auto mesh = samples::sheet(5, 6);
    std::ranges::fill(mesh.t, 2.5);
    const WireMesh wire = decode(samples::encode(mesh));
    for (const std::uint16_t code : wire.attributes[2].code)
        EXPECT_EQ(wire.attributes[2].range.value(code), 2.5);
}

TEST(MeshEncoder, SpendsFewBytesOnASmoothSheet) {
    const auto mesh = samples::sheet(140, 143);
    std::size_t bytes = 0;
    for (const auto& frame : samples::encode(mesh).frames)
        bytes += frame->size();
    EXPECT_LT(static_cast<double>(bytes) / static_cast<double>(mesh.vertices()), 4.5);
}

} // namespace
} // namespace wakesurf::protocol
