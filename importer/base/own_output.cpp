#include "importer/base/own_output.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace wakesurf::importer {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// A descriptor that was closed stays closed: output to it is lost, as it would have been.
std::FILE* moved(int descriptor) {
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    std::FILE* const stream = copy < 0 ? nullptr : ::fdopen(copy, "w");
    return stream != nullptr ? stream : std::fopen("/dev/null", "we");
}

} // namespace

OwnOutput take_outputs(bool show_libraries) {
    std::fflush(nullptr);
    const OwnOutput own{moved(STDOUT_FILENO), moved(STDERR_FILENO)};
    const bool show = show_libraries || sanitized;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int instead = show ? STDERR_FILENO : nowhere;
    if (instead >= 0)
        ::dup2(instead, STDOUT_FILENO);
    if (!show && nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);
    if (nowhere > STDERR_FILENO)
        ::close(nowhere);
    return own;
}

} // namespace wakesurf::importer
