// A family of stream surfaces <-> JSON: the one shape of `family.make`, `dataset.describe` and what is kept
// beside the data.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/family/family_record.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::protocol {

nlohmann::json family_json(const core::FamilyRecord& family);

/// Is the inverse of family_json. Error: Corrupt, naming the member that is missing, of the wrong type or not
/// finite.
core::Result<core::FamilyRecord> parse_family(const nlohmann::json& value);

} // namespace wakesurf::protocol
