// What the options of `surface` leave open is chosen by the data: the rake, the times, the separation.
#pragma once

#include "core/base/result.hpp"
#include "server/app/surface_request.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>
#include <vector>

namespace wakesurf::server {

/// Completes the request, and prints to standard error what was chosen. Error: what sampling the data reports.
core::Result<void> choose_open_options(SurfaceRequest& request,
                                       const SurfaceOptions& options,
                                       const LoadedDataset& dataset,
                                       const std::stop_token& stop);

/// Fills in `from` and `to` if the options leave them open: the first and last time of the data, the other
/// way round with `--direction backward`; 10 time units from `from` if the data have no such times.
void choose_times(SurfaceRequest& request, const std::vector<double>& times);

} // namespace wakesurf::server
