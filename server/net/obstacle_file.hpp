// The obstacle of a dataset as the bytes of obstacle.bin: its shape, and the flow along it.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/service/catalogue/open_dataset.hpp"

#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// When the data have the flow along an obstacle that is asked for at `time`: then, or in a steady flow at its one time. Error: OutOfTime.
core::Result<double> time_in_data(const LoadedDataset& dataset, double time);

/// Frames of one KEY, each preceded by its length. protocol/wire/README.md, Obstacle file.
/// @param time   as time_in_data says; nothing: without the flow
/// @param share  is grown to what it takes
/// Error: NotFound without an obstacle, OverLimit, and what sampling and encoding report.
core::Result<std::string> obstacle_frames(const LoadedDataset& dataset,
                                          std::optional<double> time,
                                          const core::MemoryAccount& account,
                                          core::MemoryAccount::Share& share,
                                          const std::stop_token& stop);

} // namespace wakesurf::server
