// Converts between a store's layout and the members of store.json that say so.
#pragma once

#include "core/base/result.hpp"
#include "store/store_layout.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::store {

/// Leaves out the folder, because a store may be moved.
nlohmann::json store_layout_json(const StoreLayout& layout);

/// Error: Corrupt for what is missing, of the wrong type, or would lead out of the folder.
core::Result<StoreLayout> parse_store_layout(const nlohmann::json& value);

} // namespace wakesurf::store
