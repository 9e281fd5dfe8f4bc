// Values of a zone of a CGNS file, at nodes and in cells, read with the CGNS library.
#pragma once

#include "importer/sources/blocks/wanted_arrays.hpp"
#include "importer/sources/cgns/cgns_file.hpp"

#include <optional>

namespace wakesurf::importer {

/// Names as vtkCGNSReader gives them: VelocityX, Y and Z are Velocity. @param step  its place among the times of the file; nothing where
/// it has none. @param data  as read_cgns_mesh returned it. Error: Corrupt.
core::Result<void> add_cgns_solutions(const CgnsZone& zone,
                                      std::optional<std::size_t> step,
                                      const WantedArrays& wanted,
                                      vtkDataSet& data);

} // namespace wakesurf::importer
