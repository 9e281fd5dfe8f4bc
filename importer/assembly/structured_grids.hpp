// One VTK image or rectilinear grid as a grid of ours.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/rectilinear_grid.hpp"
#include "core/dataset/uniform_grid.hpp"

#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>

namespace wakesurf::importer {

/// Error: Unsupported (fewer than two nodes along an axis), Corrupt. REQUIRES: the image is not rotated.
core::Result<core::UniformGrid> uniform_grid(vtkImageData& image);
core::Result<core::RectilinearGrid> rectilinear_grid(vtkRectilinearGrid& grid);

bool is_rotated(vtkImageData& image);

/// Whether cells or points of a data set are marked as hidden or as another piece's.
bool has_blanks(vtkDataSet& data);

} // namespace wakesurf::importer
