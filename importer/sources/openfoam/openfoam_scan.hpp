// Looks at a case's folders for what it is made of.
#pragma once

#include "importer/sources/openfoam/openfoam_case.hpp"

namespace wakesurf::importer {

/// Finds what a case is made of. `path`: its folder, its .foam or .OpenFOAM file or its system/controlDict.
/// @param velocity  names the one asked for; may be empty
/// Error: NotFound (no mesh, no times), Unsupported (a mesh that moves, collated files), Corrupt, Io.
core::Result<FoamCase> scan_openfoam_case(const std::filesystem::path& path,
                                          const std::string& velocity = {});

/// Returns the case's folder, where `path` is one of what scan_openfoam_case takes.
std::filesystem::path openfoam_folder(const std::filesystem::path& path);

} // namespace wakesurf::importer
