#include "server/session/presence_news.hpp"

#include "server/limits.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

void PresenceNews::changed(const std::string& participant, unsigned members) {
    batch_.changed[participant] |= members;
    std::erase(batch_.left, participant);
    if (!rest_)
        flush();
}

void PresenceNews::left(const std::string& participant) {
    batch_.changed.erase(participant);
    batch_.left.push_back(participant);
    if (!rest_)
        flush();
}

void PresenceNews::flush() {
    rest_.reset();
    if (batch_.changed.empty() && batch_.left.empty())
        return;
    const std::size_t bytes = tell_(std::exchange(batch_, {}));
    const auto rest = std::max(limits::presence_rest,
                               std::chrono::milliseconds(bytes / limits::presence_bytes_per_ms));
    rest_ = loop_.after(rest, [this] { flush(); });
}

} // namespace wakesurf::server
