#include "core/base/folder_disk.hpp"

#include "core/base/open_file.hpp"

#include <fcntl.h>

#include <cerrno>
#include <iterator>

namespace wakesurf::core {

namespace {

bool is_link(const Descriptor& opened) {
    struct stat status {};

    return ::fstat(opened.get(), &status) == 0 && S_ISLNK(status.st_mode);
}

// Opens one part after the other, and none that is a link, so that no one can change the way meanwhile.
Result<Descriptor>
open_below(const std::filesystem::path& folder, const std::filesystem::path& file, int flags) {
    Descriptor at(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    const auto below = file.lexically_relative(folder);
    for (auto part = below.begin(); part != below.end() && at.get() >= 0; ++part) {
        const bool last = std::next(part) == below.end();
        at = Descriptor(
            ::openat(at.get(), part->c_str(), (last ? flags : O_PATH) | O_NOFOLLOW | O_CLOEXEC));
        const bool refused = at.get() < 0 ? errno == ELOOP : is_link(at) || *part == "..";
        if (refused)
            return fail(Error::Code::Io,
                        "cannot read " + file.filename().string() +
                            ": it is a link, or lies behind one, and may be anything",
                        "put the file itself there");
    }
    if (at.get() < 0)
        return cannot_read(file, errno);
    return at;
}

} // namespace

Result<std::uint64_t> FolderDisk::size(const std::filesystem::path& file) const {
    return identity(file).map([](const FileIdentity& found) { return found.size; });
}

Result<FileIdentity> FolderDisk::identity(const std::filesystem::path& file) const {
    return open_below(folder_, file, O_PATH).and_then([&](const Descriptor& opened) {
        return regular(file, opened).map([](const RegularFile& is) {
            return FileIdentity{is.size, is.inode, is.modified};
        });
    });
}

Result<void> FolderDisk::read(const std::filesystem::path& file,
                              std::uint64_t offset,
                              std::span<std::byte> out) const {
    return open_below(folder_, file, O_RDONLY | O_NONBLOCK).and_then([&](const Descriptor& opened) {
        return read_from(opened, file, offset, out);
    });
}

} // namespace wakesurf::core
