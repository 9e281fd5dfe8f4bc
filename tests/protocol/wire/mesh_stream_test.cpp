#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "tests/protocol/wire/sample_sequences.hpp"
#include "tests/support/held_ranges.hpp"
#include "tests/support/same_state.hpp"

#include <tbb/task_arena.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace wakesurf::protocol::mesh_stream_test {
namespace {

const Lattice lattice = lattice_over(samples::domain);

bool folds(MeshDecoder& decoder, const EncodedUpdate& update) {
    for (const auto& frame : update.frames) {
        const auto folded = decoder.fold(*frame);
        EXPECT_TRUE(folded.has_value()) << folded.error().message;
        if (!folded)
            return false;
        EXPECT_EQ(*folded, frame == update.frames.back());
    }
    return decoder.newest() && decoder.newest()->header.seq == update.seq;
}

bool holds(const MeshDecoder& decoder, const EncodedUpdate& update) {
    return decoder.newest() && decoder.newest()->header.state_sum == update.state_sum &&
           tests::same_state(*decoder.newest()->mesh, *update.state);
}

/// The state against the surface it stands for, by the rule for places.
void expect_close(const WireMesh& state,
                  const core::KeyedMesh& mesh,
                  const samples::PlacesTwin& places,
                  const Tolerance& tolerance) {
    ASSERT_EQ(state.vertices(), places.vertices().size());
    std::vector<std::uint32_t> place_of(mesh.vertex_id.size());
    for (std::uint32_t place = 0; place < state.vertices(); ++place) {
        const auto i = static_cast<std::size_t>(
            std::ranges::lower_bound(mesh.vertex_id, places.vertices()[place]) -
            mesh.vertex_id.begin());
        place_of[i] = place;
        const LatticePoint truth = LatticeRounding(lattice).nearest(mesh.mesh.position[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            ASSERT_LE(std::abs(truth[axis] - state.position[place][axis]), tolerance.position);
        const double values[] = {mesh.mesh.speed(static_cast<core::VertexId>(i)), mesh.mesh.s[i],
                                 mesh.mesh.t[i]};
        for (std::size_t a = 0; a < 3; ++a)
            ASSERT_LE(std::abs(state.ranges[a].code(values[a]) - state.codes[a][place]),
                      a == 0 ? tolerance.speed : tolerance.parameter);
    }
    ASSERT_EQ(state.cells().size(), places.cells().size());
    for (std::size_t at = 0; at < state.cells().size(); ++at) {
        core::Cell cell = mesh.mesh.cells[static_cast<std::size_t>(
            std::ranges::lower_bound(mesh.cell_id, places.cells()[at]) - mesh.cell_id.begin())];
        for (auto* vertices : {&cell.corner, &cell.mid})
            for (std::uint32_t& v : *vertices)
                v = v == core::no_vertex ? v : place_of[v];
        ASSERT_EQ(state.cells()[at], cell);
    }
}

UpdateOptions any_options(std::mt19937& random) {
    UpdateOptions options;
    options.phase = static_cast<Phase>(random() % 4);
    if (random() % 4 != 0)
        options.tolerance = random() % 2 == 0 ? live_tolerance
                                              : Tolerance{static_cast<std::uint16_t>(random() % 40),
                                                          static_cast<std::uint16_t>(random() % 9),
                                                          static_cast<std::uint16_t>(random() % 9)};
    options.unrelated = random() % 50 == 0;
    return options;
}

void follow_a_random_surface(std::uint32_t seed, int frames, std::uint32_t columns) {
    std::mt19937 random(seed + 1000);
    samples::RandomSurface surface(seed, columns);
    samples::PlacesTwin places;
    MeshStream stream(5, 2, lattice);
    MeshDecoder follower;
    std::optional<MeshDecoder> joiner;
    Tolerance worst;
    for (int i = 0; i < frames; ++i) {
        const core::KeyedMesh mesh = surface.next();
        const UpdateOptions options = any_options(random);
        const EncodedUpdate update = samples::next(stream, mesh, options);
        ASSERT_EQ(update.seq, static_cast<std::uint32_t>(i));
        ASSERT_TRUE(folds(follower, update)) << "seed " << seed << " update " << i;
        ASSERT_TRUE(holds(follower, update)) << "seed " << seed << " update " << i;
        places.follow(mesh, update.key);
        expect_close(*update.state, mesh, places, options.tolerance);
        if (joiner) {
            ASSERT_TRUE(folds(*joiner, update) && holds(*joiner, update)) << "late, update " << i;
        }
        if (random() % 8 == 0) {
            const auto key = encode_key(5, update);
            ASSERT_TRUE(key.has_value());
            ASSERT_TRUE(folds(joiner.emplace(), *key) && holds(*joiner, update));
        }
        if (testing::Test::HasFatalFailure())
            FAIL() << "seed " << seed << " update " << i;
    }
}

TEST(MeshStream, LeadsAFollowerAndLateJoinersThroughAThousandRandomUpdatesBitForBit) {
    follow_a_random_surface(1, 1000, 12);
}

TEST(MeshStream, LeadsFollowersOfManyRandomSurfaces) {
    for (std::uint32_t seed = 2; seed < 42; ++seed)
        follow_a_random_surface(seed, 60, 2 + seed % 40);
}

std::size_t size_of(const EncodedUpdate& update) {
    std::size_t bytes = 0;
    for (const auto& frame : update.frames)
        bytes += frame->size();
    EXPECT_EQ(update.bytes, bytes);
    return bytes;
}

TEST(MeshStream, GivesACellAnotherIdWithoutAnyChangeOfTheMesh) {
    core::KeyedMesh mesh = with_ids(samples::sheet(10, 10), 1.0);
    MeshStream stream(1, 1, lattice);
    MeshDecoder follower;
    ASSERT_TRUE(folds(follower, samples::next(stream, mesh)));
    ++mesh.cell_id.back();
    const EncodedUpdate update = samples::next(stream, mesh);
    ASSERT_TRUE(folds(follower, update));
    EXPECT_TRUE(holds(follower, update));
    EXPECT_EQ(update.state->cells().size(), mesh.mesh.cells.size());
}

TEST(MeshStream, SpendsNothingOnWhatDoesNotChange) {
    core::KeyedMesh mesh = with_ids(samples::sheet(100, 100), 1.0);
    MeshStream stream(1, 1, lattice);
    EXPECT_TRUE(samples::next(stream, mesh).key);
    const EncodedUpdate same = samples::next(stream, mesh);
    EXPECT_FALSE(same.key);
    EXPECT_LE(size_of(same), frame_header_bytes + 8);
    mesh.mesh.position[5'050] += core::Vec3(0.3);
    EXPECT_LE(size_of(samples::next(stream, mesh)), frame_header_bytes + 60);
}

TEST(MeshStream, SendsOnlyTheNewRowsOfAGrowingSurface) {
    const core::QuadComplex all = samples::sheet(200, 60); // columns become rows
    const std::vector<AttributeRange> ranges{{0.f, 3.f}, {0.f, 1.f}, {0.f, 4.f}};
    MeshStream stream = tests::stream_with_ranges(lattice, ranges);
    MeshDecoder decoder;
    for (std::uint32_t rows = 2; rows <= 200; rows += 6) {
        core::QuadComplex part = all;
        part.position.resize(60 * rows);
        part.s.resize(60 * rows);
        part.t.resize(60 * rows);
        part.velocity.resize(60 * rows);
        std::erase_if(part.cells,
                      [&](const core::Cell& cell) { return cell.corner[2] >= 60 * rows; });
        const EncodedUpdate update = samples::next(stream, with_ids(part));
        ASSERT_TRUE(folds(decoder, update) && holds(decoder, update));
        EXPECT_EQ(update.key, rows <= 8) << "few rows stay of few";
        EXPECT_EQ(update.state->ranges, ranges);
        if (rows > 60) {
            EXPECT_LT(size_of(update), 6u * 60u * 2u) << rows;
        }
    }
}

TEST(MeshStream, SendsAKeyWhenAnAttributeLeavesItsRangeAndNotAgainSoonAfter) {
    core::KeyedMesh mesh = with_ids(samples::sheet(20, 20));
    MeshStream stream(1, 1, lattice);
    samples::next(stream, mesh);
    int keys = 0;
    for (int i = 0; i < 40; ++i) {
        for (auto& t : mesh.mesh.t)
            t += 1.0;
        const EncodedUpdate update = samples::next(stream, mesh);
        keys += update.key;
        for (std::size_t v = 0; v < mesh.mesh.vertices(); ++v)
            ASSERT_NEAR(update.state->ranges[2].value(update.state->codes[2][v]), mesh.mesh.t[v],
                        1e-3);
    }
    EXPECT_GE(keys, 1);
    EXPECT_LE(keys, 8);
}

TEST(MeshStream, KeepsReleaseTimesApartThatAreSecondsSinceLongAgo) {
    core::KeyedMesh mesh = with_ids(samples::sheet(20, 20));
    const std::vector<double> since_start = mesh.mesh.t;
    constexpr double long_ago = 3.8e9; // 32 bits keep multiples of 256 of it
    for (double& t : mesh.mesh.t)
        t += long_ago;
    MeshStream stream(1, 1, lattice);
    MeshDecoder decoder;
    const EncodedUpdate update = samples::next(stream, mesh);
    ASSERT_TRUE(folds(decoder, update) && holds(decoder, update));
    const double step = std::ranges::max(since_start) / 65535.0;
    for (std::size_t v = 0; v < since_start.size(); ++v)
        ASSERT_NEAR(update.state->ranges[2].value(update.state->codes[2][v]) - long_ago,
                    since_start[v], step);
}

/// Values of two fields at each vertex, the second with gaps.
MeshFields some_fields(const core::KeyedMesh& mesh) {
    MeshFields fields(2);
    for (std::size_t v = 0; v < mesh.mesh.vertices(); ++v) {
        const core::Vec3& x = mesh.mesh.position[v];
        fields[0].push_back(static_cast<float>(3.0 * x.x - x.y + mesh.time));
        fields[1].push_back(mesh.vertex_id[v] % 5 == 0   ? std::numeric_limits<float>::quiet_NaN()
                            : mesh.vertex_id[v] % 5 == 1 ? -std::numeric_limits<float>::infinity()
                                                         : static_cast<float>(7.0 + x.z));
    }
    return fields;
}

TEST(MeshStream, CarriesFieldsBehindSpeedSAndTThroughRandomUpdates) {
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        std::mt19937 random(seed);
        samples::RandomSurface surface(seed);
        samples::PlacesTwin places;
        MeshStream stream(5, 2, lattice);
        MeshDecoder follower;
        for (int i = 0; i < 150; ++i) {
            const core::KeyedMesh mesh = surface.next();
            const MeshFields fields = some_fields(mesh);
            const UpdateOptions options = any_options(random);
            const auto update = stream.next(mesh, options, fields);
            ASSERT_TRUE(update.has_value()) << update.error().message;
            ASSERT_TRUE(folds(follower, *update) && holds(follower, *update)) << seed << " " << i;
            MeshDecoder joiner;
            const auto key = encode_key(5, *update);
            ASSERT_TRUE(folds(joiner, *key) && holds(joiner, *update)) << seed << " " << i;
            places.follow(mesh, update->key);
            const WireMesh& state = *update->state;
            ASSERT_EQ(state.codes.size(), 5u);
            ASSERT_EQ(follower.newest()->header.attribute_count, 5);
            for (std::uint32_t place = 0; place < state.vertices(); ++place) {
                const auto v = static_cast<std::size_t>(
                    std::ranges::lower_bound(mesh.vertex_id, places.vertices()[place]) -
                    mesh.vertex_id.begin());
                for (std::size_t f = 0; f < 2; ++f) {
                    const AttributeRange& range = state.ranges[3 + f];
                    const std::uint16_t code = state.codes[3 + f][place];
                    ASSERT_EQ(std::isnan(range.value(code)), !std::isfinite(fields[f][v]))
                        << seed << " " << i << " field " << f;
                    const double truth =
                        std::isfinite(fields[f][v]) ? double{fields[f][v]} : std::nan("");
                    ASSERT_LE(std::abs(range.code(truth) - code), options.tolerance.speed)
                        << seed << " " << i << " field " << f;
                }
            }
        }
    }
}

TEST(MeshStream, RefusesFieldsThatDoNotFit) {
    const core::KeyedMesh mesh = with_ids(samples::sheet(5, 6));
    MeshStream stream(1, 1, lattice);
    const std::vector<float> whole(30, 1.0f), torn(29, 1.0f);
    EXPECT_EQ(stream.next(mesh, {}, {whole, torn}).error().code, core::Error::Code::Corrupt);
    EXPECT_EQ(stream.next(mesh, {}, MeshFields(6, whole)).error().code,
              core::Error::Code::OverLimit);
    ASSERT_TRUE(stream.next(mesh, {}, MeshFields(5, whole)));
    EXPECT_EQ(stream.next(mesh, {}, {whole}).error().code, core::Error::Code::Corrupt);
    EXPECT_TRUE(stream.next(mesh, {}, MeshFields(5, whole)));
}

TEST(MeshStream, StartsFromNothingAndEndsWithNothing) {
    MeshStream stream(1, 1, lattice);
    MeshDecoder decoder;
    core::QuadComplex vertices = samples::sheet(3, 3);
    vertices.cells.clear(); // not worth sending
    const core::KeyedMesh lonely = with_ids(vertices);
    const core::KeyedMesh sheet = with_ids(samples::sheet(5, 6));
    for (const core::KeyedMesh* mesh : {&lonely, &sheet, &lonely, &sheet}) {
        const EncodedUpdate update = samples::next(stream, *mesh);
        ASSERT_TRUE(folds(decoder, update) && holds(decoder, update));
        EXPECT_EQ(decoder.newest()->mesh->cells().size(), mesh->mesh.cells.size());
        EXPECT_EQ(decoder.newest()->mesh->vertices(), mesh == &lonely ? 0u : 30u);
    }
}

TEST(MeshStream, BecomesExactWhenToldTo) {
    samples::RandomSurface surface(77);
    MeshStream stream(1, 1, lattice);
    core::KeyedMesh mesh;
    EncodedUpdate update;
    for (int i = 0; i < 30; ++i) {
        mesh = surface.next();
        update = samples::next(stream, mesh, {.phase = Phase::Live, .tolerance = {9, 900}});
        EXPECT_FALSE(update.lossless);
    }
    update = samples::next(stream, mesh);
    EXPECT_TRUE(update.lossless);
    EXPECT_EQ(update.phase, Phase::Final);
    std::vector<LatticePoint> truth;
    for (const core::Vec3& p : mesh.mesh.position)
        truth.push_back(LatticeRounding(lattice).nearest(p));
    std::vector<LatticePoint> held = update.state->position;
    std::ranges::sort(truth);
    std::ranges::sort(held);
    EXPECT_EQ(held, truth);
}

TEST(MeshStream, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto run = [](int threads) {
        std::vector<Bytes> frames;
        tbb::task_arena(threads).execute([&] {
            samples::RandomSurface surface(9, 900);
            MeshStream stream(1, 1, lattice);
            for (int i = 0; i < 24; ++i)
                for (const auto& frame :
                     samples::next(stream, surface.next(), {.tolerance = live_tolerance}).frames)
                    frames.push_back(*frame);
        });
        return frames;
    };
    EXPECT_EQ(run(1), run(2));
}

TEST(MeshStream, RefusesWhatItCannotSendAndGoesOnAsIfNothingHadHappened) {
    samples::RandomSurface surface(3);
    MeshStream stream(1, 1, lattice);
    MeshDecoder decoder;
    core::KeyedMesh mesh;
    while (mesh.mesh.vertices() < 30)
        mesh = surface.next();
    ASSERT_TRUE(folds(decoder, samples::next(stream, mesh)));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e9, 3.4e38, -7.0}) {
        core::KeyedMesh broken = mesh;
        broken.mesh.position[3].y = bad;
        EXPECT_EQ(stream.next(broken, {}).error().code, core::Error::Code::OutOfDomain) << bad;
    }
    core::KeyedMesh broken = mesh;
    std::swap(broken.vertex_id[3], broken.vertex_id[4]);
    EXPECT_EQ(stream.next(broken, {}).error().code, core::Error::Code::Corrupt);
    broken = mesh;
    broken.cell_id.pop_back();
    EXPECT_EQ(stream.next(broken, {}).error().code, core::Error::Code::Corrupt);
    const EncodedUpdate update = samples::next(stream, surface.next());
    EXPECT_EQ(update.seq, 1u);
    EXPECT_TRUE(folds(decoder, update) && holds(decoder, update));
}

} // namespace
} // namespace wakesurf::protocol::mesh_stream_test
