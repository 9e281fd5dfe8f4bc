// Files that are this user's alone: secrets, and what a server remembers. Other people of the machine may be
// able to put things in their way, so each is looked at before it is used: no link is followed that another
// user has made, nothing is waited for, and only a plain file of our own is taken. Whatever keeps such a
// file goes by these functions.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace wakesurf::server {

/// An open file, or none.
class OpenFile {
  public:
    OpenFile() = default;

    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}

    ~OpenFile() { close(); }

    OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }

    int get() const { return descriptor_; }

    void close();

  private:
    int descriptor_ = -1;
};

/// Opens a plain file of this user with no other name, never through a link. Others lose the right to read
/// it. Made (0600) where there is none and `flags` have O_CREAT. Error: NotFound; Io, for whatever else it
/// is, without the path.
core::Result<OpenFile> open_private_file(const std::filesystem::path& file, int flags);

/// Returns what such a file holds, which is not longer than `most`. Error: as open_private_file; Corrupt, it
/// is longer.
core::Result<std::string> read_private_file(const std::filesystem::path& file, std::size_t most);

/// Replaces the file (0600), or makes it; a link is replaced, not followed. Waits for the disk: after a
/// power cut it is the old one or the new. Error: Io, without the path.
core::Result<void> write_private_file(const std::filesystem::path& file, std::string_view text);

/// A file that a person has named, and that its owner may keep as they like: also the system's (root's),
/// through links that are this user's or the system's, and with words where others can read it.
struct NamedSecret {
    std::string text;
    std::string warning; ///< for people; empty: there is nothing to say
};

/// Error: as read_private_file.
core::Result<NamedSecret> read_named_secret(const std::filesystem::path& file, std::size_t most);

/// Returns whether others can put things into a folder, or take ours away: it is this user's or the
/// system's, and no one else may write there, or only what is their own (sticky), where `shared` allows
/// that. Error: Io, with the cure. `name` is what people call it.
core::Result<void>
check_private_folder(const std::filesystem::path& folder, std::string_view name, bool shared);

} // namespace wakesurf::server
