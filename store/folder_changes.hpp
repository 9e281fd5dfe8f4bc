// Files that are put beside a store's data, one process at a time, while its importer may be at work: each is
// whole or absent, and on the disk once it is there.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace wakesurf::store {

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
