// Bytes written whole: all of them to a file or pipe, or all from it, where calls are interrupted or short; and files beside a store's
// data, put there by one process at a time while its importer may be at work. Each is whole or absent, and on the disk once it is
// there.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace wakesurf::store {

/// Returns false where it fails; errno says why.
bool write_whole(int file, std::span<const std::byte> bytes);

/// Writes at a place of a file.
bool write_whole_at(int file, std::uint64_t at, std::span<const std::byte> bytes);

/// False at the end of the file or where it fails.
bool read_whole(int file, std::span<std::byte> bytes);

/// A lock on the folder from begin() on.
class FolderChanges {
  public:
    /// Waits for another lock. Error: Io if nothing can be written there.
    static core::Result<FolderChanges> begin(const std::filesystem::path& folder);
    FolderChanges(FolderChanges&& other) noexcept;
    FolderChanges& operator=(FolderChanges&&) = delete;
    ~FolderChanges();

    /// Replaces what has this name. Error: Io, a full disk for example; nothing is changed then.
    core::Result<void> write(const std::string& name, std::span<const std::byte> bytes) const;

    void remove(const std::string& name) const noexcept;

  private:
    FolderChanges(std::filesystem::path folder, int lock)
        : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_;
};

} // namespace wakesurf::store
