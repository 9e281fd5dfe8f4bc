#include "core/base/crc32c.hpp"
#include "protocol/wire/mesh_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

namespace wakesurf::protocol {
namespace {

Bytes bytes_of(const std::string& text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

const Bytes topology = bytes_of("cells");
const Bytes points = bytes_of("points");

MeshFrame sample(std::uint8_t flags = FrameHeader::key | FrameHeader::lossless) {
    MeshFrame frame;
    frame.header = {.flags = flags,
                    .surface = 1,
                    .epoch = 0xfedcba98u,
                    .seq = 3,
                    .base_seq = 3,
                    .frame_index = 0,
                    .frame_count = 2,
                    .phase = Phase::Live,
                    .lattice_bits = 16,
                    .attribute_count = 2,
                    .vertices = 6,
                    .cells = 7,
                    .topology_size = 9,
                    .time = -2.5,
                    .topology_bytes = 5,
                    .points_bytes = 6,
                    .state_sum = 8};
    if ((flags & FrameHeader::key) != 0)
        frame.ranges = {{-1.5f, 2.f}, {0.f, 0.f}};
    else
        frame.header.base_seq = 2;
    frame.topology = topology;
    frame.points = points;
    return frame;
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
    const std::uint32_t crc = core::crc32c(std::span(bytes).subspan(frame_header_bytes),
                                           core::crc32c(std::span(bytes).first(60)));
    std::memcpy(bytes.data() + 60, &crc, 4);
    return bytes;
}

TEST(MeshFrame, ReadsBackWhatItWrote) {
    for (const MeshFrame& frame : {sample(), sample(0)}) {
        const Bytes bytes = write_frame(frame);
        EXPECT_EQ(bytes.size(), frame_header_bytes + 8 * frame.ranges.size() + 6 + 5);
        const auto read = read_frame(bytes);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        EXPECT_EQ(read->header, frame.header);
        EXPECT_EQ(read->ranges, frame.ranges);
        EXPECT_TRUE(std::ranges::equal(read->topology, topology));
        EXPECT_TRUE(std::ranges::equal(read->points, points));
    }
}

TEST(MeshFrame, LiesInMemoryAsSpecified) {
    const Bytes bytes = write_frame(sample());
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 0), 'W');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 1), 'S');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 2), 3);
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 3), 3);
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 8), 0x98) << "little-endian epoch";
    EXPECT_EQ(number_at<std::uint16_t>(bytes, 22), 2u) << "frame count";
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 24), 3) << "phase";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 28), 6u) << "vertices";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 36), 9u) << "topology of the update";
    EXPECT_EQ(number_at<double>(bytes, 40), -2.5);
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 48), 5u) << "topology in the frame";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 56), 8u) << "state sum";
    EXPECT_EQ(number_at<float>(bytes, 64), -1.5f) << "first range";
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
    EXPECT_EQ(refusal(with(bytes, 4, 1)), "a mesh frame of 92 bytes announces 91");
}

TEST(MeshFrame, IsRefusedWhenItsHeaderCannotBeTrue) {
    const Bytes good = write_frame(sample());
    ASSERT_EQ(refusal(with(good, 4, 1)), "");
    EXPECT_EQ(read_frame(with(good, 2, 1, 1)).error().code, core::Error::Code::Unsupported);
    EXPECT_EQ(refusal(with(good, 3, 8 + 1, 1)), unknown) << "flag";
    EXPECT_EQ(refusal(with(good, 12, 4)), contradiction) << "a KEY on another state";
    const Bytes delta = write_frame(sample(0));
    EXPECT_EQ(refusal(with(delta, 16, 3)), contradiction) << "a DELTA on its own state";
    EXPECT_EQ(refusal(with(delta, 3, 4, 1)), unknown) << "a DELTA with history";
    EXPECT_EQ(refusal(with(good, 20, 2, 2)), "a mesh frame of 91 bytes announces 75")
        << "frame 2 of 2, which has no ranges";
    EXPECT_EQ(refusal(with(delta, 20, 2, 2)), contradiction) << "frame 2 of 2";
    EXPECT_EQ(refusal(with(good, 22, 0, 2)), contradiction) << "no frames";
    EXPECT_EQ(refusal(with(good, 24, 4, 1)), unknown) << "phase";
    EXPECT_EQ(refusal(with(good, 25, 0, 1)), contradiction) << "lattice bits";
    EXPECT_EQ(refusal(with(good, 25, 21, 1)), contradiction) << "lattice bits";
    EXPECT_EQ(refusal(with(good, 26, 3, 1)), "a mesh frame of 91 bytes announces 99")
        << "attributes";
    EXPECT_EQ(refusal(with(good, 27, 1, 1)), unknown) << "reserved";
    for (const std::size_t count : {28u, 32u})
        EXPECT_EQ(read_frame(with(good, count, 0xffffffffu)).error().code,
                  core::Error::Code::OverLimit);
    EXPECT_EQ(refusal(with(good, 36, 4)), contradiction) << "less topology than here";
    EXPECT_EQ(refusal(with(good, 40, 0x7ff0000000000000u, 8)), contradiction) << "time";
    EXPECT_EQ(refusal(with(good, 48, 6)), "a mesh frame of 91 bytes announces 92") << "topology";
    EXPECT_EQ(refusal(with(good, 52, 0xffffffffu)), "a mesh frame of 91 bytes announces 4294967380")
        << "points";
}

TEST(MeshFrame, IsRefusedWithoutUsableRanges) {
    for (const AttributeRange range :
         {AttributeRange{2.f, 1.f}, AttributeRange{0.f, std::numeric_limits<float>::infinity()},
          AttributeRange{std::numeric_limits<float>::quiet_NaN(), 1.f}}) {
        MeshFrame frame = sample();
        frame.ranges[1] = range;
        EXPECT_EQ(refusal(write_frame(frame)), "a mesh frame has an attribute without a range");
    }
}

} // namespace
} // namespace wakesurf::protocol
