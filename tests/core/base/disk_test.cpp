#include "core/base/disk.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

namespace wakesurf::core::disk_test {
namespace {

using tests::TemporaryFolder;
using tests::write_file;

std::string
text(const Disk& disk, const std::filesystem::path& file, std::uint64_t at, std::size_t n) {
    std::string out(n, '?');
    const auto read = disk.read(file, at, std::as_writable_bytes(std::span(out)));
    return read ? out : read.error().message;
}

TEST(PosixDisk, ReadsAnyPartOfAFile) {
    const TemporaryFolder folder;
    write_file(folder / "a", "0123456789");
    EXPECT_EQ(PosixDisk().size(folder / "a").value(), 10u);
    EXPECT_EQ(text(PosixDisk(), folder / "a", 3, 4), "3456");
    EXPECT_EQ(text(PosixDisk(), folder / "a", 0, 0), "");
}

TEST(PosixDisk, TellsAMissingFileFromOneThatEndsTooEarly) {
    const TemporaryFolder folder;
    write_file(folder / "a", "0123");
    std::array<std::byte, 5> out{};
    EXPECT_EQ(PosixDisk().read(folder / "a", 0, out).error().code, Error::Code::Corrupt);
    EXPECT_EQ(PosixDisk().read(folder / "b", 0, out).error().code, Error::Code::NotFound);
    EXPECT_EQ(PosixDisk().size(folder / "b").error().code, Error::Code::NotFound);
}

TEST(PosixDisk, RefusesFoldersAndPipesInsteadOfHanging) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::array<std::byte, 1> out{};
    EXPECT_EQ(PosixDisk().read(folder / "pipe", 0, out).error().code, Error::Code::Io);
    EXPECT_EQ(PosixDisk().size(folder.path()).error().code, Error::Code::Io);
}

TEST(PosixDisk, NamesNoFolderInItsMessages) {
    const TemporaryFolder folder;
    std::array<std::byte, 1> out{};
    const auto message = PosixDisk().read(folder / "gone.f32", 0, out).error().message;
    EXPECT_NE(message.find("gone.f32"), std::string::npos) << message;
    EXPECT_EQ(message.find('/'), std::string::npos) << message;
}

TEST(PosixDisk, TellsAReplacedFileFromTheOneBefore) {
    const TemporaryFolder folder;
    write_file(folder / "a", "1111");
    const auto before = PosixDisk().identity(folder / "a").value();
    EXPECT_EQ(PosixDisk().identity(folder / "a").value(), before);
    write_file(folder / "b", "2222");
    std::filesystem::rename(folder / "b", folder / "a");
    EXPECT_NE(PosixDisk().identity(folder / "a").value(), before);
}

} // namespace
} // namespace wakesurf::core::disk_test
