// The files of one folder, whose author is not trusted: no link is followed, so nothing outside is read.
#pragma once

#include "core/base/disk.hpp"

#include <utility>

namespace wakesurf::core {

/// Reads like PosixDisk what lies in `folder` and below. Error: Io for any other path, and for one with a link in it;
/// `folder` itself may be one.
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
