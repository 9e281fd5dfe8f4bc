// Conversions between VTK's polygonal data and ours: rakes in, surfaces out.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <vtkPolyData.h>

#include <vector>

namespace wakesurf::importer {

/// Returns the points of the first line, in its order; all points if there is no line.
std::vector<core::Vec3> rake_points(vtkPolyData& rake);

/// Writes points as computed, polygons, and arrays by the names that files have.
void fill(vtkPolyData& output, const core::QuadComplex& mesh);

} // namespace wakesurf::importer
