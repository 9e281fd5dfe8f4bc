// `wakesurf surface -o FILE.html`, `-o FILE.csv` and `-o NAME_%03d.EXT`: several states of one surface, built once.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/measures/region.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "server/app/surface_request.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>

namespace wakesurf::server {

/// Builds the surface until the last time of the series and writes the animation, the numbers or the files. Files that
/// are there are replaced, each when it is whole; an animation or a file of numbers is whole or not there.
/// Error: as times_of, building, encoding and writing; NotFound without the viewer of animations.
core::Result<void> write_series(const SurfaceOptions& options,
                                const Series& series,
                                const std::optional<core::Region>& through,
                                core::SurfacePlan plan,
                                const LoadedDataset& dataset,
                                const core::MemoryAccount& account,
                                const std::stop_token& stop);

} // namespace wakesurf::server
