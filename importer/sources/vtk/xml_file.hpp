// One file of VTK's XML formats that holds data itself: .vti .vtr .vts .vtu .vtp and .pvti .pvtr .pvts.
#pragma once

#include "importer/sources/series/series_times.hpp"
#include "importer/sources/vtk/vtk_file.hpp"

#include <vector>

namespace wakesurf::importer {

/// Reads it. Error: Io, Corrupt, Unsupported (several time-steps in one file), OverLimit (memory). REQUIRES:
/// no VtkMessages lives.
core::Result<VtkFile> read_xml_file(const ListedFile& file, const WantedArrays& wanted);

/// Returns its TimeValue, if it has one; reads as little else as VTK allows. Fails as read_xml_file does.
core::Result<StatedTime> xml_file_time(const ListedFile& file);

/// Returns the arrays that its header lists, those of each piece. Fails as read_xml_file does.
core::Result<std::vector<core::FieldInfo>> xml_file_fields(const ListedFile& file);

} // namespace wakesurf::importer
