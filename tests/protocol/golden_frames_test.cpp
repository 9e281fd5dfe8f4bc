// Golden frames, read by this test and by web-client/src/protocol/meshDecoder.spec.ts. To write them anew after a
// change of the wire: WAKESURF_UPDATE_FIXTURES=1 bin/protocol_test --gtest_filter='GoldenFrames.*'
#include "core/base/crc32c.hpp"
#include "protocol/mesh_decoder.hpp"
#include "tests/protocol/sample_meshes.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

namespace wakesurf::protocol {
namespace {

using json = nlohmann::ordered_json;
using Frames = std::vector<Bytes>;

const std::filesystem::path folder =
    std::filesystem::path(WAKESURF_SOURCE_DIR) / "protocol/fixtures";

void add(Frames& frames, const core::QuadComplex& mesh, const EncodeOptions& options) {
    for (const auto& frame : samples::encode(mesh, options).frames)
        frames.push_back(*frame);
}

Frames made(const core::QuadComplex& mesh, const EncodeOptions& options) {
    Frames frames;
    add(frames, mesh, options);
    return frames;
}

/// What each golden file holds.
std::map<std::string, Frames> golden() {
    Frames refined;
    add(refined, samples::sheet(4, 6), {.surface = 2, .epoch = 7, .first_seq = 0});
    add(refined, samples::hanging_sheet(9, 12, 2),
        {.surface = 2, .epoch = 7, .first_seq = 1, .final = true});
    return {
        {"sheet", made(samples::sheet(12, 20), {.surface = 1, .epoch = 1, .final = true})},
        {"hanging",
         made(samples::hanging_sheet(16, 40, 4), {.surface = 1, .epoch = 3, .final = true})},
        {"chaos", made(samples::chaos(300, 200, 6), {.surface = 4, .epoch = 1, .final = true})},
        {"refined", std::move(refined)},
        {"chunked",
         made(samples::hanging_sheet(180, 190, 8), {.surface = 1, .epoch = 2, .final = true})},
        {"empty", made({}, {.surface = 9, .epoch = 4, .final = true})},
        {"obstacle", made(samples::sheet(7, 7), {.final = true, .attributes = false})},
    };
}

/// A golden file is its frames, each behind its length as u32.
Bytes joined(const Frames& frames) {
    Bytes bytes;
    for (const Bytes& frame : frames) {
        append(bytes, static_cast<std::uint32_t>(frame.size()));
        bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    return bytes;
}

Frames split(const Bytes& bytes) {
    Frames frames;
    for (std::size_t at = 0; at + 4 <= bytes.size();) {
        const auto size = number_at<std::uint32_t>(bytes, at);
        const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at + 4);
        frames.emplace_back(begin, begin + size);
        at += 4 + size;
    }
    return frames;
}

WireMesh folded(const Frames& frames) {
    MeshDecoder decoder;
    for (const Bytes& frame : frames) {
        const auto result = decoder.fold(frame);
        EXPECT_TRUE(result.has_value()) << result.error().message;
    }
    return decoder.mesh();
}

json ids_of(const core::Cell& cell) {
    json ids = json::array();
    for (const auto corner : cell.corner)
        ids.push_back(corner);
    for (const auto mid : cell.mid)
        ids.push_back(mid);
    return ids;
}

/// Floats, as both languages hold them.
json vertex(const WireMesh& mesh, std::size_t i) {
    const core::Vec3 p = dequantise(lattice_over(samples::domain), mesh.position[i]);
    json values = json::array();
    for (const WireAttribute& attribute : mesh.attributes)
        values.push_back(static_cast<float>(attribute.range.value(attribute.code[i])));
    return {
        {"node", mesh.position[i]},
        {"position", {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}},
        {"attributes", values}};
}

std::uint32_t attribute_crc(const WireMesh& mesh) {
    std::uint32_t crc = 0;
    for (const WireAttribute& attribute : mesh.attributes)
        for (const std::uint16_t code : attribute.code) {
            const auto value = static_cast<float>(attribute.range.value(code));
            crc = core::crc32c(std::as_bytes(std::span(&value, 1)), crc);
        }
    return crc;
}

std::uint32_t position_crc(const WireMesh& mesh) {
    std::uint32_t crc = 0;
    for (const LatticePoint& node : mesh.position) {
        const core::Vec3f p(dequantise(lattice_over(samples::domain), node));
        crc = core::crc32c(std::as_bytes(std::span(&p, 1)), crc);
    }
    return crc;
}

json description(const Frames& frames) {
    const WireMesh mesh = folded(frames);
    const Lattice lattice = lattice_over(samples::domain);
    json names = json::array();
    for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
        names.push_back(surface_attributes[i]);
    json result{{"frames", frames.size()},
                {"lattice",
                 {{"origin", {lattice.origin.x, lattice.origin.y, lattice.origin.z}},
                  {"step", lattice.step},
                  {"bits", lattice.bits}}},
                {"attributes", names},
                {"surface", mesh.surface},
                {"epoch", mesh.epoch},
                {"seq", mesh.seq},
                {"complete", mesh.complete},
                {"final", mesh.final},
                {"vertices", mesh.position.size()},
                {"cells", mesh.cells.size()},
                {"stateCrc", mesh.state_crc},
                {"positionCrc", position_crc(mesh)},
                {"attributeCrc", attribute_crc(mesh)}};
    if (!mesh.position.empty()) {
        result["firstVertex"] = vertex(mesh, 0);
        result["lastVertex"] = vertex(mesh, mesh.position.size() - 1);
    }
    if (!mesh.cells.empty()) {
        result["firstCell"] = ids_of(mesh.cells.front());
        result["lastCell"] = ids_of(mesh.cells.back());
    }
    return result;
}

Bytes read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in.good()) << file;
    std::stringstream text;
    text << in.rdbuf();
    const std::string raw = text.str();
    const auto bytes = std::as_bytes(std::span(raw));
    return {bytes.begin(), bytes.end()};
}

void write(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

void update_fixtures() {
    json descriptions;
    for (const auto& [name, frames] : golden()) {
        write(folder / (name + ".bin"), joined(frames));
        descriptions[name] = description(frames);
    }
    const std::string text = descriptions.dump(1) + "\n";
    write(folder / "golden.json", std::as_bytes(std::span(text)));
}

class GoldenFrames : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (std::getenv("WAKESURF_UPDATE_FIXTURES") != nullptr)
            update_fixtures();
    }
};

TEST_F(GoldenFrames, DecodeToWhatIsWrittenBesideThem) {
    const Bytes text = read(folder / "golden.json");
    const json expected = json::parse(reinterpret_cast<const char*>(text.data()),
                                      reinterpret_cast<const char*>(text.data()) + text.size());
    EXPECT_EQ(expected.size(), golden().size());
    for (const auto& [name, frames] : golden())
        EXPECT_EQ(description(split(read(folder / (name + ".bin")))), expected.at(name)) << name;
}

/// All but the Draco block, the byte counts and the checksum, which may differ with Draco's version.
std::pair<FrameHeader, Bytes> without_draco(const Bytes& bytes) {
    const auto frame = read_frame(bytes);
    FrameHeader header = frame->header;
    header.draco_bytes = 0;
    return {header, Bytes(frame->cells.begin(), frame->cells.end())};
}

TEST_F(GoldenFrames, AreWhatTheEncoderWritesToday) {
    for (const auto& [name, today] : golden()) {
        const Frames stored = split(read(folder / (name + ".bin")));
        ASSERT_EQ(stored.size(), today.size()) << name;
        for (std::size_t i = 0; i < stored.size(); ++i) {
            EXPECT_EQ(without_draco(stored[i]), without_draco(today[i])) << name << " frame " << i;
            EXPECT_EQ(read_frame(stored[i])->ranges, read_frame(today[i])->ranges) << name;
        }
        EXPECT_EQ(folded(stored).position, folded(today).position) << name;
    }
}

TEST_F(GoldenFrames, AreRefusedWhenMutatedOrCutOff) {
    std::mt19937 random(3);
    for (const auto& [name, frames] : golden()) {
        const Bytes& good = frames.front();
        const auto before = std::chrono::steady_clock::now();
        for (int i = 0; i < 2'000; ++i) {
            Bytes bad = good;
            if (i % 2 == 0)
                bad[random() % bad.size()] ^= static_cast<std::byte>(1 + random() % 255);
            else
                bad.resize(random() % bad.size());
            MeshDecoder decoder;
            ASSERT_FALSE(decoder.fold(bad).has_value()) << name << ", mutation " << i;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(10)) << name;
    }
}

} // namespace
} // namespace wakesurf::protocol
