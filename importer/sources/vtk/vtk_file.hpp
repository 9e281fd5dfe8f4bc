// Files of VTK's own formats, one reader each, and the files of which a composite one is made.
#pragma once

#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/series/series_times.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// A file as it was read, whichever format it is.
struct VtkFile {
    vtkSmartPointer<vtkDataSet> data;
    /// The name of VTK's class.
    std::string reader;
};

/// Reads a file of the XML formats that holds data itself: .vti .vtr .vts .vtu .vtp and .pvti .pvtr .pvts. Error: Io, Corrupt, Unsupported (several time-steps in one file), OverLimit (memory). REQUIRES:
/// no VtkMessages lives.
core::Result<VtkFile> read_xml_file(const ListedFile& file, const WantedArrays& wanted);

/// Returns its TimeValue, if it has one; reads as little else as VTK allows. Fails as read_xml_file does.
core::Result<StatedTime> xml_file_time(const ListedFile& file);

/// Returns the arrays that its header lists, those of each piece. Fails as read_xml_file does.
core::Result<std::vector<core::FieldInfo>> xml_file_fields(const ListedFile& file);

/// Reads a file of the old text format (.vtk, "# vtk DataFile Version ..."), ascii or binary, with all arrays: the format has no table of them. Error: Io, Corrupt, OverLimit (memory).
core::Result<VtkFile> read_legacy_file(const ListedFile& file);

/// Returns the time that the title states in words, as Athena++ writes it: "... data at time= 0.1  cycle= 3".
std::optional<double> legacy_title_time(const ListedFile& file);

/// Decides by the extension: .vtkhdf, .hdf.
bool is_hdf(const std::filesystem::path& path);

/// Reads VTKHDF, an HDF5 file with VTK's layout, of an image or an unstructured grid (https://docs.vtk.org, VTKHDF 1.0). Error: Corrupt (not HDF5, damaged), Unsupported (HDF5 without VTK's layout; time-steps inside
/// the file, of which VTK 9.1 would read the first for each), OverLimit (memory). HDF5 itself may end the
/// process on hostile files.
core::Result<VtkFile> read_hdf_file(const ListedFile& file, const WantedArrays& wanted);

/// Files made of other files: .vtm (blocks, nested), .pvtu and .pvtp (pieces); and every other file, alone.
struct CompositeFile {
    /// All files: the composite ones, the leaves, the pieces that leaves are made of.
    std::vector<ListedFile> files;
    /// The files that are read, in order; `block` is their position among the blocks.
    std::vector<ListedFile> leaves;
    /// Names a .vtm that ends before its elements do: what it lists may not be all.
    std::string cut{};
};

/// Decides by the extension: .vtm, .vtmb, .pvtu and the like.
bool names_others(const std::filesystem::path& path);

/// Reads the composite files, not the leaves, but checks that all exist. Error: NotFound (naming the file
/// that names the missing one), Io, Corrupt, Unsupported (nested too deeply). REQUIRES: no VtkMessages lives.
core::Result<CompositeFile> expand(const ListedFile& file);

} // namespace wakesurf::importer
