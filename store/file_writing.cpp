#include "store/file_writing.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
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
                           ? "families are kept in the store, beside the data: make its folder "
                             "writable, or import the data into another one"
                           : "";
    return core::fail(Error::Code::Io, what + ": " + std::generic_category().message(error), hint);
}

} // namespace

core::Result<FolderChanges> FolderChanges::begin(const fs::path& folder) {
    const int lock = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock < 0)
        return cannot("cannot open the store folder");
    FolderChanges changes(folder, lock);
    while (::flock(lock, LOCK_EX) != 0)
        if (errno != EINTR)
            return cannot("cannot lock the store folder");
    if (::faccessat(lock, ".", W_OK | X_OK, AT_EACCESS) != 0)
        return cannot("the store cannot be written to");
    return changes;
}

FolderChanges::FolderChanges(FolderChanges&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}

FolderChanges::~FolderChanges() {
    if (lock_ >= 0)
        ::close(lock_);
}

core::Result<void> FolderChanges::write(const std::string& name,
                                        std::span<const std::byte> bytes) const {
    const std::string part = name + ".part";
    const int file = ::openat(lock_, part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0)
        return cannot("cannot write " + name);
    const bool written = write_whole(file, bytes) && ::fsync(file) == 0;
    core::Result<void> outcome = written ? core::Result<void>() : cannot("cannot write " + name);
    if (::close(file) != 0 && outcome)
        outcome = cannot("cannot write " + name);
    if (outcome && ::renameat(lock_, part.c_str(), lock_, name.c_str()) != 0)
        outcome = cannot("cannot write " + name);
    if (!outcome)
        ::unlinkat(lock_, part.c_str(), 0);
    else
        ::fsync(lock_); // the name, too
    return outcome;
}

void FolderChanges::remove(const std::string& name) const noexcept {
    ::unlinkat(lock_, name.c_str(), 0);
}

} // namespace wakesurf::store
