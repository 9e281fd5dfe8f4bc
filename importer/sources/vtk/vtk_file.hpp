// One file of VTK's own formats, whichever it is.
#pragma once

#include "importer/sources/blocks/wanted_arrays.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <set>
#include <string>
#include <utility>

namespace wakesurf::importer {

struct VtkFile {
    vtkSmartPointer<vtkDataSet> data;
    std::string reader; ///< VTK's class
};

/// By extension: VTK's XML formats, legacy .vtk, VTKHDF.
bool is_vtk_file(const std::filesystem::path& path);

/// Arrays that are not wanted are left out where the format allows that. Error: Io, Corrupt, Unsupported, OverLimit
/// (memory). REQUIRES: no VtkMessages lives, as of all functions here.
core::Result<VtkFile> read_vtk_file(const ListedFile& file, const WantedArrays& wanted);

/// The time that the file itself states, if any: of a .vtm or .pvtu not those of the files it names.
core::Result<StatedTime> vtk_file_time(const ListedFile& file);

/// Names of the point and cell arrays that the file's header lists. Error: Unsupported, where only reading all of the file
/// would tell (legacy .vtk, VTKHDF); else as read_vtk_file.
core::Result<std::set<std::pair<core::FieldInfo::Source, std::string>>>
vtk_file_fields(const ListedFile& file);

} // namespace wakesurf::importer
