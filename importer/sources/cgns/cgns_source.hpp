// CGNS files (.cgns): structured and unstructured zones, each a block; one file of several time-steps, or numbered files.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

/// By extension: .cgns.
bool is_cgns(const std::filesystem::path& path);

/// Fields as vtkCGNSReader names them: VelocityX, Y, Z are Velocity, MomentumX, Y, Z are Momentum. Boundary patches are
/// left out. Zones without the velocity are solids. Reads the first time-step. Error: as open_source.
core::Result<std::unique_ptr<Source>> open_cgns(const std::filesystem::path& path,
                                                const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
