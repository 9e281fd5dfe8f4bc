// The mask array of a source -> solid nodes of a grid, or solid cells of a mesh.
#pragma once

#include "core/base/result.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/fields/field_choice.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::importer {

struct ObstacleMask {
    std::vector<std::uint8_t>
        fluid; ///< of a grid: 1 fluid, 0 solid, one a node; empty without a mask
    std::vector<std::vector<bool>> solid; ///< of a mesh of cells: AssemblyRequest::solid

    bool operator==(const ObstacleMask&) const = default;
};

/// Whether an array holds 0 and 1 only: one that does not is no mask, whatever its name. Also where a block does not have it.
bool is_zero_or_one(BlockList blocks, const core::FieldInfo& field);

/// Of a grid a node is solid where the array is; cell values are averaged to the nodes first and count from one half. Of a
/// mesh a cell is solid where the array is, or where all its points are.
/// Error, to be read after the file's name: Corrupt (values other than 0 and 1), NotFound.
core::Result<ObstacleMask> read_mask(BlockList blocks, const FieldChoice& choice);

} // namespace wakesurf::importer
