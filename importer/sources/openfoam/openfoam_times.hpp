// Which times of an OpenFOAM case have a velocity, and which of its regions are fluid.
#pragma once

#include "importer/sources/openfoam/openfoam_case.hpp"

#include <set>

namespace wakesurf::importer {

/// Time folders of one part, by value. Error: Corrupt where two have the same value.
core::Result<std::vector<FoamTime>> list_foam_times(const std::filesystem::path& folder,
                                                    const std::string& part);

/// Names of what may be fields in a time folder, without .gz and without copies OpenFOAM itself passes over.
std::set<std::string> foam_fields(const std::filesystem::path& folder);

/// Sets `times` and which regions are fluid: those with a velocity, which is U, or else the vector field of most
/// times. Times that not all processors have are left out, with a note; so is the last one where their files differ.
/// Error: NotFound (no velocity anywhere, or at no time on all processors), Corrupt.
core::Result<void> find_foam_times(FoamCase& found);

} // namespace wakesurf::importer
