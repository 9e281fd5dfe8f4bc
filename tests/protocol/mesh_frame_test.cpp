#include "core/base/crc32c.hpp"
#include "protocol/mesh_frame.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace wakesurf::protocol {
namespace {

Bytes bytes_of(const std::string& text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

const Bytes draco = bytes_of("points");
const Bytes cells = bytes_of("cells");

MeshFrame sample() {
    MeshFrame frame;
    frame.header = {.flags = FrameHeader::last | FrameHeader::final,
                    .surface = 1,
                    .epoch = 0xfedcba98u,
                    .seq = 3,
                    .vertex_base = 4,
                    .vertex_count = 5,
                    .cell_base = 6,
                    .cell_count = 7,
                    .attribute_count = 2,
                    .lattice_bits = 16,
                    .draco_bytes = 6,
                    .cell_bytes = 5,
                    .state_crc = 8};
    frame.ranges = {{-1.5f, 2.f}, {0.f, 0.f}};
    frame.draco = draco;
    frame.cells = cells;
    return frame;
}

/// With the checksum made right again, so that the other checks are reached.
Bytes with(Bytes bytes, std::size_t offset, std::uint32_t value, std::size_t size = 4) {
    std::memcpy(bytes.data() + offset, &value, size);
    const std::uint32_t crc = core::crc32c(std::span(bytes).subspan(frame_header_bytes),
                                           core::crc32c(std::span(bytes).first(48)));
    std::memcpy(bytes.data() + 48, &crc, 4);
    return bytes;
}

TEST(MeshFrame, ReadsBackWhatItWrote) {
    const MeshFrame frame = sample();
    const Bytes bytes = write_frame(frame);
    EXPECT_EQ(bytes.size(), frame_header_bytes + 16 + 6 + 5);
    const auto read = read_frame(bytes);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_EQ(read->header, frame.header);
    EXPECT_EQ(read->ranges, frame.ranges);
    EXPECT_TRUE(std::ranges::equal(read->draco, draco));
    EXPECT_TRUE(std::ranges::equal(read->cells, cells));
}

TEST(MeshFrame, LiesInMemoryAsSpecified) {
    const Bytes bytes = write_frame(sample());
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 0), 'W');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 1), 'S');
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 2), 1);
    EXPECT_EQ(number_at<std::uint8_t>(bytes, 8), 0x98) << "little-endian epoch";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 28), 7u) << "cell count";
    EXPECT_EQ(number_at<float>(bytes, 52), -1.5f) << "first range";
}

TEST(MeshFrame, IsRefusedWhenAnySingleBitFlips) {
    const Bytes bytes = write_frame(sample());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes flipped = bytes;
        flipped[bit / 8] ^= std::byte{1} << (bit % 8);
        EXPECT_FALSE(read_frame(flipped).has_value()) << "bit " << bit;
    }
}

TEST(MeshFrame, IsRefusedWhenCutOffOrFollowedByMore) {
    Bytes bytes = write_frame(sample());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(read_frame(std::span(bytes).first(size)).has_value()) << size;
    bytes.push_back(std::byte{0});
    EXPECT_FALSE(read_frame(bytes).has_value());
    EXPECT_FALSE(read_frame(with(bytes, 4, 1)).has_value()) << "with a matching checksum";
}

TEST(MeshFrame, IsRefusedWhenItsHeaderCannotBeTrue) {
    const Bytes good = write_frame(sample());
    ASSERT_TRUE(read_frame(with(good, 4, 1)).has_value());
    EXPECT_EQ(read_frame(with(good, 2, 2, 1)).error().code, core::Error::Code::Unsupported);
    EXPECT_FALSE(read_frame(with(good, 3, 8, 1)).has_value()) << "unknown flag";
    EXPECT_FALSE(read_frame(with(good, 3, 1, 1)).has_value()) << "first, yet not from vertex 0";
    for (const std::size_t base : {16u, 24u})
        EXPECT_EQ(read_frame(with(good, base, 0xffffffffu)).error().code,
                  core::Error::Code::OverLimit);
    EXPECT_FALSE(read_frame(with(good, 20, max_frame_vertices + 1)).has_value());
    EXPECT_FALSE(read_frame(with(good, 28, max_frame_cells + 1)).has_value());
    EXPECT_FALSE(read_frame(with(good, 20, 0)).has_value()) << "points for no vertices";
    EXPECT_FALSE(read_frame(with(good, 28, 0)).has_value()) << "code for no cells";
    EXPECT_FALSE(read_frame(with(good, 32, 3, 1)).has_value()) << "attributes";
    EXPECT_FALSE(read_frame(with(good, 33, 0, 1)).has_value()) << "lattice bits";
    EXPECT_FALSE(read_frame(with(good, 33, 21, 1)).has_value()) << "lattice bits";
    EXPECT_FALSE(read_frame(with(good, 36, 7)).has_value()) << "Draco bytes";
    EXPECT_FALSE(read_frame(with(good, 40, 0xffffffffu)).has_value()) << "cell bytes";
}

TEST(MeshFrame, IsRefusedWithoutUsableRanges) {
    for (const AttributeRange range :
         {AttributeRange{2.f, 1.f}, AttributeRange{0.f, std::numeric_limits<float>::infinity()},
          AttributeRange{std::numeric_limits<float>::quiet_NaN(), 1.f}}) {
        MeshFrame frame = sample();
        frame.ranges[1] = range;
        EXPECT_FALSE(read_frame(write_frame(frame)).has_value());
    }
}

} // namespace
} // namespace wakesurf::protocol
