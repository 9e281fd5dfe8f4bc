#include "core/base/disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <iterator>
#include <system_error>
#include <utility>

namespace wakesurf::core {

namespace {

/// Closes a descriptor; below 0: none.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}

    ~Descriptor() {
        if (fd_ >= 0)
            ::close(fd_);
    }

    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }

    int get() const { return fd_; }

  private:
    int fd_;
};

/// Returns what `error`, an errno, means for a file. Error: NotFound, Io.
tl::unexpected<Error> cannot_read(const std::filesystem::path& file, int error) {
    const auto code = error == ENOENT || error == ENOTDIR ? Error::Code::NotFound : Error::Code::Io;
    return fail(code, "cannot read " + file.filename().string() + ": " +
                          std::generic_category().message(error));
}

/// Error: Io for anything but a regular file.
Result<FileIdentity> regular(const std::filesystem::path& file, const struct stat& status) {
    if (!S_ISREG(status.st_mode))
        return fail(Error::Code::Io, file.filename().string() + " is not a regular file");
    return FileIdentity{
        static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino),
        std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + std::int64_t{status.st_mtim.tv_nsec}};
}

Result<FileIdentity> regular(const std::filesystem::path& file, const Descriptor& opened) {
    struct stat status {};

    if (::fstat(opened.get(), &status) != 0)
        return cannot_read(file, errno);
    return regular(file, status);
}

/// Fills `out` from `offset` of a regular file. Error: Io, Corrupt when it ends before.
Result<void> read_from(const Descriptor& opened,
                       const std::filesystem::path& file,
                       std::uint64_t offset,
                       std::span<std::byte> out) {
    if (auto found = regular(file, opened); !found)
        return tl::unexpected(found.error());
    while (!out.empty()) {
        const auto got = ::pread(opened.get(), out.data(), out.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return cannot_read(file, errno);
        if (got == 0)
            return fail(Error::Code::Corrupt, file.filename().string() + " ends too early",
                        "import the dataset again");
        out = out.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return {};
}

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
        return regular(file, opened);
    });
}

Result<void> FolderDisk::read(const std::filesystem::path& file,
                              std::uint64_t offset,
                              std::span<std::byte> out) const {
    return open_below(folder_, file, O_RDONLY | O_NONBLOCK).and_then([&](const Descriptor& opened) {
        return read_from(opened, file, offset, out);
    });
}

Result<std::uint64_t> PosixDisk::size(const std::filesystem::path& file) const {
    return identity(file).map([](const FileIdentity& found) { return found.size; });
}

Result<FileIdentity> PosixDisk::identity(const std::filesystem::path& file) const {
    struct stat status {};

    if (::stat(file.c_str(), &status) != 0)
        return cannot_read(file, errno);
    return regular(file, status);
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
