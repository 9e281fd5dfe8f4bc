// Frames of a surface, folded one after another. The input is what the golden files are: frames, each behind its length. The checksum of
// each frame is corrected first, or no mutation would get past it.
#include "protocol/wire/mesh_decoder.hpp"

#include "protocol/wire/mesh_frame.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace wakesurf::fuzz {

namespace {

void correct_checksum(std::span<std::byte> frame) {
    if (frame.size() < protocol::frame_header_bytes)
        return;
    const std::uint32_t sum = protocol::frame_crc(frame);
    std::memcpy(frame.data() + protocol::frame_crc_at, &sum, sizeof sum);
}

void check_ids(const protocol::WireMesh& mesh) {
    const auto vertices = mesh.vertices();
    for (const auto& cell : mesh.cells()) {
        for (const auto corner : cell.corner)
            demand(corner < vertices, "a decoded cell names a vertex that is not there");
        for (const auto mid : cell.mid)
            demand(mid == core::no_vertex || mid < vertices,
                   "a decoded side names a vertex that is not there");
    }
}

void run(Input input) {
    const auto given = std::as_bytes(input);
    std::vector<std::byte> bytes(given.begin(), given.end());
    protocol::MeshDecoder decoder;
    for (std::size_t at = 0; at + 4 <= bytes.size();) {
        std::uint32_t announced = 0;
        std::memcpy(&announced, bytes.data() + at, sizeof announced);
        at += sizeof announced;
        const std::size_t size = std::min<std::size_t>(announced, bytes.size() - at);
        const auto frame = std::span(bytes).subspan(at, size);
        correct_checksum(frame);
        const auto whole = decoder.fold(frame);
        if (whole && *whole) {
            demand(decoder.newest().has_value(), "a whole state is there to be read");
            check_ids(*decoder.newest()->mesh);
        }
        at += size;
    }
}

std::string fixture(std::string_view name) {
    std::ifstream file(tests::source_folder() / "protocol/wire/fixtures" /
                           (std::string(name) + ".bin"),
                       std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Short sequences out of a long one, each from a KEY on: with every kind of edit, and read quickly.
void add_pieces(std::string_view whole, std::vector<std::string>& to) {
    constexpr std::size_t frames = 60, longest = 1500, flags_at = 3;
    std::string piece;
    for (std::size_t i = 0, at = 0; i < frames && at + 4 < whole.size(); ++i) {
        std::uint32_t size = 0;
        std::memcpy(&size, whole.data() + at, sizeof size);
        const auto frame = whole.substr(at, sizeof size + size);
        const bool key = (frame[sizeof size + flags_at] & 1) != 0;
        if (!piece.empty() && (key || piece.size() + frame.size() > longest))
            to.push_back(std::exchange(piece, {}));
        if (key || !piece.empty())
            piece += frame;
        at += frame.size();
    }
}

std::vector<std::string> seeds() {
    std::vector<std::string> seeds;
    for (const char* const name :
         {"sheet", "hanging", "chaos", "refined", "empty", "obstacle", "growing"})
        seeds.push_back(fixture(name));
    for (const char* const name : {"living", "thousand"})
        add_pieces(fixture(name), seeds);
    return seeds;
}

} // namespace

const Target mesh_decoder_target{"mesh_decoder", run, seeds};

} // namespace wakesurf::fuzz
