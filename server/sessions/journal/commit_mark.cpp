#include "server/sessions/journal/commit_mark.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <sstream>
#include <utility>

namespace wakesurf::server {

void CommitMark::close() {
    file_.close();
}

std::optional<CommitMark::Value> CommitMark::read() const {
    constexpr std::size_t longest = 256;
    std::istringstream in(read_private_file(path_, longest).value_or(std::string()));
    Value value;
    if (in >> value.id >> value.commits)
        return value;
    return std::nullopt;
}

void CommitMark::write(const Value& value) {
    if (file_.get() < 0)
        file_ = open_private_file(path_, O_WRONLY | O_CREAT).value_or(OpenFile());
    // The length is constant, so that the file never grows: a full disk takes it too.
    char text[64];
    const int size =
        std::snprintf(text, sizeof text, "%020lld %020lld\n", static_cast<long long>(value.id),
                      static_cast<long long>(value.commits));
    if (file_.get() >= 0 && ::pwrite(file_.get(), text, static_cast<std::size_t>(size), 0) != size)
        close();
}

} // namespace wakesurf::server
