// VTK's old text format (.vtk, "# vtk DataFile Version ..."), ascii or binary.
#pragma once

#include "server/import/sources/vtk/vtk_file.hpp"

namespace wakesurf::server {

/// Reads all arrays: the format has no table of them. Error: Io, Corrupt, OverLimit (memory).
core::Result<VtkFile> read_legacy_file(const ListedFile& file);

} // namespace wakesurf::server
