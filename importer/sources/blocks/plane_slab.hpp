// Cells of a plane, given a thickness: a slab of one cell across, in which particles stay in the plane. It lies
// evenly on both sides of the plane and is as thick as the cells are wide, in the mean.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns the slab of a structured block with one node along an axis, or of an unstructured grid of flat cells
/// with straight edges; nothing if it has other cells or does not lie in a plane. Values are the same on both
/// sides. A vector of two components in a plane of coordinates gets its third, which is zero; so does a velocity
/// or momentum of two scalars that are called like components of one. REQUIRES: the data set is sound.
std::optional<vtkSmartPointer<vtkDataSet>> slab_of(vtkDataSet& plane);

/// Returns the names of the components across a plane of coordinates, where two scalars have the names of the others:
/// w for u and v. @param across  the axis
std::vector<std::string> third_components(const std::vector<core::FieldInfo>& scalars, int across);

/// Returns what slab_of makes of the fields of a plane of coordinates. @param across  the axis
std::vector<core::FieldInfo> slab_fields(std::vector<core::FieldInfo> plane, int across);

/// Makes the slabs of one plane that lies in several blocks, as pieces of a parallel run, equally thick: each alone would be as thick
/// as its own cells are wide. It is in even_slabs.cpp. Error: Unsupported (slabs of
/// several planes, or beside cells in space), to be read after the name of what has the blocks.
core::Result<void> even_slabs(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks);

} // namespace wakesurf::importer
