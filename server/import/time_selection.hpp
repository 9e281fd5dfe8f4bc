// Which of a source's time-steps are imported: --times.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// T0:T1[:EVERY] of --times: both ends included, every EVERY-th time-step.
struct TimeSelection {
    double from = 0.0;
    double to = 0.0;
    std::size_t every = 1;
};

/// Error: InvalidArgument, beginning with "--times".
core::Result<TimeSelection> parse_times(const std::string& text);

/// Indices into `times`, all of them without a selection. Error: OutOfTime where it holds none.
core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::optional<TimeSelection>& selection);

} // namespace wakesurf::server
