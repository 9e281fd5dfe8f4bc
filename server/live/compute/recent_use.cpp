#include "server/live/compute/recent_use.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

constexpr double nothing = 1e-4; ///< s

double seconds_of(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

double RecentUse::at(const Use& use, Time now) const {
    return use.seconds * std::exp(-seconds_of(now - use.since) / seconds_of(memory_));
}

void RecentUse::add(const std::string& session, double seconds, Time now) {
    Use& use = uses_[session];
    use = {at(use, now) + seconds, now};
    if (now - swept_ > 40 * memory_)
        forget_idle(now);
}

double RecentUse::share(const std::string& session, Time now) const {
    const auto found = uses_.find(session);
    return found == uses_.end() ? 0.0 : at(found->second, now) / seconds_of(memory_);
}

std::size_t RecentUse::busier_than(double share, Time now) const {
    return static_cast<std::size_t>(
        std::count_if(uses_.begin(), uses_.end(), [&](const auto& each) {
            return at(each.second, now) > share * seconds_of(memory_);
        }));
}

void RecentUse::forget_idle(Time now) {
    swept_ = now;
    std::erase_if(uses_, [&](const auto& each) { return at(each.second, now) < nothing; });
}

} // namespace wakesurf::server
