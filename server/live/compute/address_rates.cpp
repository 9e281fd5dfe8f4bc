#include "server/live/compute/address_rates.hpp"

#include "server/base/limits.hpp"

namespace wakesurf::server {

std::chrono::milliseconds AddressRates::wait_for(const std::string& from) {
    return of(from).wait_for(clock_.now(), 1.0);
}

void AddressRates::take(const std::string& from, double count) {
    of(from).take(clock_.now(), count);
}

TokenBucket& AddressRates::of(const std::string& from) {
    const auto now = clock_.now();
    if (left_.size() >= limits::addresses && !left_.contains(from))
        std::erase_if(left_, [now](const auto& each) { return each.second.full(now); });
    const bool room = left_.size() < limits::addresses || left_.contains(from);
    return left_.try_emplace(room ? from : std::string(), per_second_, at_once_, now).first->second;
}

} // namespace wakesurf::server
