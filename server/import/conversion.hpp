// The import itself: a series -> a store, step by step, going on where an earlier import of the same source ended.
#pragma once

#include "core/base/result.hpp"
#include "server/catalogue/import_progress.hpp"
#include "server/import/series.hpp"

#include <functional>
#include <optional>

namespace wakesurf::server {

struct ImportRequest {
    std::filesystem::path source;
    std::vector<std::string> fields;
    std::optional<TimeSelection> times;
    std::string selection; ///< both as the user wrote them, part of what the store was made from
};

using ShowProgress = std::function<void(const ImportProgress&)>;

/// What the store will be, its ranges from the first time-step; writes nothing.
core::Result<core::DatasetInfo> describe_source(const ImportRequest& request);

/// Error: what the source or the disk is to blame for, naming the file.
core::Result<void>
convert(const ImportRequest& request, const std::filesystem::path& store, const ShowProgress& show);

} // namespace wakesurf::server
