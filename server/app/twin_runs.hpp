// What `wakesurf twin` compares a surface with: other runs of the case, other settings, a rake moved a little. Each is opened
// and planned; once the surface is there, its particles are traced through each of them.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/builder/twin.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/recipe.hpp"
#include "server/app/surface_request.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct TwinRun {
    std::string name; ///< as given
    bool name_is_data = false;
    core::TwinSettings settings{};
    LoadedDataset dataset{};
};

/// Checks the options, beside what check_surface_options checks. Error: InvalidArgument.
core::Result<void> check_twin_options(const SurfaceOptions& options);

/// Opens the data of all twins, imported first if needed. Error: as reading --with, and open_for_command.
core::Result<std::vector<TwinRun>> open_twins(const SurfaceOptions& options,
                                              const LoadedDataset& dataset,
                                              const core::MemoryAccount& account,
                                              const std::stop_token& stop);

/// Cuts the times of a surface to those that all twins have, and says so on standard error. Error: OutOfTime where there
/// are none.
core::Result<void> keep_common_times(core::SurfaceParameters& parameters,
                                     const std::vector<TwinRun>& twins);

/// Compares, prints the distances, and writes them by age where --csv names a file. One twin becomes the scalars
/// `twin_distance` and `twin_lag` of the surface and `twin` of its statistics; several become the surface's places, the mean
/// of all runs, and `twin_spread` and `twin_runs`. Error: as compare_twin and writing.
core::Result<protocol::MeshScalars> compare_twins(const SurfaceOptions& options,
                                                  const std::vector<TwinRun>& twins,
                                                  const core::SurfacePlan& plan,
                                                  core::Surface& surface,
                                                  const core::MemoryAccount& account,
                                                  const std::stop_token& stop);

/// Says in the recipe what was compared with, as far as that can be made again from the data alone.
void note_twins(protocol::Recipe& recipe, const std::vector<TwinRun>& twins);

} // namespace wakesurf::server
