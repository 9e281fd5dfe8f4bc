// Sources that are files of VTK's own formats: one file, a numbered series, a .pvd or .series that lists files, and
// composite files (.vtm, .pvtu) in each of these places.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

/// Whether `path` is one of these, judged by its name.
bool is_vtk_files(const std::filesystem::path& path);

/// All parts of a time-step are blocks, but for flat ones: those are walls where their name holds "wall", or where their
/// velocity is exactly zero at the first, the last and the time-step read; other patches are left out. Blocks without the
/// velocity, beside blocks with it, are solids. Other fields that a time-step lacks are left out, with a note.
/// Reads the first time-step. Error: as open_source.
core::Result<std::unique_ptr<Source>> open_vtk_files(const std::filesystem::path& path,
                                                     const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
