#include "server/state/commit_mark.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <utility>

namespace wakesurf::server {

CommitMark::~CommitMark() {
    close();
}

CommitMark::CommitMark(CommitMark&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

CommitMark& CommitMark::operator=(CommitMark&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

void CommitMark::close() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    descriptor_ = -1;
}

std::optional<CommitMark::Value> CommitMark::read() const {
    std::ifstream in(path_);
    Value value;
    if (in >> value.id >> value.commits)
        return value;
    return std::nullopt;
}

void CommitMark::write(const Value& value) {
    if (descriptor_ < 0)
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    // Always as long, so that the file never grows: a full disk takes it too.
    char text[64];
    const int size =
        std::snprintf(text, sizeof text, "%020lld %020lld\n", static_cast<long long>(value.id),
                      static_cast<long long>(value.commits));
    if (descriptor_ >= 0 && ::pwrite(descriptor_, text, static_cast<std::size_t>(size), 0) != size)
        close();
}

} // namespace wakesurf::server
