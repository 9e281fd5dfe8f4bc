// Frames of a surface, folded one after another. The input is what the golden files are: frames, each behind its length. The checksum of
// each frame is corrected first, or no mutation would get past it.
#include "protocol/mesh_decoder.hpp"

#include "core/base/crc32c.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace wakesurf::fuzz {

namespace {

constexpr std::size_t checksum_at = 60; ///< of a frame's header: protocol/README.md
constexpr std::size_t header_bytes = protocol::frame_header_bytes;

void correct_checksum(std::span<std::byte> frame) {
    if (frame.size() < header_bytes)
        return;
    const std::uint32_t sum =
        core::crc32c(frame.subspan(header_bytes), core::crc32c(frame.first(checksum_at)));
    std::memcpy(frame.data() + checksum_at, &sum, sizeof sum);
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

} // namespace

void mesh_decoder(Input input) {
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

std::vector<std::string> mesh_decoder_seeds() {
    std::vector<std::string> seeds;
    for (const char* const name :
         {"sheet", "hanging", "chaos", "refined", "empty", "obstacle", "growing"}) {
        std::ifstream file(tests::source_folder() / "protocol/fixtures" /
                               (std::string(name) + ".bin"),
                           std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return seeds;
}

} // namespace wakesurf::fuzz
