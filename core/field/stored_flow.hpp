// Stored data on a uniform grid as a flow: time-steps come through the cache, interval by interval.
#pragma once

#include "core/base/clock.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/flow.hpp"
#include "core/field/kernel/simd.hpp"

#include <memory>

namespace wakesurf::core {

/// @param clock measures how long tracing waits for time-steps
/// @param simd  for tests, and for users who mistrust their processor: results are the same bits
std::unique_ptr<Flow>
make_stored_flow(std::shared_ptr<TimeStepCache> cache,
                 std::shared_ptr<const Clock> clock = std::make_shared<SteadyClock>(),
                 Simd simd = Simd::Best);

} // namespace wakesurf::core
