// From a recipe and the data to the plan of its surface: what `wakesurf verify` has to know before it makes one again.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "protocol/files/recipe.hpp"
#include "server/data/open_dataset.hpp"

#include <string>

namespace wakesurf::server {

/// Says how the data are others than those of the recipe; empty: they are the same, and perhaps more time-steps.
std::string data_difference(const LoadedDataset& dataset, const protocol::Recipe& recipe);

/// Returns the plan. Error: as plan_surface, take_levels and check_fields.
core::Result<core::SurfacePlan> plan_of(const protocol::Recipe& recipe,
                                        const LoadedDataset& dataset);

} // namespace wakesurf::server
