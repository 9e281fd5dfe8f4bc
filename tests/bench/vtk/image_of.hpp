// A time-step in memory as a VTK image that shares its velocities.
#pragma once

#include "core/dataset/grid.hpp"
#include "core/dataset/time_step_source.hpp"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace wakesurf::bench {

/// REQUIRES: the time-step outlives the image.
inline void
show_as_image(const core::UniformGrid& grid, const core::TimeStep& step, vtkImageData* image) {
    vtkNew<vtkFloatArray> velocity;
    velocity->SetName("velocity");
    velocity->SetNumberOfComponents(3);
    constexpr int owned_elsewhere = 1;
    velocity->SetArray(const_cast<float*>(step.velocity().data()),
                       static_cast<vtkIdType>(3 * grid.nodes()), owned_elsewhere);
    image->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
    image->SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
    const auto [nx, ny, nz] = grid.dimensions;
    image->SetDimensions(static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(nz));
    image->GetPointData()->SetVectors(velocity);
}

} // namespace wakesurf::bench
