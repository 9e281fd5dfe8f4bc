#include "store/file_writing.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace wakesurf::store {

bool write_whole(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool write_whole_at(int file, std::uint64_t at, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        at += static_cast<std::uint64_t>(count);
    }
    return true;
}

bool read_whole(int file, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = ::read(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

using core::Error;
namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> cannot(const std::string& what) {
    const int error = errno;
    const char* hint = error == ENOSPC || error == EDQUOT ? "free some disk space, then try again"
                       : error == EACCES || error == EROFS || error == EPERM
                           ? "what is made of data is kept beside them: make the store's folder "
                             "writable, or import the data into another one"
                           : "";
    return core::fail(Error::Code::Io, what + ": " + std::generic_category().message(error), hint);
}

} // namespace

core::Result<void> check_writable(const fs::path& folder) {
    return ::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0
               ? core::Result<void>()
               : cannot("the store cannot be written to");
}

namespace {

/// A lock that only writes a list is gone by then; one that makes a mean may be there for hours.
constexpr std::chrono::milliseconds longest_wait{2000};

} // namespace

core::Result<FolderChanges> FolderChanges::begin(const fs::path& folder, IfLocked locked) {
    const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock < 0)
        return cannot("cannot open the store folder");
    FolderChanges changes(folder, lock);
    const auto until = std::chrono::steady_clock::now() +
                       (locked == IfLocked::Wait ? longest_wait : std::chrono::milliseconds(0));
    while (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK && std::chrono::steady_clock::now() < until) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            continue;
        }
        if (errno == EWOULDBLOCK)
            return core::fail(Error::Code::Io,
                              "another program makes a field of this store just now",
                              "try again once it has ended");
        if (errno != EINTR)
            return cannot("cannot lock the store folder");
    }
    return check_writable(folder).map([&] { return std::move(changes); });
}

FolderChanges::FolderChanges(FolderChanges&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}

FolderChanges::~FolderChanges() {
    if (lock_ >= 0)
        ::close(lock_);
}

core::Result<void> FolderChanges::write(const std::string& name,
                                        std::span<const std::byte> bytes) const {
    return file(name).and_then(
        [&](File whole) { return whole.append(bytes).and_then([&] { return whole.finish(); }); });
}

core::Result<FolderChanges::File> FolderChanges::file(const std::string& name) const {
    const std::string part = name + ".part";
    const int file = ::openat(lock_, part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0)
        return cannot("cannot write " + name);
    return File(lock_, name, file);
}

FolderChanges::File::File(File&& other) noexcept
    : folder_(other.folder_), name_(std::move(other.name_)), file_(std::exchange(other.file_, -1)) {
}

FolderChanges::File::~File() {
    if (file_ < 0)
        return;
    ::close(file_);
    ::unlinkat(folder_, (name_ + ".part").c_str(), 0);
}

core::Result<void> FolderChanges::File::append(std::span<const std::byte> bytes) {
    return write_whole(file_, bytes) ? core::Result<void>() : cannot("cannot write " + name_);
}

core::Result<void> FolderChanges::File::finish() {
    if (::fsync(file_) != 0)
        return cannot("cannot write " + name_);
    if (::renameat(folder_, (name_ + ".part").c_str(), folder_, name_.c_str()) != 0)
        return cannot("cannot write " + name_);
    ::fsync(folder_); // the name, too
    ::close(std::exchange(file_, -1));
    return {};
}

void FolderChanges::remove(const std::string& name) const noexcept {
    ::unlinkat(lock_, name.c_str(), 0);
}

} // namespace wakesurf::store
