// The mask array of a source -> solid nodes of a grid, or solid cells of a mesh.
#pragma once

#include "core/base/result.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/fields/field_choice.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::importer {

struct ObstacleMask {
    /// One value a node of a grid: 1 fluid, 0 solid. Empty without a mask, and for a mesh of cells.
    std::vector<std::uint8_t> fluid;
    std::vector<std::vector<bool>> solid; ///< of a mesh of cells: AssemblyRequest::solid

    bool operator==(const ObstacleMask&) const = default;
};

/// Says whether an array holds only 0 and 1; any other is no mask, whatever its name. Blocks without the
/// array are ignored.
bool is_zero_or_one(BlockList blocks, const core::FieldInfo& field);

/// Reads the mask. A node of a grid is solid where the array is; cell values are averaged to the nodes first
/// and count from one half. A cell of a mesh is solid where the array is, or where all its points are. Error,
/// to be read after the file's name: Corrupt (values other than 0 and 1), NotFound.
core::Result<ObstacleMask> read_mask(BlockList blocks, const FieldChoice& choice);

/// Takes the velocity away where a mask that is used for gaps marks a body: at its points, those of its cells, and
/// in cells. Does nothing for other uses. The blocks are changed for copies. Error: as read_mask.
core::Result<void> leave_body_out(std::vector<vtkSmartPointer<vtkDataSet>>& blocks,
                                  const FieldChoice& choice);

} // namespace wakesurf::importer
