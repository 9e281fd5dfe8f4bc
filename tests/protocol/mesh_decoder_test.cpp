#include "core/base/crc32c.hpp"
#include "protocol/mesh_decoder.hpp"
#include "tests/protocol/sample_meshes.hpp"

namespace wakesurf::protocol {
namespace {

/// Three frames and more: 90,000 vertices.
EncodedState long_state(std::uint32_t epoch = 1, std::uint32_t first_seq = 0) {
    return samples::encode(samples::sheet(300, 300), {.epoch = epoch, .first_seq = first_seq});
}

EncodedState short_state(std::uint32_t epoch, std::uint32_t first_seq, bool final = false) {
    return samples::encode(samples::hanging_sheet(6, 20, 3),
                           {.surface = 0, .epoch = epoch, .first_seq = first_seq, .final = final});
}

bool folds(MeshDecoder& decoder, const EncodedState& state) {
    for (const auto& frame : state.frames)
        if (!decoder.fold(*frame))
            return false;
    return decoder.mesh().complete;
}

TEST(MeshDecoder, ShowsACoarseStateThenTheFinalOneOfTheSameEpoch) {
    MeshDecoder decoder;
    ASSERT_TRUE(folds(decoder, short_state(4, 0)));
    EXPECT_FALSE(decoder.mesh().final);
    ASSERT_TRUE(folds(decoder, short_state(4, 1, true)));
    EXPECT_TRUE(decoder.mesh().final);
    EXPECT_EQ(decoder.mesh().position.size(), 120u);
    ASSERT_TRUE(folds(decoder, short_state(5, 0)));
    EXPECT_FALSE(decoder.mesh().final);
}

TEST(MeshDecoder, IsCompleteOnlyAfterTheLastFrame) {
    MeshDecoder decoder;
    const EncodedState state = long_state();
    for (const auto& frame : state.frames) {
        EXPECT_FALSE(decoder.mesh().complete);
        ASSERT_TRUE(decoder.fold(*frame).has_value());
    }
    EXPECT_TRUE(decoder.mesh().complete);
    EXPECT_EQ(decoder.mesh().state_crc, state.state_crc);
}

TEST(MeshDecoder, RefusesLostRepeatedAndReorderedFramesUntilANewMeshStarts) {
    const EncodedState state = long_state();
    ASSERT_GE(state.frames.size(), 3u);
    const auto& f = state.frames;
    for (const auto& bad : {std::vector{f[0], f[2]}, std::vector{f[0], f[1], f[1]},
                            std::vector{f[0], f[0]}, std::vector{f[1]}}) {
        MeshDecoder decoder;
        for (std::size_t i = 0; i + 1 < bad.size(); ++i)
            ASSERT_TRUE(decoder.fold(*bad[i]).has_value());
        EXPECT_FALSE(decoder.fold(*bad.back()).has_value());
        EXPECT_FALSE(decoder.fold(*f[1]).has_value()) << "nothing continues a broken mesh";
        EXPECT_TRUE(folds(decoder, long_state(2)));
    }
}

TEST(MeshDecoder, RefusesEarlierEpochsAndOtherSurfaces) {
    MeshDecoder decoder;
    ASSERT_TRUE(folds(decoder, short_state(7, 3)));
    EXPECT_FALSE(folds(decoder, short_state(6, 9)));
    EXPECT_FALSE(folds(decoder, short_state(7, 3)));
    const auto other = samples::encode(samples::sheet(3, 3), {.surface = 1, .epoch = 8});
    EXPECT_FALSE(folds(decoder, other));
    EXPECT_TRUE(folds(decoder, short_state(7, 4)));
}

TEST(MeshDecoder, RefusesAFrameThatContinuesAnotherState) {
    MeshDecoder decoder;
    ASSERT_TRUE(decoder.fold(*long_state(1).frames[0]).has_value());
    EXPECT_FALSE(decoder.fold(*long_state(2).frames[1]).has_value());
}

/// Overwrites the frame's own checksum with the right one.
Bytes sealed(Bytes frame) {
    if (frame.size() >= frame_header_bytes) {
        const std::uint32_t crc = core::crc32c(std::span(frame).subspan(frame_header_bytes),
                                               core::crc32c(std::span(frame).first(48)));
        std::memcpy(frame.data() + 48, &crc, 4);
    }
    return frame;
}

TEST(MeshDecoder, NoticesAMeshThatIsNotTheServersByTheStateChecksum) {
    Bytes frame = *short_state(1, 0).frames[0];
    frame[44] ^= std::byte{1};
    MeshDecoder decoder;
    const auto result = decoder.fold(sealed(frame));
    ASSERT_FALSE(result.has_value());
    EXPECT_NE(result.error().message.find("checksum"), std::string::npos);
    EXPECT_FALSE(decoder.mesh().complete);
}

// Frames with a right checksum and wrong content: what a faulty server could send.
TEST(MeshDecoder, AnswersDamageBehindARightChecksumWithAnError) {
    const Bytes good = *short_state(1, 0).frames[0];
    const std::size_t draco_end = good.size() - number_at<std::uint32_t>(good, 40);
    std::mt19937 random(9);
    int accepted = 0;
    for (int i = 0; i < 2'000; ++i) {
        Bytes bad = good;
        // Header and cells code; Draco's own block is below.
        auto at = random() % (60 + good.size() - draco_end);
        at = at < 60 ? at : at - 60 + draco_end;
        bad[at] ^= static_cast<std::byte>(1 + random() % 255);
        MeshDecoder decoder;
        if (decoder.fold(sealed(bad)) &&
            number_at<std::uint32_t>(bad, 44) != number_at<std::uint32_t>(good, 44))
            ++accepted;
    }
    EXPECT_EQ(accepted, 0);
}

TEST(MeshDecoder, AnswersADamagedDracoBlockWithAnError) {
    const Bytes good = *short_state(1, 0).frames[0];
    MeshDecoder whole;
    ASSERT_TRUE(whole.fold(good).has_value());
    const std::size_t draco = frame_header_bytes + 3 * 8;
    const std::size_t size = number_at<std::uint32_t>(good, 36);
    std::mt19937 random(10);
    for (int i = 0; i < 2'000; ++i) {
        Bytes bad = good;
        bad[draco + random() % size] ^= static_cast<std::byte>(1 + random() % 255);
        MeshDecoder decoder;
        // Attributes are not part of the state's checksum, so damage to them alone may pass.
        if (decoder.fold(sealed(bad)).has_value()) {
            ASSERT_EQ(decoder.mesh().position, whole.mesh().position);
        }
    }
}

} // namespace
} // namespace wakesurf::protocol
