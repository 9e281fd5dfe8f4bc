#include "server/base/forecast.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

constexpr double too_early = 1.0; ///< seconds within which there is no forecast
constexpr double too_little = 0.02;

} // namespace

void Forecast::add(double seconds, double fraction) {
    if (!seen_.empty() && seconds < seen_.back().seconds)
        seen_.clear();
    seen_.push_back({seconds, fraction});
}

std::optional<double> Forecast::left() const {
    if (seen_.empty())
        return std::nullopt;
    const Seen now = seen_.back();
    if (now.fraction >= 1.0)
        return 0.0;
    if (now.seconds < too_early || now.fraction < too_little)
        return std::nullopt;
    const auto half =
        std::lower_bound(seen_.begin(), seen_.end(), 0.5 * now.seconds,
                         [](const Seen& each, double seconds) { return each.seconds < seconds; });
    // fraction = (seconds / total)^power; the fraction at half the time gives the power.
    double power = 1.0;
    if (half->fraction > 0.0 && half->seconds > 0.0 && half->seconds < now.seconds)
        power = std::log(now.fraction / half->fraction) / std::log(now.seconds / half->seconds);
    power = std::clamp(power, 0.25, 4.0);
    return now.seconds * (std::pow(now.fraction, -1.0 / power) - 1.0);
}

std::string words_for_left(double seconds) {
    const auto about = [](double number, const char* unit) {
        return "about " + std::to_string(static_cast<long>(std::max(1.0, std::round(number)))) +
               " " + unit + " left";
    };
    if (seconds < 90.0)
        return about(seconds, "s");
    return seconds < 5400.0 ? about(seconds / 60.0, "min") : about(seconds / 3600.0, "h");
}

} // namespace wakesurf::server
