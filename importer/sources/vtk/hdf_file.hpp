// VTKHDF: an HDF5 file with VTK's layout, of an image or an unstructured grid (https://docs.vtk.org, VTKHDF
// 1.0).
#pragma once

#include "importer/sources/vtk/vtk_file.hpp"

namespace wakesurf::importer {

/// Decides by the extension: .vtkhdf, .hdf.
bool is_hdf(const std::filesystem::path& path);

/// Reads it. Error: Corrupt (not HDF5, damaged), Unsupported (HDF5 without VTK's layout; time-steps inside
/// the file, of which VTK 9.1 would read the first for each), OverLimit (memory). HDF5 itself may end the
/// process on hostile files.
core::Result<VtkFile> read_hdf_file(const ListedFile& file, const WantedArrays& wanted);

} // namespace wakesurf::importer
