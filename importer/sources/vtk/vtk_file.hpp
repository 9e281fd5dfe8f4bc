// One file of VTK's own formats as it was read, whichever it is.
#pragma once

#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/series/listed_series.hpp"

#include <string>

namespace wakesurf::importer {

struct VtkFile {
    vtkSmartPointer<vtkDataSet> data;
    /// The name of VTK's class.
    std::string reader;
};

} // namespace wakesurf::importer
