#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"
#include "tests/protocol/wire/sample_sequences.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::protocol::mesh_encoder_test {
namespace {

constexpr std::size_t half_mebibyte = 512u << 10;

DecodedState decode(const EncodedState& state) {
    MeshDecoder decoder;
    for (const auto& frame : state.frames) {
        const auto folded = decoder.fold(*frame);
        EXPECT_TRUE(folded.has_value()) << folded.error().message;
    }
    EXPECT_TRUE(decoder.newest().has_value());
    EXPECT_EQ(decoder.newest()->header.state_sum, state.state_sum);
    return *decoder.newest();
}

void expect_quantised(const WireMesh& wire, const core::QuadComplex& mesh) {
    const Lattice lattice = lattice_over(samples::domain);
    ASSERT_EQ(wire.vertices(), mesh.vertices());
    ASSERT_EQ(wire.codes.size(), 3u);
    samples::PlacesTwin order;
    order.follow(with_ids(mesh), true);
    std::vector<std::uint32_t> place(mesh.vertices());
    for (std::uint32_t p = 0; p < wire.vertices(); ++p)
        place[order.vertices()[p]] = p;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const std::size_t i = place[v];
        ASSERT_EQ(wire.position[i], LatticeRounding(lattice).nearest(mesh.position[v]))
            << "vertex " << v;
        const double truth[] = {mesh.speed(static_cast<core::VertexId>(v)), mesh.s[v], mesh.t[v]};
        for (std::size_t a = 0; a < 3; ++a) {
            const AttributeRange& range = wire.ranges[a];
            const double step = (double{range.hi} - range.lo) / 65535;
            const double float_rounding = 1e-6 * (1 + std::abs(truth[a]));
            ASSERT_NEAR(range.value(wire.codes[a][i]), truth[a], 0.51 * step + float_rounding)
                << surface_attributes[a] << " of vertex " << v;
        }
    }
    std::vector<core::Cell> cells;
    for (const std::uint32_t c : order.cells()) {
        cells.push_back(mesh.cells[c]);
        for (auto* ids : {&cells.back().corner, &cells.back().mid})
            for (std::uint32_t& id : *ids)
                id = id == core::no_vertex ? id : place[id];
    }
    EXPECT_EQ(wire.cells(), cells);
}

TEST(MeshEncoder, SendsTheQuantisedMeshInOrderAlongTheSurfaceAndNothingElse) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed)
        for (const auto& mesh : {samples::sheet(2 + seed % 9, 2 + seed),
                                 samples::hanging_sheet(2 + seed % 9, 3 + seed, seed),
                                 samples::chaos(1 + 7 * seed, 5 * seed, seed)})
            expect_quantised(*decode(samples::encode(mesh)).mesh, mesh);
}

TEST(MeshEncoder, CutsALargeMeshIntoFrames) {
    const auto mesh = samples::hanging_sheet(310, 330, 5);
    const EncodedState state =
        samples::encode(mesh, {.surface = 3, .epoch = 9, .seq = 4, .final = true});
    ASSERT_GT(state.frames.size(), 1u);
    std::uint16_t index = 0;
    for (const auto& bytes : state.frames) {
        EXPECT_LE(bytes->size(), half_mebibyte);
        const FrameHeader h = read_frame(*bytes)->header;
        EXPECT_EQ(h.surface, 3u);
        EXPECT_EQ(h.epoch, 9u);
        EXPECT_EQ(h.seq, 4u);
        EXPECT_EQ(h.frame_index, index++);
        EXPECT_EQ(h.frame_count, state.frames.size());
        EXPECT_EQ(h.phase, Phase::Final);
    }
    expect_quantised(*decode(state).mesh, mesh);
}

TEST(MeshEncoder, KeepsFramesSmallWhenNothingCanBePredicted) {
    const auto mesh = samples::chaos(40'000, 120'000, 1);
    const EncodedState state = samples::encode(mesh);
    for (const auto& bytes : state.frames)
        EXPECT_LE(bytes->size(), half_mebibyte);
    expect_quantised(*decode(state).mesh, mesh);
}

TEST(MeshEncoder, SendsAMeshWithoutCellsAsOneEmptyFrame) {
    auto mesh = samples::sheet(3, 3);
    mesh.cells.clear();
    for (const core::QuadComplex& empty : {mesh, core::QuadComplex{}}) {
        const EncodedState state = samples::encode(empty, {.final = true});
        ASSERT_EQ(state.frames.size(), 1u);
        const DecodedState wire = decode(state);
        EXPECT_EQ(wire.mesh->vertices(), 0u);
        EXPECT_EQ(wire.header.phase, Phase::Final);
        EXPECT_EQ(wire.mesh->codes.size(), 3u);
    }
}

TEST(MeshEncoder, NeedsNoAttributesForAnObstacle) {
    auto mesh = samples::sheet(5, 6);
    mesh.s.clear();
    mesh.t.clear();
    mesh.velocity.clear();
    EXPECT_FALSE(encode_state(mesh, lattice_over(samples::domain), {}).has_value());
    const DecodedState wire = decode(samples::encode(mesh, {.attributes = false}));
    EXPECT_TRUE(wire.mesh->codes.empty());
    EXPECT_EQ(wire.mesh->cells(), mesh.cells);
}

TEST(MeshEncoder, SendsAConstantAttributeExactly) {
    auto mesh = samples::sheet(5, 6);
    std::ranges::fill(mesh.t, 2.5);
    const DecodedState wire = decode(samples::encode(mesh));
    for (const std::uint16_t code : wire.mesh->codes[2])
        EXPECT_EQ(wire.mesh->ranges[2].value(code), 2.5);
}

TEST(MeshEncoder, SpendsFewBytesOnASmoothSheet) {
    const auto mesh = samples::sheet(140, 143);
    std::size_t bytes = 0;
    for (const auto& frame : samples::encode(mesh).frames)
        bytes += frame->size();
    EXPECT_LT(static_cast<double>(bytes) / static_cast<double>(mesh.vertices()), 2.0);
}

} // namespace
} // namespace wakesurf::protocol::mesh_encoder_test
