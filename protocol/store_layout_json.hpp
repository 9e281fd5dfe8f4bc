// What lies where in a store <-> the members of store.json that say so.
#pragma once

#include "core/dataset/store_layout.hpp"
#include "protocol/json_members.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::protocol {

/// Without the folder: a store may be moved.
nlohmann::json store_layout_json(const core::StoreLayout& layout);

/// Leaves a fault in `members` for what is missing, of the wrong type, or would lead out of the folder.
core::StoreLayout parse_store_layout(JsonMembers& members);

} // namespace wakesurf::protocol
