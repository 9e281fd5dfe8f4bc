// Means over time of the fields of a dataset, stored as fields like any other. Shared by `mean.make` and
// `wakesurf means`.
#pragma once

#include "core/base/work_done.hpp"
#include "core/dataset/mean_record.hpp"
#include "server/data/mean_plan.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The most means of a dataset for holders of links, who cannot remove them: more are the host's alone.
inline constexpr std::size_t means_of_links = store::most_means / 2;

/// Checks a wish, as far as possible without reading values. Error: Unsupported (a built-in flow, data in one
/// time-step, or where nothing can be written), InvalidArgument (a missing field, a name that is taken, a
/// phase without a time-step), OutOfTime (fewer than two time-steps), Io.
core::Result<void> check_means(const LoadedDataset& dataset, const MeanWish& wish);

/// Makes and stores them in the caller's arena, field by field: what was stored when another one fails stays.
/// Those that are there are returned as they are. Error: as check_means; OverLimit, Cancelled, Corrupt, Io.
core::Result<std::vector<core::MeanRecord>> make_means(const LoadedDataset& dataset,
                                                       const MeanWish& wish,
                                                       const std::stop_token& stop,
                                                       const core::WorkPart& work = {});

/// Removes the mean that has a field of this name. Error: Unsupported (a built-in flow), NotFound, Io.
core::Result<void> remove_mean(const LoadedDataset& dataset, const std::string& name);

} // namespace wakesurf::server
