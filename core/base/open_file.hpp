// Files by their descriptors, with messages that name no folder: they may reach a client.
#pragma once

#include "core/base/result.hpp"

#include <sys/stat.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace wakesurf::core {

/// Closes a descriptor; below 0: none.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}

    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;

    int get() const { return fd_; }

  private:
    int fd_;
};

/// Returns what `error`, an errno, says about a file. Error: NotFound, Io.
tl::unexpected<Error> cannot_read(const std::filesystem::path& file, int error);

/// What distinguishes a regular file, as FileIdentity has it.
struct RegularFile {
    std::uint64_t size;
    std::uint64_t inode;
    std::int64_t modified;
};

/// Error: Io for any other file.
Result<RegularFile> regular(const std::filesystem::path& file, const struct stat& status);

/// The same of an open file.
Result<RegularFile> regular(const std::filesystem::path& file, const Descriptor& opened);

/// Fills `out` from `offset` of a regular file. Error: Io, Corrupt when it ends before.
Result<void> read_from(const Descriptor& opened,
                       const std::filesystem::path& file,
                       std::uint64_t offset,
                       std::span<std::byte> out);

} // namespace wakesurf::core
