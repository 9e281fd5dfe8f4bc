// EnSight Gold cases (.case): text or binary, several parts, values at nodes or elements.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

bool is_ensight(const std::filesystem::path& path);

/// Blocks: the parts of three dimensions. Walls: those of two dimensions on the points of the blocks which are called
/// wall, or on which the velocity is zero at the first and last time-steps. Particles are left out. Values are 32 bits.
/// Error: as read_ensight_case and Source::read of the first time-step.
core::Result<std::unique_ptr<Source>> open_ensight(const std::filesystem::path& path,
                                                   const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
