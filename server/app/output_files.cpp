#include "server/app/output_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace wakesurf::server {

core::Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    const auto failed = [&](int why) {
        return core::fail(core::Error::Code::Io,
                          "cannot write " + file.string() + ": " +
                              std::generic_category().message(why),
                          "name a file in an existing folder with enough room");
    };
    auto part = file;
    part += ".part";
    errno = 0;
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    if (!stream)
        return failed(errno);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    std::error_code renamed;
    if (stream)
        std::filesystem::rename(part, file, renamed);
    if (stream && !renamed)
        return {};
    const int why = renamed ? renamed.value() : errno;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return failed(why);
}

namespace fs = std::filesystem;
using core::Error;

core::Result<void> check_writable(const fs::path& folder, std::string_view option) {
    std::error_code ignored;
    fs::path there = fs::absolute(folder, ignored);
    while (!fs::exists(there, ignored) && there.has_relative_path())
        there = there.parent_path();
    if (::faccessat(AT_FDCWD, there.c_str(), W_OK | X_OK, AT_EACCESS) == 0)
        return {};
    const int why = errno;

    struct stat status {};

    if (why != EACCES || ::stat(there.c_str(), &status) != 0)
        return core::fail(
            Error::Code::Io,
            fmt::format("{}: {} cannot be written: {}", option, there.string(), std::strerror(why)),
            fmt::format("mount it for writing, or name another folder with {}", option));
    const auto user = ::geteuid();
    if (status.st_uid == user)
        return core::fail(Error::Code::Io,
                          fmt::format("{}: {} cannot be written by its owner, user {}", option,
                                      there.string(), user),
                          fmt::format("chmod u+wx it, or name another folder with {}", option));
    return core::fail(
        Error::Code::Io,
        fmt::format("{}: {} cannot be written: it belongs to user {}, this program runs as user {}",
                    option, there.string(), status.st_uid, user),
        fmt::format("give it to that user: `chown -R {} FOLDER` as root, where FOLDER is that "
                    "folder or, of a container, what is mounted there; or name another with {}",
                    user, option));
}

} // namespace wakesurf::server
