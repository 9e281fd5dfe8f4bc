// The zones of a CGNS file, read with the CGNS library alone, for files whose elements are numbered as VTK's
// reader cannot read them. (It takes for cells the elements numbered up to the count of cells, boundary or
// not, and leaves out the others without a message.)
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/series/file_series.hpp"

#include <optional>
#include <vector>

namespace wakesurf::importer {

/// Returns a leaf a zone: read_cgns_mesh with add_cgns_solutions. Error: Corrupt, Unsupported.
/// @param dimension  of the cells: zones of other bases are left out. @param step  its index among the times of the file; empty if it has none
core::Result<std::vector<Leaf>> read_cgns_zones(const ListedFile& file,
                                                int dimension,
                                                std::optional<std::size_t> step,
                                                const WantedArrays& wanted);

} // namespace wakesurf::importer
