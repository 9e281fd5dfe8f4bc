// What the command `surface` writes and says of a surface that it has built.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_statistics.hpp"
#include "protocol/files/recipe.hpp"
#include "server/app/surface_request.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Estimates the error between stored times; statistics then have it, or why it is left out.
void state_interval_errors(core::Surface& surface,
                           const core::SurfacePlan& plan,
                           int threads,
                           const core::MemoryAccount& account,
                           const std::stop_token& stop);

/// Returns the recipe of a file of that name. REQUIRES: the name has a known extension.
protocol::Recipe recipe_for(const std::filesystem::path& name,
                            const SurfaceOptions& options,
                            const core::SurfacePlan& plan,
                            const LoadedDataset& dataset);

/// Prints how the result differs from the request to standard error. Error: there is nothing to see, for a
/// reason that can be cured.
core::Result<void> tell_statistics(const core::SurfaceStatistics& statistics, bool cut_short);

} // namespace wakesurf::server
