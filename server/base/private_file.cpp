#include "server/base/private_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace wakesurf::server {

namespace fs = std::filesystem;
using core::Error;
using core::fail;

namespace {

constexpr mode_t of_others = S_IRWXG | S_IRWXO;
constexpr int most_links = 8;

tl::unexpected<Error> not_written(int error) {
    return fail(Error::Code::Io, std::string("the file cannot be written: ") + std::strerror(error),
                "name one in a folder that this user can write to, and free some disk space");
}

tl::unexpected<Error> not_ours(const std::string& what) {
    return fail(Error::Code::Io, what,
                "put a plain file of this user in its place, or remove it and a new one is made");
}

tl::unexpected<Error> not_opened(int error) {
    if (error == ENOENT)
        return fail(Error::Code::NotFound, "there is no such file", "name another one");
    if (error == ELOOP)
        return not_ours("it is a link, which is not followed");
    return fail(Error::Code::Io, std::string("it cannot be opened: ") + std::strerror(error),
                "give it to the user of wakesurf, and let them read it");
}

bool ours_or_the_systems(uid_t owner) {
    return owner == ::geteuid() || owner == 0;
}

struct OpenedFile {
    OpenFile file;

    struct stat status {};
};

/// O_NONBLOCK: a pipe is opened at once, and refused.
core::Result<OpenedFile> open_and_stat(const fs::path& path, int flags) {
    OpenedFile out{OpenFile(::open(path.c_str(),
                                   flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, 0600)),
                   {}};
    if (out.file.get() < 0)
        return not_opened(errno);
    if (::fstat(out.file.get(), &out.status) != 0)
        return not_opened(errno);
    if (!S_ISREG(out.status.st_mode))
        return not_ours("it is not a plain file");
    return out;
}

core::Result<std::string> read_all(const OpenFile& file, std::size_t most) {
    std::string text(most + 1, '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const auto count = ::read(file.get(), text.data() + size, text.size() - size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return not_opened(errno);
        if (count == 0)
            break;
        size += static_cast<std::size_t>(count);
    }
    text.resize(size);
    if (size > most)
        return fail(Error::Code::Corrupt, "it is too large to be one", "name another file");
    return text;
}

/// Follows links, each of which must be this user's or the system's. Kernels protect only sticky folders in
/// this way.
core::Result<fs::path> behind_links(fs::path path) {
    for (int i = 0; i < most_links; ++i) {
        struct stat status {};

        if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode))
            return path;
        if (!ours_or_the_systems(status.st_uid))
            return not_ours(fmt::format("it is a link of user {}", status.st_uid));
        std::error_code error;
        path = path.parent_path() / fs::read_symlink(path, error);
        if (error)
            return not_opened(error.value());
    }
    return not_opened(ELOOP);
}

} // namespace

void OpenFile::close() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    descriptor_ = -1;
}

core::Result<OpenFile> open_private_file(const fs::path& file, int flags) {
    auto opened = open_and_stat(file, flags);
    if (!opened)
        return tl::unexpected(opened.error());
    const struct stat& status = opened->status;
    if (status.st_uid != ::geteuid())
        return not_ours(fmt::format("it belongs to user {}, this program runs as user {}",
                                    status.st_uid, ::geteuid()));
    if (status.st_nlink > 1)
        return not_ours("the file has a second name (a hard link)");
    if ((status.st_mode & of_others) != 0 &&
        ::fchmod(opened->file.get(), status.st_mode & ~of_others & 07777) != 0)
        return not_opened(errno);
    return std::move(opened->file);
}

core::Result<std::string> read_private_file(const fs::path& file, std::size_t most) {
    const auto opened = open_private_file(file, O_RDONLY);
    if (!opened)
        return tl::unexpected(opened.error());
    return read_all(*opened, most);
}

core::Result<NamedSecret> read_named_secret(const fs::path& file, std::size_t most) {
    const auto path = behind_links(file);
    if (!path)
        return tl::unexpected(path.error());
    const auto opened = open_and_stat(*path, O_RDONLY);
    if (!opened)
        return tl::unexpected(opened.error());
    const struct stat& status = opened->status;
    if (!ours_or_the_systems(status.st_uid))
        return not_ours(fmt::format("it belongs to user {}, this program runs as user {}",
                                    status.st_uid, ::geteuid()));
    NamedSecret out;
    auto text = read_all(opened->file, most);
    if (!text)
        return tl::unexpected(text.error());
    out.text = std::move(*text);
    const bool seen = status.st_uid == ::geteuid() ? (status.st_mode & of_others) != 0
                                                   : (status.st_mode & S_IRWXO) != 0;
    if (seen)
        out.warning = fmt::format("others could read it (mode {:04o})", status.st_mode & 07777);
    return out;
}

core::Result<void> write_private_file(const fs::path& file, std::string_view text) {
    const std::string beside = file.string() + "." + std::to_string(::getpid()) + ".part";
    ::unlink(beside.c_str()); // of a killed process with the same id
    const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0)
        return not_written(errno);
    const bool written =
        ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
        ::fsync(descriptor) == 0;
    int error = written ? 0 : errno;
    if (::close(descriptor) != 0 || !written || ::rename(beside.c_str(), file.c_str()) != 0) {
        error = error == 0 ? errno : error;
        ::unlink(beside.c_str());
        return not_written(error == 0 ? ENOSPC : error);
    }
    const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (const OpenFile folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        folder.get() >= 0)
        ::fsync(folder.get());
    return {};
}

core::Result<void> append_private_file(const fs::path& file, std::string_view text) {
    const auto opened = open_private_file(file, O_WRONLY | O_APPEND | O_CREAT);
    if (!opened)
        return tl::unexpected(opened.error());
    const off_t before = ::lseek(opened->get(), 0, SEEK_END);
    const auto count = ::write(opened->get(), text.data(), text.size());
    if (count == static_cast<ssize_t>(text.size()) && ::fsync(opened->get()) == 0)
        return {};
    const int error = count < 0 || count == static_cast<ssize_t>(text.size()) ? errno : ENOSPC;
    (void)!::ftruncate(opened->get(), before); // half a line would spoil the next one
    return not_written(error);
}

core::Result<void>
check_private_folder(const fs::path& folder, std::string_view name, bool shared) {
    const auto path = behind_links(folder);
    if (!path)
        return fail(Error::Code::Io, fmt::format("{}: {}", name, path.error().message),
                    "name the folder itself");

    struct stat status {};

    if (::stat(path->c_str(), &status) != 0)
        return fail(Error::Code::Io,
                    fmt::format("{}: the folder cannot be used: {}", name, std::strerror(errno)),
                    "name one that this user can create or write to");
    if (!ours_or_the_systems(status.st_uid))
        return fail(
            Error::Code::Io,
            fmt::format("{}: the folder belongs to user {}, who can put anything there; this "
                        "program runs as user {}",
                        name, status.st_uid, ::geteuid()),
            fmt::format("name a folder of user {}, or make one inside of it", ::geteuid()));
    const bool sticky = shared && (status.st_mode & S_ISVTX) != 0;
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0 && !sticky)
        return fail(Error::Code::Io,
                    fmt::format("{}: others can write to the folder (mode {:04o}), and so replace "
                                "what is stored there",
                                name, status.st_mode & 07777),
                    "chmod go-w it, or name a folder inside of it that is yours alone");
    return {};
}

} // namespace wakesurf::server
