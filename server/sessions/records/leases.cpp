#include "server/sessions/records/leases.hpp"

#include "server/base/limits.hpp"
#include "server/base/loop.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

Leases::Leases(const SessionServices& services,
               std::function<void(const std::string& rake)> expired)
    : services_(services), expired_(std::move(expired)) {}

std::uint64_t Leases::take(const std::string& rake, const Author& author) {
    Held& held = held_[rake];
    if (held.drag == 0 || held.by.participant != author.participant)
        held.drag = ++drags_;
    held.by = author;
    held.until = services_.now() + limits::lease;
    held.timer = services_.loop.after(limits::lease, [this, rake] {
        // The timer goes with its entry, and its task with it.
        const auto tell = expired_;
        const std::string ended = rake;
        held_.erase(ended);
        tell(ended);
    });
    return held.drag;
}

std::optional<Lease> Leases::find(const std::string& rake) const {
    const auto found = held_.find(rake);
    if (found == held_.end())
        return std::nullopt;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(found->second.until - services_.now());
    return Lease{found->second.by, std::max(left, std::chrono::milliseconds(0))};
}

std::uint64_t Leases::drag(const std::string& rake, const Author& author) const {
    const auto found = held_.find(rake);
    const bool mine = found != held_.end() && found->second.by.participant == author.participant;
    return mine ? found->second.drag : 0;
}

std::vector<std::string> Leases::of(const std::string& participant) const {
    std::vector<std::string> out;
    for (const auto& [rake, held] : held_)
        if (held.by.participant == participant)
            out.push_back(rake);
    return out;
}

} // namespace wakesurf::server
