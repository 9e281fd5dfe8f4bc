// VTK's old text format (.vtk, "# vtk DataFile Version ..."), ascii or binary.
#pragma once

#include "importer/sources/vtk/vtk_file.hpp"

#include <optional>

namespace wakesurf::importer {

/// Reads all arrays: the format has no table of them. Error: Io, Corrupt, OverLimit (memory).
core::Result<VtkFile> read_legacy_file(const ListedFile& file);

/// Returns the time that the title states in words, as Athena++ writes it: "... data at time= 0.1  cycle= 3".
std::optional<double> legacy_title_time(const ListedFile& file);

} // namespace wakesurf::importer
