// The time one of VTK's XML files carries, read without the rest of the file: series have thousands of files.
#pragma once

#include "server/import/sources/series/file_series.hpp"
#include "server/import/sources/vtk/xml_header.hpp"

namespace wakesurf::server {

/// The TimeValue of the field data, if there is one. REQUIRES: a VtkMessages lives; what VTK says in it is an error too.
/// Error: Corrupt (a TimeValue that cannot be read).
core::Result<std::optional<double>> xml_time(const ListedFile& file);

} // namespace wakesurf::server
