#include "server/sessions/people/presence_events.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

void PresenceEvents::changed(const std::string& participant, unsigned members) {
    waiting_.changed[participant] |= members;
    std::erase(waiting_.left, participant);
    if (!rest_)
        flush();
}

void PresenceEvents::left(const std::string& participant) {
    waiting_.changed.erase(participant);
    waiting_.left.push_back(participant);
    if (!rest_)
        flush();
}

/// Takes participants in turn: one that was told of waits until all others were.
PresenceEvents::Batch PresenceEvents::next_batch() {
    Batch batch;
    batch.left = std::exchange(waiting_.left, {});
    auto& changed = waiting_.changed;
    for (std::size_t room = room_(); room > 0 && !changed.empty(); --room) {
        auto next = changed.upper_bound(last_);
        if (next == changed.end())
            next = changed.begin();
        last_ = next->first;
        batch.changed.insert(changed.extract(next));
    }
    return batch;
}

void PresenceEvents::flush() {
    rest_.reset();
    if (waiting_.changed.empty() && waiting_.left.empty())
        return;
    const std::size_t bytes = tell_(next_batch());
    const auto rest = std::max(limits::presence_rest,
                               std::chrono::milliseconds(bytes / limits::presence_bytes_per_ms));
    rest_ = loop_.after(rest, [this] { flush(); });
}

} // namespace wakesurf::server
