// The time at which a field is asked for, as the data have it.
#pragma once

#include "core/field/flow.hpp"

namespace wakesurf::core {

/// Returns the time, at the nearer end of the data where it is beyond by rounding. Error: OutOfTime, saying which times there are.
Result<double> time_in_data(const Flow& flow, double time);

} // namespace wakesurf::core
