// A dataset's description <-> JSON: the one shape of `info --json`, `dataset.describe` and a store's
// manifest.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/surface/family/family_record.hpp"
#include "protocol/api/base/json_table.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::protocol {

/// A family of stream surfaces <-> JSON: the one shape of `family.make`, `dataset.describe` and what is kept
/// beside the data.
nlohmann::json family_json(const core::FamilyRecord& family);

/// Is the inverse of family_json. Error: Corrupt, naming the member that is missing, of the wrong type or not
/// finite.
core::Result<core::FamilyRecord> parse_family(const nlohmann::json& value);

template <>
inline constexpr auto words_of<core::GridKind> = std::to_array<Word<core::GridKind>>({
    {core::GridKind::Uniform, "uniform"},
    {core::GridKind::Rectilinear, "rectilinear"},
    {core::GridKind::Curvilinear, "curvilinear"},
    {core::GridKind::Unstructured, "unstructured"},
    {core::GridKind::Analytic, "analytic"},
});

template <>
inline constexpr auto words_of<core::Precision> = std::to_array<Word<core::Precision>>(
    {{core::Precision::Single, "single"}, {core::Precision::Half, "half"}});

nlohmann::json dataset_json(const core::DatasetInfo& info);

/// Is the inverse of dataset_json. Unknown members are ignored, so that older programs read newer stores.
/// Error: Corrupt, naming the member that is missing, of the wrong type or not finite.
core::Result<core::DatasetInfo> parse_dataset_info(const nlohmann::json& value);

} // namespace wakesurf::protocol
