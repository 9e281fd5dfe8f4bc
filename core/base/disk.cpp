#include "core/base/disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace wakesurf::core {

namespace {

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}

    ~Descriptor() {
        if (fd_ >= 0)
            ::close(fd_);
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }

  private:
    int fd_;
};

// The message names only the last part of the path, because it may reach a client.
tl::unexpected<Error> failure(const std::filesystem::path& file, int error) {
    const auto code = error == ENOENT || error == ENOTDIR ? Error::Code::NotFound : Error::Code::Io;
    return fail(code, "cannot read " + file.filename().string() + ": " +
                          std::generic_category().message(error));
}

Result<FileIdentity> identify(const std::filesystem::path& file, const struct stat& status) {
    if (!S_ISREG(status.st_mode))
        return fail(Error::Code::Io, file.filename().string() + " is not a regular file");
    return FileIdentity{
        static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino),
        std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + std::int64_t{status.st_mtim.tv_nsec}};
}

} // namespace

Result<std::uint64_t> PosixDisk::size(const std::filesystem::path& file) const {
    return identity(file).map([](const FileIdentity& found) { return found.size; });
}

Result<FileIdentity> PosixDisk::identity(const std::filesystem::path& file) const {
    struct stat status {};

    if (::stat(file.c_str(), &status) != 0)
        return failure(file, errno);
    return identify(file, status);
}

Result<void> PosixDisk::read(const std::filesystem::path& file,
                             std::uint64_t offset,
                             std::span<std::byte> out) const {
    // O_NONBLOCK: opening a FIFO left in a store must not hang.
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (descriptor.get() < 0)
        return failure(file, errno);

    struct stat status {};

    if (::fstat(descriptor.get(), &status) != 0)
        return failure(file, errno);
    if (auto regular = identify(file, status); !regular)
        return tl::unexpected(regular.error());
    while (!out.empty()) {
        const auto got =
            ::pread(descriptor.get(), out.data(), out.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return failure(file, errno);
        if (got == 0)
            return fail(Error::Code::Corrupt, file.filename().string() + " ends too early",
                        "import the dataset again");
        out = out.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return {};
}

} // namespace wakesurf::core
