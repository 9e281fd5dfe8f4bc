#include "core/base/open_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace wakesurf::core {

Descriptor::~Descriptor() {
    if (fd_ >= 0)
        ::close(fd_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
}

tl::unexpected<Error> cannot_read(const std::filesystem::path& file, int error) {
    const auto code = error == ENOENT || error == ENOTDIR ? Error::Code::NotFound : Error::Code::Io;
    return fail(code, "cannot read " + file.filename().string() + ": " +
                          std::generic_category().message(error));
}

Result<RegularFile> regular(const std::filesystem::path& file, const struct stat& status) {
    if (!S_ISREG(status.st_mode))
        return fail(Error::Code::Io, file.filename().string() + " is not a regular file");
    return RegularFile{
        static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino),
        std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + std::int64_t{status.st_mtim.tv_nsec}};
}

Result<RegularFile> regular(const std::filesystem::path& file, const Descriptor& opened) {
    struct stat status {};

    if (::fstat(opened.get(), &status) != 0)
        return cannot_read(file, errno);
    return regular(file, status);
}

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

} // namespace wakesurf::core
