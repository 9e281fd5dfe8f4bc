// The roles of a source's blocks: the fluid, and solids beside it that carry no velocity.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"

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

} // namespace wakesurf::importer
