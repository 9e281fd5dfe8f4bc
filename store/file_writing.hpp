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

/// Error: Io where nothing can be written to the folder.
core::Result<void> check_writable(const std::filesystem::path& folder);

/// A lock on the folder from begin() on.
class FolderChanges {
  public:
    enum class IfLocked : std::uint8_t { Wait, Refuse };

    /// Waits for another lock, for two seconds at most, or not. Error: Io if nothing can be written there, or another has the lock.
    static core::Result<FolderChanges> begin(const std::filesystem::path& folder,
                                             IfLocked locked = IfLocked::Wait);
    FolderChanges(FolderChanges&& other) noexcept;
    FolderChanges& operator=(FolderChanges&&) = delete;
    ~FolderChanges();

    /// Replaces what has this name. Error: Io, a full disk for example; nothing is changed then.
    core::Result<void> write(const std::string& name, std::span<const std::byte> bytes) const;

    void remove(const std::string& name) const noexcept;

    /// A file that is written piece by piece. Without finish() nothing is left of it.
    class File {
      public:
        File(File&& other) noexcept;
        File& operator=(File&&) = delete;
        ~File();

        /// Error: Io.
        core::Result<void> append(std::span<const std::byte> bytes);

        /// Puts it in the place of what has its name. Error: Io.
        core::Result<void> finish();

      private:
        friend class FolderChanges;

        File(int folder, std::string name, int file)
            : folder_(folder), name_(std::move(name)), file_(file) {}

        int folder_; ///< of the changes
        std::string name_;
        int file_;
    };

    /// Begins a file, which must not outlive this. Error: Io.
    core::Result<File> file(const std::string& name) const;

  private:
    FolderChanges(std::filesystem::path folder, int lock)
        : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_;
};

} // namespace wakesurf::store
