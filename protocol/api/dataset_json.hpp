// A dataset's description <-> JSON: the one shape of `info --json`, `dataset.describe` and a store's
// manifest.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string_view>

namespace wakesurf::protocol {

/// Returns `uniform`, `rectilinear`, ...
std::string_view grid_name(core::GridKind kind);

/// Returns nothing for a name this version does not know.
std::optional<core::GridKind> grid_kind(std::string_view name);

nlohmann::json dataset_json(const core::DatasetInfo& info);

/// Is the inverse of dataset_json. Unknown members are ignored, so that older programs read newer stores.
/// Error: Corrupt, naming the member that is missing, of the wrong type or not finite.
core::Result<core::DatasetInfo> parse_dataset_info(const nlohmann::json& value);

} // namespace wakesurf::protocol
