// What the blocks of a source are for: the fluid, and solids beside it that carry no velocity.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"

#include <string>
#include <vector>

namespace wakesurf::importer {

struct BlockRoles {
    std::vector<bool> fluid; ///< of each block; those that are not are solids, for display
    std::vector<core::FieldInfo> fields; ///< common_fields of the fluid
    std::string note;                    ///< names what only some blocks have; may be empty
};

/// Fluid is every block that has the velocity as choose_velocity(.., velocity) finds it among the fields of all of them. Where that finds none,
/// or several, every block with a vector is; where none has one, all blocks are. A block that has a field of the velocity's name at
/// another place is fluid too: that it does not fit the others is told when fields are chosen, not drawn as a solid.
BlockRoles block_roles(const Blocks& blocks, const std::string& velocity);

/// The note about fields that are left out: "left out, as only some parts have them: p, T". Empty without names.
std::string only_on_some_parts(const std::vector<std::string>& names);

} // namespace wakesurf::importer
