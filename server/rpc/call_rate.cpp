#include "server/rpc/call_rate.hpp"

#include "server/limits.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

CallRate::CallRate()
    : calls_{limits::calls_per_second, limits::calls_at_once, limits::calls_at_once},
      edits_{limits::edits_per_second, limits::edits_at_once, limits::edits_at_once} {}

void CallRate::Bucket::fill(double seconds) {
    left = std::min(most, left + seconds * per_second);
}

std::chrono::milliseconds CallRate::Bucket::wait() const {
    return std::chrono::milliseconds(
        static_cast<long>(std::ceil(1000.0 * (1.0 - left) / per_second)));
}

std::optional<std::chrono::milliseconds> CallRate::take(bool edits, Time now) {
    const double seconds = std::chrono::duration<double>(now - filled_.value_or(now)).count();
    filled_ = now;
    calls_.fill(seconds);
    edits_.fill(seconds);
    if (calls_.left < 1.0)
        return calls_.wait();
    if (edits && edits_.left < 1.0)
        return edits_.wait();
    calls_.left -= 1.0;
    if (edits)
        edits_.left -= 1.0;
    return std::nullopt;
}

} // namespace wakesurf::server
