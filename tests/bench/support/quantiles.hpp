// Quantiles of measured times.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace wakesurf::bench {

/// Returns the smallest value that at least `part` of all are not above; NaN without values.
inline double quantile(std::vector<double> values, double part) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(part * static_cast<double>(values.size()));
    return values[std::min(rank, values.size() - 1)];
}

} // namespace wakesurf::bench
