// One meaning for `from`, `to` and `direction`, in the command line, the API and here: a surface starts at
// `from` and ends at `to`; where `to` is the earlier one, time runs backward. Stream and path surfaces may
// also go both ways: to `to`, which is the later end, and as long before `from`.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/surface_parameters.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::core {

/// Returns the time as people write it, to 12 digits: enough for seconds since 1970 with their milliseconds.
std::string time_text(double time);

/// Returns whether a time comes after `first` on the way to `last`, which may be the earlier one, and not
/// beyond it.
bool between(double time, double first, double last);

/// Returns 1, or -1 where time runs backward. A surface of both directions is shown at the times of its
/// forward side.
double time_sign(const SurfaceParameters& parameters);

/// Returns the time from `from` to `to`, never negative.
double time_span(const SurfaceParameters& parameters);

/// Returns the direction asked for, or what `from` and `to` say.
Direction direction_of(const SurfaceParameters& parameters);

/// Checks that `from`, `to` and `direction` go together. Error: InvalidArgument, whose hint has the right
/// spelling.
Result<void> check_direction(const SurfaceParameters& parameters);

/// Returns how long particles are followed, negative backward, on each side that there is. The backward side
/// of a path surface of both directions ends where the data begin, and is left out where they begin at
/// `from`.
std::vector<double> side_durations(const Flow& flow, const SurfaceParameters& parameters);

/// Returns, for a path surface of both directions, the time at which the data begin, if that cuts its
/// backward side short.
std::optional<double> data_end(const Flow& flow, const SurfaceParameters& parameters);

} // namespace wakesurf::core
