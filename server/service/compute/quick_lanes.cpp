#include "server/service/compute/quick_lanes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::server {

/// Of the upper threads, for one session.
double QuickLanes::most_share(Time now) const {
    const std::size_t sessions = std::max<std::size_t>(2, use_.busier_than(busy, now));
    return 2 * fair_share / static_cast<double>(sessions);
}

FairQueue::Used QuickLanes::used(Time now) const {
    return [this, now](const std::string& session) { return use_.share(session, now); };
}

QuickLanes::Lane QuickLanes::push(const std::string& session, FairQueue::Job job, Time now) {
    const bool much = use_.share(session, now) > most_share(now);
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
    return of(lane).pop_least(used(now), std::numeric_limits<double>::infinity());
}

std::optional<FairQueue::Turn> QuickLanes::pop_light(Time now) {
    return of(Lane::Upper).pop_least(used(now), most_share(now) / 2);
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
