// Scans a case's folders for its parts, regions and times.
#pragma once

#include "importer/sources/openfoam/openfoam_case.hpp"

namespace wakesurf::importer {

/// Finds the parts of a case. `path`: its folder, its .foam or .OpenFOAM file or its system/controlDict.
/// Error: NotFound (no mesh, no times), Unsupported (a mesh that moves, collated files), Corrupt, Io.
/// @param velocity  names the one asked for; may be empty
core::Result<FoamCase> scan_openfoam_case(const std::filesystem::path& path,
                                          const std::string& velocity = {});

/// Returns the case's folder, if `path` is one of those that scan_openfoam_case takes.
std::filesystem::path openfoam_folder(const std::filesystem::path& path);

} // namespace wakesurf::importer
