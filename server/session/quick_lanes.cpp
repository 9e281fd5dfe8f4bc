#include "server/session/quick_lanes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::server {

QuickLanes::Lane QuickLanes::push(const std::string& session, FairQueue::Job job, Time now) {
    const std::size_t others = std::max<std::size_t>(2, use_.busier_than(busy, now));
    const bool much = use_.share(session, now) > 2 * fair_share / static_cast<double>(others);
    const auto found = upper_.find(session);
    const std::size_t there = found == upper_.end() ? 0 : found->second;
    const Lane lane = much || there >= most_ ? Lane::Lower : Lane::Upper;
    if (lane == Lane::Upper)
        upper_[session] = there + 1;
    of(lane).push(session, std::move(job));
    return lane;
}

std::optional<FairQueue::Turn> QuickLanes::pop(Lane lane, Time now) {
    if (lane == Lane::Lower)
        return of(lane).pop();
    return of(lane).pop_least([&](const std::string& session) { return use_.share(session, now); },
                              std::numeric_limits<double>::infinity());
}

void QuickLanes::done(Lane lane, const std::string& session, double seconds, Time now) {
    of(lane).done(session);
    use_.add(session, seconds, now);
    if (lane == Lane::Lower)
        return;
    const auto found = upper_.find(session);
    if (--found->second == 0)
        upper_.erase(found);
}

} // namespace wakesurf::server
