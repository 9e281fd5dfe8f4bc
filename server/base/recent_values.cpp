#include "server/base/recent_values.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::server {

void RecentValues::add(Time now, double value) {
    const std::lock_guard lock(mutex_);
    values_[added_++ % most] = {now, static_cast<float>(value)};
}

Quantiles RecentValues::quantiles(Time now) const {
    std::vector<double> recent;
    {
        const std::lock_guard lock(mutex_);
        const auto held = std::min<std::uint64_t>(added_, most);
        for (std::size_t i = 0; i < held; ++i)
            if (now - values_[i].at <= window)
                recent.push_back(static_cast<double>(values_[i].value));
    }
    if (recent.empty())
        return {};
    std::sort(recent.begin(), recent.end());
    const auto at = [&](double part) {
        const auto rank = std::ceil(part * static_cast<double>(recent.size()));
        return recent[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
    };
    return {at(0.50), at(0.95), at(0.99), recent.size()};
}

} // namespace wakesurf::server
