// The roles of a source's blocks: the fluid, solids beside it that carry no velocity, and flat parts that are walls; and the
// surfaces of walls and solids.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

struct BlockRoles {
    /// True for each block of the fluid; the others are solids, for display.
    std::vector<bool> fluid;
    std::vector<core::FieldInfo> fields; ///< common_fields of the fluid
    std::string note; ///< names of fields that only some blocks have; may be empty
};

/// Finds the fluid: every block that has the velocity as choose_velocity(.., velocity) finds it among the
/// fields of all. If that finds none, or several, every block with a vector; if none has one, all blocks. A
/// block with a field of the velocity's name at another place (points, cells) is fluid too: choosing fields
/// then reports that it does not fit the others.
BlockRoles block_roles(const Blocks& blocks, const std::string& velocity);

/// Returns the note about fields that are left out: "left out, as only some parts have them: p, T". Empty
/// without names.
std::string only_on_some_parts(const std::vector<std::string>& names);

/// Says whether the last part of a patch's path ("boundary/lowerWall") holds "wall", in any case.
bool is_named_wall(const std::string& patch);

/// Says whether there is a vector among `fields`, the data set has it, and each of these is exactly zero
/// everywhere.
bool is_still(vtkDataSet& patch, const std::vector<core::FieldInfo>& fields);

/// Says whether the first vector of `fields`, the velocity, is exactly zero everywhere.
bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields);

/// Returns the two-dimensional cells of a grid that has no others, with the points and point data it has.
vtkSmartPointer<vtkPolyData> faces_of(vtkDataSet& grid);

/// Returns the patch as polygons with its points as they are; data arrays are left out. Error: Corrupt (nodes
/// that are not there), naming `file`.
core::Result<vtkSmartPointer<vtkPolyData>> surface_of(vtkDataSet& patch, const std::string& file);

/// Returns the outside of a checked block of cells.
vtkSmartPointer<vtkPolyData> boundary_of(vtkDataSet& block);

} // namespace wakesurf::importer
