// Sizes that a disk announces, as a web server does, are no reason to take memory.
#include "core/base/crc32c.hpp"
#include "store/store_grid.hpp"
#include "store/store_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::store::announced_sizes_test {
namespace {

using namespace core;

constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
constexpr std::uint64_t peta = std::uint64_t{1} << 50;

std::byte byte_at(std::uint64_t place) {
    return static_cast<std::byte>(place % 251);
}

/// Every file has the size that a test says, and bytes as far as it says.
class AnnouncingDisk final : public Disk {
  public:
    Result<std::uint64_t> size(const std::filesystem::path& file) const override {
        if (file.extension() == ".crc" || file.filename() == "checksums.u32")
            return fail(Error::Code::NotFound, "there is none");
        return announced;
    }

    Result<void> read(const std::filesystem::path&,
                      std::uint64_t offset,
                      std::span<std::byte> out) const override {
        longest = std::max(longest, out.size());
        if (offset + out.size() > there)
            return fail(Error::Code::Corrupt, "it ends before");
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = byte_at(offset + i);
        return {};
    }

    std::uint64_t announced = 0, there = 0;
    mutable std::size_t longest = 0;
};

StoreLayout layout_with(const std::string& file) {
    StoreLayout layout;
    layout.folder = "/nowhere";
    layout.grid = stored_grid(UniformGrid{{0, 0, 0}, {1, 1, 1}, {3, 2, 2}});
    layout.times = {0.0};
    layout.checksums[file] = 0;
    return layout;
}

} // namespace

TEST(AnnouncedSizes, OfMoreThanAnyMemoryAreRefusedByTheFilesNameBeforeOneByteIsRead) {
    AnnouncingDisk disk;
    disk.announced = disk.there = peta;
    const auto whole = read_fixed_file(layout_with("cells.u32"), "cells.u32", peta, disk);
    ASSERT_FALSE(whole.has_value());
    EXPECT_EQ(whole.error().code, Error::Code::OverLimit);
    EXPECT_NE(whole.error().message.find("cells.u32"), std::string::npos);
    EXPECT_EQ(disk.longest, 0u);
}

TEST(AnnouncedSizes, TakeMemoryOnlyForWhatComes) {
    AnnouncingDisk disk;
    disk.announced = 100 * mebi;
    const auto whole = read_fixed_file(layout_with("points.f64"), "points.f64", 100 * mebi, disk);
    ASSERT_FALSE(whole.has_value());
    EXPECT_EQ(whole.error().code, Error::Code::Corrupt);
    EXPECT_LE(disk.longest, 16 * mebi);
}

TEST(AnnouncedSizes, ThatAreTrueAreReadWholePieceByPiece) {
    AnnouncingDisk disk;
    disk.announced = disk.there = 33 * mebi + 5;
    std::vector<std::byte> expected(disk.there);
    for (std::size_t i = 0; i < expected.size(); ++i)
        expected[i] = byte_at(i);
    StoreLayout layout = layout_with("points.f64");
    layout.checksums["points.f64"] = crc32c(expected);
    EXPECT_EQ(read_fixed_file(layout, "points.f64", disk.there, disk).value(), expected);
    EXPECT_LE(disk.longest, 16 * mebi);
}

TEST(AnnouncedSizes, OfWallsHaveALimitOfTheirOwn) {
    auto disk = std::make_shared<AnnouncingDisk>();
    disk->announced = 1024 * 1024 * mebi;
    StoreLayout layout = layout_with("walls.f32");
    layout.walls = true;
    const auto reader = StoreReader::open(layout, disk);
    ASSERT_TRUE(reader.has_value()) << reader.error().message;
    const auto walls = (*reader)->load_walls();
    ASSERT_FALSE(walls.has_value());
    EXPECT_EQ(walls.error().code, Error::Code::OverLimit);
    EXPECT_EQ(walls.error().message, "walls.f32 has 1099511627776 bytes, and walls may have 1 GiB");
    EXPECT_EQ(disk->longest, 0u);
}

TEST(AnnouncedSizes, OfAGridWhoseMaskNoMemoryHoldsAreRefused) {
    auto disk = std::make_shared<AnnouncingDisk>();
    disk->announced = 1;
    StoreLayout layout = layout_with("mask.u8");
    layout.grid = stored_grid(UniformGrid{{0, 0, 0}, {1, 1, 1}, {1u << 16, 1u << 15, 1u << 15}});
    layout.mask = true;
    const auto reader = StoreReader::open(layout, disk);
    ASSERT_FALSE(reader.has_value());
    EXPECT_EQ(reader.error().code, Error::Code::OverLimit);
    EXPECT_NE(reader.error().message.find("mask"), std::string::npos);
}

} // namespace wakesurf::store::announced_sizes_test
