// One variable file of EnSight Gold: values at the nodes or elements of the parts.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "importer/sources/ensight/ensight_geometry.hpp"

#include <vtkFloatArray.h>

namespace wakesurf::importer {

/// A part's values; of elements, split by their dimension as EnsightPart is. NaN where the file says undefined.
struct EnsightValues {
    vtkSmartPointer<vtkFloatArray> volume; ///< also those of nodes
    vtkSmartPointer<vtkFloatArray> faces;
};

/// By number of the part; parts without values are left out.
/// Error: NotFound, Io, Corrupt, Unsupported (partial values), OverLimit.
core::Result<std::map<std::size_t, EnsightValues>> read_ensight_variable(
    const NamedFile& file, const EnsightGeometry& geometry, const core::FieldInfo& field);

} // namespace wakesurf::importer
