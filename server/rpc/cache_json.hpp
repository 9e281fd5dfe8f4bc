// The state of a dataset's time-step cache as cache.status and cache.patched tell it.
#pragma once

#include "core/dataset/time_step_cache.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace wakesurf::server {

/// {dataset, steps: [resident, loading or cold, ...], held: [[bytes in memory, bytes loading], ...], bytesPerStep, bytes, budget}
nlohmann::json cache_json(const std::string& dataset, const core::TimeStepCache::Status& status);

/// {dataset, changes: [[step, state], ...], held: [[step, bytes in memory, bytes loading], ...], bytes, budget}: what differs from `before`,
/// which may be empty or shorter.
nlohmann::json cache_changes_json(const std::string& dataset,
                                  const std::vector<core::StepHeld>& before,
                                  const core::TimeStepCache::Status& status);

} // namespace wakesurf::server
