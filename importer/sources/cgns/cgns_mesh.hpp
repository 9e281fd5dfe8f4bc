// Points and cells of a zone of a CGNS file, read with the CGNS library.
#pragma once

#include "importer/sources/cgns/cgns_file.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

namespace wakesurf::importer {

/// Cells are in the order of their numbers, without the elements of boundaries.
/// Error: Corrupt, Unsupported (curved cells, polyhedra, a mesh that moves).
core::Result<vtkSmartPointer<vtkDataSet>> read_cgns_mesh(const CgnsZone& zone);

} // namespace wakesurf::importer
