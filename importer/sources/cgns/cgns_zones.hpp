// The zones of a CGNS file, read with the CGNS library alone: for files whose elements are numbered as VTK's
// reader cannot read them. (It takes for cells what has a number up to their count, boundary or not, and
// leaves out the others without a word.)
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/series/file_series.hpp"

#include <optional>
#include <vector>

namespace wakesurf::importer {

/// Returns a leaf a zone: read_cgns_mesh with add_cgns_solutions. @param step  its place among the times of
/// the file; nothing where it has none
/// Error: Corrupt, Unsupported.
core::Result<std::vector<Leaf>> read_cgns_zones(const ListedFile& file,
                                                std::optional<std::size_t> step,
                                                const WantedArrays& wanted);

} // namespace wakesurf::importer
