// OpenFOAM cases, whole or decomposed, through vtkOpenFOAMReader: one reader a processor folder, each of which it takes
// for a case of its own. (vtkPOpenFOAMReader appends the same parts, but passes over what a processor lacks.)
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

/// A folder with a mesh, or a .foam or .OpenFOAM file or controlDict in one.
bool is_openfoam(const std::filesystem::path& path);

/// Blocks: one a fluid region and processor. Walls: the patches of a type of wall. Solids: the boundaries of regions
/// without a velocity. Values are VTK's, 32 bits, of the cells; point fields and particles are left out.
/// Error: as scan_openfoam_case and Source::read of the first time-step.
core::Result<std::unique_ptr<Source>> open_openfoam(const std::filesystem::path& path,
                                                    const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
