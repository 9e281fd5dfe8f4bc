// Cubic interpolation between stored times, which need not be equally far apart.
#pragma once

#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Shares of four time-steps in the value at a time between the middle two: cubic with the slopes of the
/// parabolas through three neighbours, one-sided at the ends of the series. Nothing stands for a time-step
/// that is missing.
inline std::array<double, 4>
cubic_time_shares(const std::array<double, 4>& time, bool before, bool after, double t) {
    const double h = time[2] - time[1];
    const double h0 = before ? time[1] - time[0] : h;
    const double h2 = after ? time[3] - time[2] : h;
    const double u = (t - time[1]) / h;
    // Shares of the three differences v1 - v0, v2 - v1, v3 - v2 over their times in the slopes at both ends.
    std::array<double, 3> slope1{0.0, 1.0, 0.0};
    std::array<double, 3> slope2{0.0, 1.0, 0.0};
    if (before)
        slope1 = {h / (h0 + h), h0 / (h0 + h), 0.0};
    else if (after)
        slope1 = {0.0, 1.0 + h / (h + h2), -h / (h + h2)};
    if (after)
        slope2 = {0.0, h2 / (h + h2), h / (h + h2)};
    else if (before)
        slope2 = {-h / (h0 + h), 1.0 + h / (h0 + h), 0.0};
    const double rising = u * u * (3.0 - 2.0 * u);
    const double bend1 = h * u * (1.0 - u) * (1.0 - u);
    const double bend2 = h * u * u * (u - 1.0);
    const auto difference = [&](std::size_t i, double width) {
        return (bend1 * slope1[i] + bend2 * slope2[i]) / width;
    };
    const double d0 = difference(0, h0);
    const double d1 = difference(1, h);
    const double d2 = difference(2, h2);
    return {-d0, 1.0 - rising + d0 - d1, rising + d1 - d2, d2};
}

} // namespace wakesurf::core
