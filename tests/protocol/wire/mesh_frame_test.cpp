#include "protocol/wire/mesh_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace wakesurf::protocol::mesh_frame_test {
namespace {

Bytes bytes_of(const std::string& text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

const Bytes body = bytes_of("a piece of an update");

MeshFrame sample(std::uint8_t flags = FrameHeader::key | FrameHeader::lossless) {
    return {{.flags = flags,
             .surface = 1,
             .epoch = 0xfedcba98u,
             .seq = 3,
             .frame_index = 0,
             .frame_count = 2,
             .phase = Phase::Live,
             .lattice_bits = 16,
             .attribute_count = 2,
             .vertices = 6,
             .cells = 7,
             .time = -2.5,
             .state_sum = 8},
            body};
}

/// Why bytes are refused; empty where they are read.
std::string refusal(std::span<const std::byte> bytes) {
    const auto read = read_frame(bytes);
    return read ? std::string() : read.error().message;
}

const std::string no_frame = "a binary message is not a mesh frame";
const std::string wrong_checksum = "a mesh frame does not match its checksum";
const std::string unknown = "a mesh frame has flags or a phase that this version does not know";
const std::string contradiction = "a mesh frame's header contradicts itself";

/// With the checksum made right again, so that the other checks are reached.
Bytes with(Bytes bytes, std::size_t offset, std::uint64_t value, std::size_t size = 4) {
    std::memcpy(bytes.data() + offset, &value, size);
    const std::uint32_t crc = frame_crc(bytes);
    std::memcpy(bytes.data() + frame_crc_at, &crc, 4);
    return bytes;
}

TEST(MeshFrame, ReadsBackWhatItWrote) {
    for (const MeshFrame& frame : {sample(), sample(0)}) {
        const Bytes bytes = write_frame(frame);
        EXPECT_EQ(bytes.size(), frame_header_bytes + body.size());
        const auto read = read_frame(bytes);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        EXPECT_EQ(read->header, frame.header);
        EXPECT_TRUE(std::ranges::equal(read->body, body));
    }
}

TEST(MeshFrame, LiesInMemoryAsSpecified) {
    const Bytes bytes = write_frame(sample());
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 0), 'W');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 1), 'S');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 2), 5);
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 3), 3);
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 8), 0x98) << "little-endian epoch";
    EXPECT_EQ(number_at<std::uint16_t>(bytes, 18), 2u) << "frame count";
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 20), 3) << "phase";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 24), 6u) << "vertices";
    EXPECT_EQ(number_at<double>(bytes, 32), -2.5);
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 40), 8u) << "state sum";
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 48), 'a') << "body";
}

TEST(MeshFrame, HasTheChecksumOfZlib) {
    Bytes bytes = bytes_of("12345678");
    bytes.resize(frame_header_bytes); // the sum leaves out bytes 44 to 47
    EXPECT_EQ(frame_crc(bytes), 0x84e2252du);
}

TEST(MeshFrame, IsRefusedWhenAnySingleBitFlips) {
    const Bytes bytes = write_frame(sample());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes flipped = bytes;
        flipped[bit / 8] ^= std::byte{1} << (bit % 8);
        if (bit / 8 < 2)
            EXPECT_EQ(refusal(flipped), no_frame) << "bit " << bit;
        else if (bit / 8 == 2)
            EXPECT_EQ(read_frame(flipped).error().code, core::Error::Code::Unsupported);
        else
            EXPECT_EQ(refusal(flipped), wrong_checksum) << "bit " << bit;
    }
}

TEST(MeshFrame, IsRefusedWhenCutOffOrFollowedByMore) {
    Bytes bytes = write_frame(sample());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_EQ(refusal(std::span(bytes).first(size)), size < 3 ? no_frame : wrong_checksum)
            << size;
    bytes.push_back(std::byte{0});
    EXPECT_EQ(refusal(bytes), wrong_checksum);
}

TEST(MeshFrame, IsRefusedWhenItsHeaderCannotBeTrue) {
    const Bytes good = write_frame(sample());
    ASSERT_EQ(refusal(with(good, 4, 1)), "");
    EXPECT_EQ(read_frame(with(good, 2, 3, 1)).error().code, core::Error::Code::Unsupported);
    EXPECT_EQ(refusal(with(good, 3, 4 + 1, 1)), unknown) << "flag";
    EXPECT_EQ(refusal(with(good, 12, 0)), "") << "a KEY is the first update";
    EXPECT_EQ(refusal(with(write_frame(sample(0)), 12, 0)), contradiction) << "a DELTA is not";
    EXPECT_EQ(refusal(with(good, 16, 2, 2)), contradiction) << "frame 2 of 2";
    EXPECT_EQ(refusal(with(good, 18, 0, 2)), contradiction) << "no frames";
    EXPECT_EQ(refusal(with(good, 20, 4, 1)), unknown) << "phase";
    EXPECT_EQ(refusal(with(good, 21, 0, 1)), contradiction) << "lattice bits";
    EXPECT_EQ(refusal(with(good, 21, 21, 1)), contradiction) << "lattice bits";
    EXPECT_EQ(read_frame(with(good, 22, 9, 1)).error().code, core::Error::Code::OverLimit)
        << "attributes";
    EXPECT_EQ(refusal(with(good, 23, 3, 1)), "") << "both have gaps";
    EXPECT_EQ(refusal(with(good, 23, 4, 1)), contradiction) << "gaps of a third attribute";
    for (const std::size_t count : {24u, 28u})
        EXPECT_EQ(read_frame(with(good, count, 0xffffffffu)).error().code,
                  core::Error::Code::OverLimit);
    EXPECT_EQ(refusal(with(good, 32, 0x7ff0000000000000u, 8)), contradiction) << "time";
}

} // namespace
} // namespace wakesurf::protocol::mesh_frame_test
