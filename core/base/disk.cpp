#include "core/base/disk.hpp"

#include "core/base/open_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>

namespace wakesurf::core {

Result<std::uint64_t> PosixDisk::size(const std::filesystem::path& file) const {
    return identity(file).map([](const FileIdentity& found) { return found.size; });
}

Result<FileIdentity> PosixDisk::identity(const std::filesystem::path& file) const {
    struct stat status {};

    if (::stat(file.c_str(), &status) != 0)
        return cannot_read(file, errno);
    return regular(file, status).map([](const RegularFile& is) {
        return FileIdentity{is.size, is.inode, is.modified};
    });
}

Result<void> PosixDisk::read(const std::filesystem::path& file,
                             std::uint64_t offset,
                             std::span<std::byte> out) const {
    // O_NONBLOCK: opening a FIFO left in a store must not hang.
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (descriptor.get() < 0)
        return cannot_read(file, errno);
    return read_from(descriptor, file, offset, out);
}

} // namespace wakesurf::core
