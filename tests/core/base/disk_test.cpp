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

TEST(FolderDisk, ReadsWhatLiesBelowItAndFollowsNoLink) {
    const TemporaryFolder folder;
    namespace fs = std::filesystem;
    fs::create_directories(folder / "in/deep");
    write_file(folder / "in/deep/a", "0123");
    write_file(folder / "out", "secret");
    fs::create_symlink("../out", folder / "in/link");
    fs::create_symlink(folder.path(), folder / "in/folder");
    fs::create_directory_symlink("deep", folder / "in/inside");
    fs::create_directory_symlink("in", folder / "root");
    for (const auto& root : {folder / "in", folder / "root"}) {
        const FolderDisk disk(root);
        EXPECT_EQ(disk.size(root / "deep/a").value(), 4u);
        EXPECT_EQ(text(disk, root / "deep/a", 1, 2), "12");
        EXPECT_EQ(disk.identity(root / "deep/a").value(),
                  PosixDisk().identity(root / "deep/a").value());
        EXPECT_EQ(disk.size(root / "none").error().code, Error::Code::NotFound);
        EXPECT_EQ(disk.size(root / "none/a").error().code, Error::Code::NotFound);
        EXPECT_EQ(disk.size(root / "deep/a/b").error().code, Error::Code::NotFound);
        EXPECT_EQ(disk.size(root / "deep").error().code, Error::Code::Io);
        std::array<std::byte, 1> out{};
        for (const auto& name : {"link", "folder/out", "inside/a", "../out", "folder"}) {
            EXPECT_EQ(disk.size(root / name).error().code, Error::Code::Io) << name;
            EXPECT_EQ(disk.read(root / name, 0, out).error().code, Error::Code::Io) << name;
        }
        EXPECT_EQ(text(disk, root / "link", 0, 1),
                  "cannot read link: it is a link, or lies behind one, and may be anything");
        EXPECT_EQ(disk.size(folder / "out").error().code, Error::Code::Io);
    }
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
