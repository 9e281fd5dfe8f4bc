// The selection of a source's time-steps to import: --times.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds T0:T1[:EVERY] of --times: both ends included, every EVERY-th time-step.
struct TimeSelection {
    double from = 0.0;
    double to = 0.0;
    std::size_t every = 1;
};

/// Parses ranges with commas between them: 8:10,12:16 leaves out a time-step between them, which may be
/// damaged. Error: InvalidArgument, beginning with "--times".
core::Result<std::vector<TimeSelection>> parse_times(const std::string& text);

/// Returns the indices into `times` that one of the ranges holds, all of them without ranges. Error:
/// OutOfTime if they hold none.
core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::vector<TimeSelection>& ranges);

} // namespace wakesurf::importer
