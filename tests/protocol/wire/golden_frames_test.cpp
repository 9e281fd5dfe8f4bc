// Golden sequences of frames, read by this test and by web-client/src/protocol/meshDecoder.spec.ts. To write them again after a
// change of the wire: WAKESURF_UPDATE_FIXTURES=1 bin/protocol_test --gtest_filter='GoldenFrames.*'
// More of the random ones, for the other decoders: WAKESURF_SEQUENCES_TO=<folder> WAKESURF_SEQUENCE_SEED=<seed>.
#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/numbers.hpp"
#include "protocol/wire/wire_mesh.hpp"
#include "tests/protocol/wire/sample_sequences.hpp"
#include "tests/support/dequantise.hpp"
#include "tests/support/held_ranges.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace wakesurf::protocol::golden_frames_test {
namespace {

using json = nlohmann::ordered_json;
using Frames = std::vector<Bytes>;

const std::filesystem::path folder = tests::source_folder() / "protocol/wire/fixtures";

void add(Frames& frames, const SharedFrames& more) {
    for (const auto& frame : more)
        frames.push_back(*frame);
}

Frames made(const core::QuadComplex& mesh, const EncodeOptions& options) {
    Frames frames;
    add(frames, samples::encode(mesh, options).frames);
    return frames;
}

/// A random surface, now and then exact, and once in a while a KEY in place of the update, as for one who joins late.
Frames living(std::uint32_t seed, int updates, std::uint32_t columns, int join_every) {
    std::mt19937 random(seed);
    samples::RandomSurface surface(seed, columns);
    MeshStream stream(3, 6, lattice_over(samples::domain));
    Frames frames;
    for (int i = 0; i < updates; ++i) {
        UpdateOptions options{.phase = Phase::Live, .tolerance = live_tolerance};
        if (random() % 5 == 0)
            options = {};
        const EncodedUpdate update = samples::next(stream, surface.next(), options);
        add(frames,
            i % join_every == join_every - 1 ? encode_key(3, update)->frames : update.frames);
    }
    return frames;
}

/// A sheet row by row, four rows an update.
Frames growing() {
    core::QuadComplex all = samples::sheet(32, 24); // its columns serve as rows
    MeshStream stream = tests::stream_with_ranges(lattice_over(samples::domain),
                                                  {{0.f, 3.f}, {0.f, 1.f}, {0.f, 4.f}});
    Frames frames;
    for (std::uint32_t rows = 4; rows <= 32; rows += 4) {
        core::QuadComplex part = all;
        part.position.resize(24 * rows);
        part.s.resize(24 * rows);
        part.t.resize(24 * rows);
        part.velocity.resize(24 * rows);
        std::erase_if(part.cells,
                      [&](const core::Cell& cell) { return cell.corner[2] >= 24 * rows; });
        add(frames, samples::next(stream, with_ids(part, 0.5 * rows)).frames);
    }
    return frames;
}

/// Of the changes of positions, which the state's own sum leaves out.
std::uint32_t change_sum(const WireMesh& mesh) {
    std::vector<std::uint32_t> words;
    for (const LatticePoint& change : mesh.change)
        for (const std::int32_t number : change)
            words.push_back(static_cast<std::uint32_t>(number));
    return word_sum(std::span<const std::uint32_t>(words));
}

/// What each golden file holds.
std::map<std::string, Frames> golden() {
    Frames refined = made(samples::sheet(4, 6), {.surface = 2, .epoch = 7, .seq = 0});
    for (auto& frame : made(samples::hanging_sheet(9, 12, 2),
                            {.surface = 2, .epoch = 7, .seq = 1, .final = true}))
        refined.push_back(std::move(frame));
    return {
        {"sheet", made(samples::sheet(12, 20), {.surface = 1, .epoch = 1, .final = true})},
        {"hanging",
         made(samples::hanging_sheet(16, 40, 4), {.surface = 1, .epoch = 3, .final = true})},
        {"chaos", made(samples::chaos(300, 200, 6), {.surface = 4, .epoch = 1, .final = true})},
        {"refined", std::move(refined)},
        {"chunked",
         made(samples::hanging_sheet(280, 290, 8), {.surface = 1, .epoch = 2, .final = true})},
        {"empty", made({}, {.surface = 9, .epoch = 4, .final = true})},
        {"obstacle", made(samples::sheet(7, 7), {.final = true, .attributes = false})},
        {"growing", growing()},
        {"living", living(21, 60, 14, 13)},
        {"thousand", living(22, 1000, 5, 97)},
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

std::vector<DecodedState> folded(const Frames& frames) {
    std::vector<DecodedState> states;
    MeshDecoder decoder;
    for (const Bytes& frame : frames) {
        const auto result = decoder.fold(frame);
        EXPECT_TRUE(result.has_value()) << result.error().message;
        if (result.value_or(false))
            states.push_back(*decoder.newest());
    }
    return states;
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
    const core::Vec3 p = tests::dequantise(lattice_over(samples::domain), mesh.position[i]);
    json values = json::array();
    json codes = json::array();
    for (std::size_t a = 0; a < mesh.codes.size(); ++a) {
        codes.push_back(mesh.codes[a][i]);
        values.push_back(static_cast<float>(mesh.ranges[a].value(mesh.codes[a][i])));
    }
    return {
        {"node", mesh.position[i]},
        {"change", mesh.change[i]},
        {"codes", codes},
        {"position", {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}},
        {"attributes", values}};
}

json description(const Frames& frames) {
    const auto states = folded(frames);
    const Lattice lattice = lattice_over(samples::domain);
    const DecodedState& last = states.back();
    const WireMesh& mesh = *last.mesh;
    json seqs = json::array();
    json sums = json::array();
    json change_sums = json::array();
    for (const DecodedState& state : states) {
        seqs.push_back(state.header.seq);
        sums.push_back(state.header.state_sum);
        change_sums.push_back(change_sum(*state.mesh));
    }
    json result{{"frames", frames.size()},
                {"lattice",
                 {{"origin", {lattice.origin.x, lattice.origin.y, lattice.origin.z}},
                  {"step", lattice.step},
                  {"bits", lattice.bits}}},
                {"surface", last.header.surface},
                {"epoch", last.header.epoch},
                {"seqs", seqs},
                {"stateSums", sums},
                {"changeSums", change_sums},
                {"phase", static_cast<int>(last.header.phase)},
                {"lossless", (last.header.flags & FrameHeader::lossless) != 0},
                {"time", mesh.time},
                {"attributes", mesh.codes.size()},
                {"vertices", mesh.vertices()},
                {"cells", mesh.cells().size()}};
    if (mesh.vertices() > 0) {
        result["firstVertex"] = vertex(mesh, 0);
        result["lastVertex"] = vertex(mesh, mesh.vertices() - 1);
        result["firstCell"] = ids_of(mesh.cells().front());
        result["lastCell"] = ids_of(mesh.cells().back());
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

void write_all(const std::filesystem::path& into, const std::map<std::string, Frames>& files) {
    json descriptions;
    for (const auto& [name, frames] : files) {
        write(into / (name + ".bin"), joined(frames));
        descriptions[name] = description(frames);
    }
    // Lists of numbers stay on one line.
    std::string text = "{\n";
    for (const auto& [name, described] : descriptions.items())
        text += (text.size() > 2 ? ",\n" : "") + json(name).dump() + ": " + described.dump();
    text += "\n}\n";
    write(into / "golden.json", std::as_bytes(std::span(text)));
}

class GoldenFrames : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (std::getenv("WAKESURF_UPDATE_FIXTURES") != nullptr)
            write_all(folder, golden());
        if (const char* to = std::getenv("WAKESURF_SEQUENCES_TO"); to != nullptr) {
            const char* seed = std::getenv("WAKESURF_SEQUENCE_SEED");
            const auto first = static_cast<std::uint32_t>(seed == nullptr ? 1 : std::atoi(seed));
            write_all(to, {{"random", living(first, 1000, 16, 97)}});
        }
    }
};

TEST_F(GoldenFrames, DecodeToWhatIsWrittenBesideThem) {
    const Bytes text = read(folder / "golden.json");
    const json expected = json::parse(reinterpret_cast<const char*>(text.data()),
                                      reinterpret_cast<const char*>(text.data()) + text.size());
    EXPECT_EQ(expected.size(), golden().size());
    for (const auto& [name, described] : expected.items())
        EXPECT_EQ(description(split(read(folder / (name + ".bin")))), described) << name;
}

/// Of frames that are a whole update: how many numbers it has. The bytes depend on the versions of zlib and Draco.
std::size_t numbers_in(std::span<const Bytes> frames) {
    Bytes update;
    for (const Bytes& frame : frames)
        update.insert(update.end(), frame.begin() + frame_header_bytes, frame.end());
    std::span<const std::byte> bytes = update;
    const auto numbers = unpack_numbers(bytes);
    EXPECT_TRUE(numbers.has_value());
    return numbers ? numbers->left() : 0;
}

TEST_F(GoldenFrames, AreWhatTheEncoderWritesToday) {
    for (const auto& [name, today] : golden()) {
        const Frames stored = split(read(folder / (name + ".bin")));
        ASSERT_EQ(stored.size(), today.size()) << name;
        for (std::size_t i = 0; i < stored.size(); ++i) {
            const FrameHeader header = read_frame(stored[i])->header;
            ASSERT_EQ(header, read_frame(today[i])->header) << name << " frame " << i;
            if (header.frame_index == 0) {
                ASSERT_EQ(numbers_in(std::span(stored).subspan(i, header.frame_count)),
                          numbers_in(std::span(today).subspan(i, header.frame_count)))
                    << name << " frame " << i;
            }
        }
    }
}

TEST_F(GoldenFrames, HoldAllThatTheFormatHas) {
    bool changes = false;
    bool several = false;
    std::map<std::uint32_t, int> phases;
    for (const auto& [name, frames] : golden()) {
        for (const DecodedState& state : folded(frames))
            changes = changes || (state.header.is_key() && state.header.seq > 0 &&
                                  std::ranges::any_of(state.mesh->change, [](const auto& change) {
                                      return change != LatticePoint{};
                                  }));
        for (const Bytes& bytes : frames) {
            const FrameHeader header = read_frame(bytes)->header;
            several = several || header.frame_count > 1;
            ++phases[static_cast<std::uint32_t>(header.phase)];
        }
    }
    EXPECT_TRUE(changes) << "a KEY for those who join late has the changes of its vertices";
    EXPECT_TRUE(several);
    EXPECT_EQ(phases.size(), 3u) << "coarse, final, live";
}

} // namespace
} // namespace wakesurf::protocol::golden_frames_test
