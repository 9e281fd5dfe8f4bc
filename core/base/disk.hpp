// The file operations the store reader needs, injected so that tests can make them fail or delay.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <utility>

namespace wakesurf::core {

/// Distinguishes a file from another one that took its name.
struct FileIdentity {
    std::uint64_t size = 0;    ///< bytes
    std::uint64_t inode = 0;   ///< 0 where a disk has none
    std::int64_t modified = 0; ///< nanoseconds since 1970

    bool operator==(const FileIdentity&) const = default;
};

/// Reads files. Thread safety: concurrent calls are allowed.
class Disk {
  public:
    virtual ~Disk() = default;

    /// Returns the size of a regular file in bytes. Error: NotFound, Io.
    virtual Result<std::uint64_t> size(const std::filesystem::path& file) const = 0;

    /// Returns the identity of a file. Error: NotFound, Io. A disk that knows only sizes distinguishes files
    /// by their size.
    virtual Result<FileIdentity> identity(const std::filesystem::path& file) const {
        return size(file).map([](std::uint64_t bytes) { return FileIdentity{bytes, 0, 0}; });
    }

    /// Fills `out` from `offset`. Error: NotFound, Io, Corrupt when the file ends before `out` is full.
    virtual Result<void> read(const std::filesystem::path& file,
                              std::uint64_t offset,
                              std::span<std::byte> out) const = 0;

    /// Reads like read(), but a long read ends as Cancelled when `stop` fires.
    virtual Result<void> read_stoppable(const std::filesystem::path& file,
                                        std::uint64_t offset,
                                        std::span<std::byte> out,
                                        const std::stop_token& stop) const {
        (void)stop;
        return read(file, offset, out);
    }

    /// The way in which a disk is read fastest.
    struct Pace {
        std::size_t readers = 4;                  ///< at the same time
        std::size_t piece = std::size_t{1} << 20; ///< bytes of a long file in one go
    };

    virtual Pace pace() const { return {}; } ///< of all its files
};

/// Reads the real disk by pread in a loop (EINTR and short reads handled). It never uses mmap, because a file
/// truncated under a mapping is a SIGBUS.
class PosixDisk final : public Disk {
  public:
    Result<std::uint64_t> size(const std::filesystem::path& file) const override;
    Result<FileIdentity> identity(const std::filesystem::path& file) const override;
    Result<void> read(const std::filesystem::path& file,
                      std::uint64_t offset,
                      std::span<std::byte> out) const override;
};

/// Reads like PosixDisk what lies in `folder` and below. Error: Io for any other path, and for one with a
/// link in it; `folder` itself may be one.
class FolderDisk final : public Disk {
  public:
    explicit FolderDisk(std::filesystem::path folder) : folder_(std::move(folder)) {}

    Result<std::uint64_t> size(const std::filesystem::path& file) const override;
    Result<FileIdentity> identity(const std::filesystem::path& file) const override;
    Result<void> read(const std::filesystem::path& file,
                      std::uint64_t offset,
                      std::span<std::byte> out) const override;

  private:
    std::filesystem::path folder_;
};

} // namespace wakesurf::core
