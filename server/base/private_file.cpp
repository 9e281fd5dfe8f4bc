#include "server/base/private_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace wakesurf::server {

namespace {

tl::unexpected<core::Error> not_written(int error) {
    return core::fail(core::Error::Code::Io,
                      std::string("the file cannot be written: ") + std::strerror(error),
                      "name one in a folder that this user can write to, and free some disk space");
}

} // namespace

core::Result<void> write_private_file(const std::filesystem::path& file, std::string_view text) {
    const std::string beside = file.string() + "." + std::to_string(::getpid()) + ".part";
    ::unlink(beside.c_str()); // of a process of the same number that was killed
    const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0)
        return not_written(errno);
    const bool written =
        ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    int error = written ? 0 : errno;
    if (::close(descriptor) != 0 || !written || ::rename(beside.c_str(), file.c_str()) != 0) {
        error = error == 0 ? errno : error;
        ::unlink(beside.c_str());
        return not_written(error);
    }
    return {};
}

} // namespace wakesurf::server
