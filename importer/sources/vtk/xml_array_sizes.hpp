// That the arrays of a VTK XML file are stored with as many bytes as the file says elsewhere. VTK believes either:
// it reads the beginning of longer arrays, and divides by a block size that a flipped bit made zero.
#pragma once

#include "importer/sources/series/file_series.hpp"
#include "importer/sources/vtk/xml_header.hpp"

namespace wakesurf::importer {

/// Looks at the length each array stored in binary begins with; text arrays are counted by VTK. Error: Corrupt, naming
/// the array.
core::Result<void> check_array_sizes(const ListedFile& file, const XmlHeader& header);

} // namespace wakesurf::importer
