// Files of this user alone: secrets, and what a server remembers. Other users of the machine may be able to
// place files and links in their way, so each file is checked before use: no link of another user is
// followed, no open blocks, and only a plain file of our own is accepted. All such files are read and written
// by these functions.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace wakesurf::server {

/// Owns a descriptor, or none.
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

/// Opens a plain file of this user with no other name, never through a link. Other users lose the right to
/// read it. A missing file is made (0600) if `flags` have O_CREAT. Error: NotFound; Io for anything else,
/// without the path.
core::Result<OpenFile> open_private_file(const std::filesystem::path& file, int flags);

/// Returns the content of such a file of at most `most` bytes. Error: as open_private_file; Corrupt if it is
/// longer.
core::Result<std::string> read_private_file(const std::filesystem::path& file, std::size_t most);

/// Replaces the file (0600), or makes it; a link is replaced, not followed. Waits for the disk: after a power
/// cut it is the old one or the new. Error: Io, without the path.
core::Result<void> write_private_file(const std::filesystem::path& file, std::string_view text);

/// Adds to the end of such a file, which is made if it is missing. Waits for the disk. Error: Io, without the
/// path; the file then is as before, unless the disk fails altogether.
core::Result<void> append_private_file(const std::filesystem::path& file, std::string_view text);

/// The content of a file that a user has named, with permissions of their choice: also the system's (root's),
/// through links that are this user's or the system's, and with a warning if others can read it.
struct NamedSecret {
    std::string text;
    std::string warning; ///< for people; may be empty
};

/// Reads a named file. Error: as read_private_file.
core::Result<NamedSecret> read_named_secret(const std::filesystem::path& file, std::size_t most);

/// Checks that other users can neither place files in a folder nor remove ours: it is this user's or the
/// system's, and no other may write there; with `shared`, a sticky folder is accepted. Error: Io, with the
/// cure. `name` is the folder's name for people.
core::Result<void>
check_private_folder(const std::filesystem::path& folder, std::string_view name, bool shared);

} // namespace wakesurf::server
