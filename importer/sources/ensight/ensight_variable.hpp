// One variable file of EnSight Gold: values at the nodes or elements of the parts.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "importer/sources/ensight/ensight_geometry.hpp"

#include <vtkFloatArray.h>

namespace wakesurf::importer {

/// Holds a part's values; those of elements are split by their dimension like EnsightPart. NaN stands for
/// undefined.
struct EnsightValues {
    vtkSmartPointer<vtkFloatArray> volume; ///< also those of nodes
    vtkSmartPointer<vtkFloatArray> faces;
};

/// Returns values by the number of the part, without parts that have none. Error: NotFound, Io, Corrupt,
/// Unsupported (partial values), OverLimit.
core::Result<std::map<std::size_t, EnsightValues>> read_ensight_variable(
    const NamedFile& file, const EnsightGeometry& geometry, const core::FieldInfo& field);

} // namespace wakesurf::importer
