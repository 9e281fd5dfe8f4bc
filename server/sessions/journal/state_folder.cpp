#include "server/sessions/journal/state_folder.hpp"

#include "server/base/private_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

tl::unexpected<Error> unusable(int error) {
    return fail(Error::Code::Io,
                "--state: the folder cannot be used: " + std::generic_category().message(error),
                "name one that this user can create or write to");
}

/// The names that a server, or SQLite for it, opens there.
constexpr std::array<const char*, 7> own_files{"sessions.sqlite",
                                               "sessions.sqlite-wal",
                                               "sessions.sqlite-shm",
                                               "sessions.sqlite-journal",
                                               "sessions.sqlite.commits",
                                               "starts",
                                               "ended-logins"};

/// Checks that the folder is this user's, without links that another user could have made.
core::Result<void> look_through(const std::filesystem::path& folder) {
    if (auto ours = check_private_folder(folder, "--state", false); !ours)
        return ours;
    for (const char* name : own_files)
        if (const auto ours = open_private_file(folder / name, O_RDONLY);
            !ours && ours.error().code != Error::Code::NotFound)
            return fail(Error::Code::Io,
                        std::string("--state: the file ") + name +
                            " in it: " + ours.error().message,
                        ours.error().hint);
    return {};
}

} // namespace

core::Result<void> make_private_file(const std::string& path) {
    const int made = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (made < 0)
        return fail(Error::Code::Io,
                    "a file cannot be made there: " + std::generic_category().message(errno),
                    "free some disk space, and make the folder writable for this user");
    ::close(made);
    return {};
}

core::Result<StateFolder> StateFolder::lock(const std::filesystem::path& folder) {
    // A lock on the folder itself needs no file, so that it works on a full disk.
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return unusable(errno);
    if (auto ours = look_through(folder); !ours) {
        ::close(descriptor);
        return tl::unexpected(ours.error());
    }
    StateFolder held(folder, descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return fail(Error::Code::OverLimit, "--state: another server keeps its sessions there",
                    "stop it, or give this one a folder of its own");
    return held;
}

core::Result<StateFolder> StateFolder::hold(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::create_directories(folder, error))
        std::filesystem::permissions(folder, std::filesystem::perms::owner_all, error);
    if (error)
        return unusable(error.value());
    auto held = lock(folder);
    if (!held)
        return held;
    // SQLite would make it readable for others; its log takes the same permissions.
    if (auto made = open_private_file(held->file(), O_RDWR | O_CREAT); !made)
        return tl::unexpected(made.error());
    return held;
}

core::Result<StateFolder> StateFolder::hold_existing(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        return fail(Error::Code::NotFound, "there is no state folder with this name",
                    "give the folder given to `serve --state`");
    return lock(folder);
}

StateFolder::~StateFolder() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

StateFolder::StateFolder(StateFolder&& other) noexcept
    : folder_(std::move(other.folder_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

StateFolder& StateFolder::operator=(StateFolder&& other) noexcept {
    std::swap(folder_, other.folder_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

} // namespace wakesurf::server
