// The obstacle of a dataset as the bytes of obstacle.bin: its shape, and the flow along it.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/data/open_dataset.hpp"

#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Returns the time at which the data have the flow for a request at `time`: the same, or the one time of a
/// steady flow. Error: OutOfTime.
core::Result<double> time_in_data(const LoadedDataset& dataset, double time);

/// Returns the frames of one KEY, each preceded by its length. protocol/wire/README.md, Obstacle file. Error:
/// NotFound without an obstacle, OverLimit, and as sampling and encoding.
/// @param time   as time_in_data returns it; empty: without the flow
/// @param share  is grown to the memory needed
core::Result<std::string> obstacle_frames(const LoadedDataset& dataset,
                                          std::optional<double> time,
                                          const core::MemoryAccount& account,
                                          core::MemoryAccount::Share& share,
                                          const std::stop_token& stop);

} // namespace wakesurf::server
