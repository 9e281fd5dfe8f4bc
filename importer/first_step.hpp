// The first time-step read whole: the grid that all time-steps share, its walls and its mask.
#pragma once

#include "importer/step_conversion.hpp"
#include "store/store_reader.hpp"

#include <optional>

namespace wakesurf::importer {

struct FirstStepReading {
    FirstStep first;
    SourceStep step; ///< with its values
    core::WallGeometry walls;
    /// The last time-step, if it was read and has the mesh of the first.
    std::optional<SourceStep> last;
};

/// Reads the first time-step; where pieces of the mesh meet also the second and the last, or all: velocities that jump there
/// keep them apart. Error: as Source::read and assemble_grid, naming the time-step.
/// @param with_last  reads the last time-step as well: boundary faces at rest at both are walls. Without it
/// they are not.
core::Result<FirstStepReading>
read_first_step(const ImportPlan& plan, bool with_last, bool with_all = false);

} // namespace wakesurf::importer
