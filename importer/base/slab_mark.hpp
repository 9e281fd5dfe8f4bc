// The mark of a block that was a plane before it was given a thickness: what is read of the velocity across it is no
// motion of particles.
#pragma once

#include "core/base/vec3.hpp"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>

#include <optional>

namespace wakesurf::importer {

inline constexpr const char* across_slab_name = "wakesurf: across the slab";

/// Marks a block. @param across  of length 1
inline void mark_slab(vtkDataSet& block, const core::Vec3& across) {
    const auto mark = vtkSmartPointer<vtkDoubleArray>::New();
    mark->SetName(across_slab_name);
    for (int k = 0; k < 3; ++k)
        mark->InsertNextValue(across[k]);
    block.GetFieldData()->AddArray(mark);
}

/// Returns the direction across a marked block; nothing of any other.
inline std::optional<core::Vec3> across_slab(vtkDataSet& block) {
    vtkDataArray* const mark = block.GetFieldData()->GetArray(across_slab_name);
    if (mark == nullptr || mark->GetNumberOfTuples() != 3)
        return std::nullopt;
    return core::Vec3(mark->GetTuple1(0), mark->GetTuple1(1), mark->GetTuple1(2));
}

} // namespace wakesurf::importer
