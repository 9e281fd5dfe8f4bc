// One file of VTK's XML formats that holds data itself: .vti .vtr .vts .vtu .vtp and .pvti .pvtr .pvts.
#pragma once

#include "importer/sources/blocks/wanted_arrays.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/vtk/vtk_file.hpp"

namespace wakesurf::importer {

/// Error: Io, Corrupt, Unsupported (several time-steps in one file), OverLimit (memory). REQUIRES: no VtkMessages lives.
core::Result<VtkFile> read_xml_file(const ListedFile& file, const WantedArrays& wanted);

/// Its TimeValue, if it has one; reads as little else as VTK allows. Error: as read_xml_file.
core::Result<StatedTime> xml_file_time(const ListedFile& file);

/// As vtk_file_fields.
core::Result<std::set<std::pair<core::FieldInfo::Source, std::string>>>
xml_file_fields(const ListedFile& file);

} // namespace wakesurf::importer
