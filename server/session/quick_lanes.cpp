#include "server/session/quick_lanes.hpp"

#include <cmath>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr double memory_seconds = std::chrono::duration<double>(QuickLanes::memory).count();
constexpr double nothing = 1e-4; ///< s

} // namespace

double QuickLanes::Use::at(Time now) const {
    return seconds * std::exp(-std::chrono::duration<double>(now - since).count() / memory_seconds);
}

QuickLanes::Lane QuickLanes::push(const std::string& session, FairQueue::Job job, Time now) {
    Use& use = uses_[session];
    const bool much = use.at(now) > fair_share * memory_seconds;
    const Lane lane = much || use.upper >= most_ ? Lane::Lower : Lane::Upper;
    use.upper += lane == Lane::Upper ? 1 : 0;
    of(lane).push(session, std::move(job));
    return lane;
}

void QuickLanes::done(Lane lane, const std::string& session, double seconds, Time now) {
    of(lane).done(session);
    Use& use = uses_[session];
    use.upper -= lane == Lane::Upper ? 1 : 0;
    use.seconds = use.at(now) + seconds;
    use.since = now;
    if (now - swept_ > 40 * memory)
        forget_idle(now);
}

void QuickLanes::forget_idle(Time now) {
    swept_ = now;
    std::erase_if(uses_, [&](const auto& each) {
        return each.second.upper == 0 && each.second.at(now) < nothing;
    });
}

} // namespace wakesurf::server
