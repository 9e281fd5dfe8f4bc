// A first picture of a flow: a rake, and for each kind of surface the times and the separation, all from the
// data. Commands, scripts and the page begin with it unless the user chooses otherwise.
#pragma once

#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/field/flow.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// The facts about a series that a suggestion depends on, beside the flow itself.
struct SeriesFacts {
    std::vector<double> times;          ///< strictly increasing; at least one
    bool steady = false;                ///< it has one field for all times
    std::uint64_t bytes_per_step = 0;   ///< of a time-step's velocity
    std::optional<SymmetryAxis> axis{}; ///< of an axisymmetric flow
};

/// A suggested scene.
struct SceneSuggestion {
    Rake rake; ///< one for all its surfaces
    /// One surface of each kind that the data allow: a single time-step of a flow that is not steady allows
    /// only stream surfaces.
    std::vector<SurfaceParameters> surfaces;
    std::string why; ///< a sentence for people
};

/// All surfaces end at the same time, the last of the data, so that to choose another kind moves no clock.
/// They go on for as long as the flow needs from the rake to the end of the domain; long series of large
/// time-steps are used in part, from their end.
///
/// Cost: one time-step of the data, two where the flow is at rest at the first of them, and some 30,000
/// samples. Error: as Flow::sample.
Result<SceneSuggestion> suggest_scene(const Flow& flow,
                                      const SeriesFacts& series,
                                      const WallGeometry& walls,
                                      std::stop_token stop);

} // namespace wakesurf::core
