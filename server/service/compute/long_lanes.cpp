#include "server/service/compute/long_lanes.hpp"

#include <algorithm>

namespace wakesurf::server {

FairQueue::Used LongLanes::used(Time now) const {
    return [this, now](const std::string& session) {
        return lone_.contains(session) ? 1.0 : use_.share(session, now);
    };
}

bool LongLanes::room(Time now) const {
    const auto young = std::count_if(running_.begin(), running_.end(), [&](const auto& each) {
        return now - each.second < settling;
    });
    return static_cast<std::size_t>(young) < light_jobs;
}

void LongLanes::push_lone(FairQueue::Job job) {
    const std::string name = "\n" + std::to_string(next_lone_++); // no session is called like that
    lone_.insert(name);
    queue_.push(name, std::move(job));
}

std::optional<FairQueue::Turn> LongLanes::pop(Lane lane, Time now) {
    if (lane == Lane::Any)
        return queue_.pop();
    if (!room(now))
        return std::nullopt;
    auto turn = queue_.pop_least(used(now), light_share);
    if (turn)
        running_[turn->session] = now;
    return turn;
}

bool LongLanes::ready(Lane lane, Time now) const {
    if (lane == Lane::Any)
        return queue_.ready();
    return room(now) && queue_.ready_below(used(now), light_share);
}

void LongLanes::done(const std::string& session, double seconds, Time now) {
    queue_.done(session);
    running_.erase(session);
    if (lone_.erase(session) == 0)
        use_.add(session, seconds, now);
}

} // namespace wakesurf::server
