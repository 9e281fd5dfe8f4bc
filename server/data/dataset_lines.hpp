// Streamlines of a dataset: from where they are released to the lines.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>

namespace wakesurf::server {

/// Error: as check_line_seeds and trace_stream_lines; NotFound for seeds at walls or patches where there are none.
core::Result<core::StreamLines> dataset_lines(const core::LineSeeds& seeds,
                                              const core::StreamLinesRequest& request,
                                              const LoadedDataset& dataset,
                                              core::WorkMemory& memory,
                                              const std::stop_token& stop);

} // namespace wakesurf::server
