// The surfaces that a picture or a film shows, made again from the recipes in it.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "protocol/files/recipe.hpp"
#include "server/data/open_dataset.hpp"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// A surface at the times at which it is shown.
struct ShownSurface {
    protocol::Recipe recipe; ///< without a time and a shape

    struct State {
        std::optional<double> time;
        std::string shape;
    };

    std::vector<State> states; ///< in the order in which the surface moves
};

/// Puts the recipes of each surface together: a film has one a frame.
std::vector<ShownSurface> shown_surfaces(const std::vector<protocol::FoundRecipe>& found);

/// Returns the times at which the surface made again is another than the one shown; empty: none. Cost: that of the surface at its last
/// time. Error: as plan_of, surface_at and Evolution.
core::Result<std::vector<double>> times_that_differ(const ShownSurface& shown,
                                                    const LoadedDataset& dataset,
                                                    const core::MemoryAccount& account,
                                                    const std::stop_token& stop);

} // namespace wakesurf::server
