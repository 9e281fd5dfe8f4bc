#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/numbers.hpp"
#include "tests/protocol/wire/sample_sequences.hpp"
#include "tests/support/same_state.hpp"

#include <bit>
#include <cstring>
#include <ctime>
#include <limits>
#include <map>

namespace wakesurf::protocol::mesh_decoder_test {
namespace {

const Lattice lattice = lattice_over(samples::domain);

bool folds(MeshDecoder& decoder, const SharedFrames& frames) {
    for (const auto& frame : frames)
        if (!decoder.fold(*frame))
            return false;
    return !decoder.needs_key();
}

/// Of three frames and more: 90,000 vertices, none of which is foreseen.
SharedFrames long_key(std::uint32_t epoch = 1, std::uint32_t seq = 0) {
    return samples::encode(samples::chaos(90'000, 10, 1), {.epoch = epoch, .seq = seq}).frames;
}

SharedFrames short_key(std::uint32_t epoch, std::uint32_t seq, bool final = false) {
    return samples::encode(samples::hanging_sheet(6, 20, 3),
                           {.surface = 0, .epoch = epoch, .seq = seq, .final = final})
        .frames;
}

TEST(MeshDecoder, ShowsACoarseStateThenTheFinalOneOfTheSameEpoch) {
    MeshDecoder decoder;
    EXPECT_TRUE(decoder.needs_key());
    ASSERT_TRUE(folds(decoder, short_key(4, 0)));
    EXPECT_EQ(decoder.newest()->header.phase, Phase::Coarse);
    ASSERT_TRUE(folds(decoder, short_key(4, 1, true)));
    EXPECT_EQ(decoder.newest()->header.phase, Phase::Final);
    EXPECT_EQ(decoder.newest()->mesh->vertices(), 120u);
    ASSERT_TRUE(folds(decoder, short_key(5, 0)));
    EXPECT_EQ(decoder.newest()->header.epoch, 5u);
}

TEST(MeshDecoder, ShowsAStateOnlyWhenAllItsFramesAreThere) {
    MeshDecoder decoder;
    ASSERT_TRUE(folds(decoder, short_key(1, 0)));
    const auto frames = long_key(1, 1);
    ASSERT_GE(frames.size(), 3u);
    for (const auto& frame : frames) {
        EXPECT_EQ(decoder.newest()->mesh->vertices(), 120u);
        ASSERT_TRUE(decoder.fold(*frame).has_value());
    }
    EXPECT_EQ(decoder.newest()->mesh->vertices(), 90'000u);
}

TEST(MeshDecoder, RefusesLostRepeatedAndReorderedFramesUntilAKeyComes) {
    const auto f = long_key();
    ASSERT_GE(f.size(), 3u);
    for (const auto& bad :
         {std::vector{f[0], f[2]}, std::vector{f[0], f[1], f[1]}, std::vector{f[1]}}) {
        MeshDecoder decoder;
        for (std::size_t i = 0; i + 1 < bad.size(); ++i)
            ASSERT_TRUE(decoder.fold(*bad[i]).has_value());
        EXPECT_FALSE(decoder.fold(*bad.back()).has_value());
        EXPECT_FALSE(decoder.fold(*f[1]).has_value()) << "nothing continues a broken update";
        EXPECT_TRUE(decoder.needs_key());
        EXPECT_TRUE(folds(decoder, long_key(2)));
    }
}

TEST(MeshDecoder, TakesAKeyAmidAnUnfinishedUpdate) {
    MeshDecoder decoder;
    ASSERT_TRUE(decoder.fold(*long_key(3, 1)[0]).has_value());
    EXPECT_TRUE(folds(decoder, short_key(3, 2)));
    EXPECT_FALSE(folds(decoder, {long_key(3, 1)[1]}));
}

TEST(MeshDecoder, RefusesEarlierEpochsAndUpdatesAndOtherSurfaces) {
    MeshDecoder decoder;
    ASSERT_TRUE(folds(decoder, short_key(7, 3)));
    EXPECT_FALSE(folds(decoder, short_key(6, 9)));
    EXPECT_FALSE(folds(decoder, short_key(7, 2)));
    EXPECT_FALSE(
        folds(decoder, samples::encode(samples::sheet(3, 3), {.surface = 1, .epoch = 8}).frames));
    EXPECT_TRUE(folds(decoder, short_key(7, 3))) << "the same state again heals";
}

/// Updates of a live surface, and the state after each.
struct Sequence {
    std::vector<EncodedUpdate> updates;

    explicit Sequence(std::uint32_t seed, int count = 40, std::uint32_t columns = 12) {
        samples::RandomSurface surface(seed, columns);
        MeshStream stream(1, 1, lattice);
        for (int i = 0; i < count; ++i)
            updates.push_back(samples::next(stream, surface.next(), {.tolerance = live_tolerance}));
    }
};

TEST(MeshDecoder, TakesADeltaOnlyOnTheStateItStartsFrom) {
    const Sequence sequence(11);
    for (std::size_t lost = 1; lost + 1 < sequence.updates.size(); ++lost) {
        if (sequence.updates[lost + 1].key)
            continue;
        MeshDecoder decoder;
        for (std::size_t i = 0; i < lost; ++i)
            ASSERT_TRUE(folds(decoder, sequence.updates[i].frames));
        EXPECT_FALSE(folds(decoder, sequence.updates[lost + 1].frames));
        if (!sequence.updates[lost].key) {
            EXPECT_FALSE(folds(decoder, sequence.updates[lost].frames)) << "too late";
        }
        const auto key = encode_key(1, sequence.updates[lost]);
        ASSERT_TRUE(folds(decoder, key->frames));
        EXPECT_TRUE(folds(decoder, sequence.updates[lost + 1].frames));
    }
}

TEST(MeshDecoder, ShufflingFramesNeverGivesAWrongMesh) {
    std::mt19937 random(5);
    const Sequence sequence(12);
    std::map<std::uint32_t, std::uint32_t> sums;
    for (const EncodedUpdate& update : sequence.updates)
        sums[update.seq] = update.state_sum;
    for (int round = 0; round < 200; ++round) {
        MeshDecoder decoder;
        for (std::size_t i = 0; i < sequence.updates.size(); ++i) {
            const bool astray = random() % 10 == 0;
            const auto& update = sequence.updates[astray ? random() % sequence.updates.size() : i];
            folds(decoder, update.frames);
            if (decoder.needs_key() && random() % 2 == 0)
                folds(decoder, encode_key(1, sequence.updates[i])->frames);
            if (decoder.newest()) {
                const DecodedState& state = *decoder.newest();
                ASSERT_EQ(state_sum(*state.mesh), sums.at(state.header.seq));
            }
        }
    }
}

TEST(MeshDecoder, RefusesEveryMutatedOrTruncatedFrameAndComesBackWithAKey) {
    std::mt19937 random(3);
    const Sequence sequence(13);
    const std::clock_t before = std::clock();
    MeshDecoder good;
    for (const EncodedUpdate& update : sequence.updates) {
        for (int i = 0; i < 60; ++i) {
            Bytes bad = *update.frames.front();
            if (i % 2 == 0)
                bad[random() % bad.size()] ^= static_cast<std::byte>(1 + random() % 255);
            else
                bad.resize(random() % bad.size());
            const auto held = good.newest();
            ASSERT_FALSE(good.fold(bad).has_value())
                << "update " << update.seq << ", mutation " << i;
            EXPECT_TRUE(good.needs_key());
            EXPECT_EQ(good.newest().has_value(), held.has_value()) << "what was there stays";
        }
        ASSERT_TRUE(folds(good, encode_key(1, update)->frames));
        ASSERT_TRUE(tests::same_state(*good.newest()->mesh, *update.state));
    }
    EXPECT_LT(std::clock() - before, 20 * CLOCKS_PER_SEC) << "of the processor";
}

/// Overwrites the frame's own checksum with the right one.
Bytes sealed(Bytes frame) {
    const std::uint32_t crc = frame_crc(frame);
    std::memcpy(frame.data() + frame_crc_at, &crc, 4);
    return frame;
}

// Frames with a right checksum and wrong content: what a faulty server could send.
TEST(MeshDecoder, NeverShowsAWrongMeshFromDamageBehindARightChecksum) {
    const Sequence sequence(14, 24, 20);
    const EncodedUpdate& last = sequence.updates.back();
    ASSERT_FALSE(last.key);
    MeshDecoder ready;
    const auto base = encode_key(1, sequence.updates[sequence.updates.size() - 2]);
    std::mt19937 random(9);
    for (const SharedFrames& good : {base->frames, last.frames}) {
        for (int i = 0; i < 2'000; ++i) {
            Bytes bad = *good.front();
            bad[random() % bad.size()] ^= static_cast<std::byte>(1 + random() % 255);
            MeshDecoder decoder;
            if (good == last.frames) {
                ASSERT_TRUE(folds(decoder, base->frames));
            }
            const auto right = good == last.frames ? last.state_sum : base->state_sum;
            if (decoder.fold(sealed(bad)).value_or(false)) {
                ASSERT_EQ(state_sum(*decoder.newest()->mesh), right) << i;
            }
        }
    }
}

/// An update of numbers alone, with no vertex.
Bytes update_of(const std::vector<std::uint32_t>& numbers, std::uint8_t attributes = 0) {
    FrameHeader header;
    header.flags = FrameHeader::key;
    header.attribute_count = attributes;
    header.state_sum = state_sum(WireMesh());
    return write_frame({header, *pack_numbers(numbers)});
}

TEST(MeshDecoder, RefusesAnUpdateThatEndsEarlyOrGoesOn) {
    const std::vector<std::uint32_t> empty(6); // no runs, nothing added
    ASSERT_TRUE(MeshDecoder().fold(update_of(empty)).has_value());
    EXPECT_EQ(MeshDecoder().fold(update_of({empty.begin(), empty.end() - 1})).error().message,
              "the topology of a mesh update is damaged");
    EXPECT_EQ(MeshDecoder().fold(update_of(std::vector<std::uint32_t>(7))).error().message,
              "a mesh update goes on after its last vertex");
    EXPECT_EQ(MeshDecoder().fold(update_of({}, 1)).error().message,
              "a mesh update ends within its ranges");
}

TEST(MeshDecoder, RefusesAnAttributeWithoutUsableRange) {
    for (const auto& [lo, hi] : {std::pair{2.f, 1.f},
                                 {0.f, std::numeric_limits<float>::infinity()},
                                 {std::numeric_limits<float>::quiet_NaN(), 1.f}}) {
        std::vector<std::uint32_t> numbers(8);
        numbers[0] = std::bit_cast<std::uint32_t>(lo);
        numbers[1] = std::bit_cast<std::uint32_t>(hi);
        EXPECT_EQ(MeshDecoder().fold(update_of(numbers, 1)).error().message,
                  "a mesh update has an attribute without a range");
    }
}

TEST(MeshDecoder, NoticesAMeshThatIsNotTheServersByTheStateChecksum) {
    Bytes frame = *short_key(1, 0)[0];
    frame[40] ^= std::byte{1};
    MeshDecoder decoder;
    const auto result = decoder.fold(sealed(frame));
    ASSERT_FALSE(result.has_value());
    EXPECT_NE(result.error().message.find("checksum"), std::string::npos);
    EXPECT_FALSE(decoder.newest().has_value());
}

} // namespace
} // namespace wakesurf::protocol::mesh_decoder_test
