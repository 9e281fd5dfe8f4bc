// The import itself: a source -> a store, several time-steps at once, going on where an earlier import of the same source
// ended and adding what a source has grown by.
#pragma once

#include "core/base/result.hpp"
#include "importer/import_plan.hpp"
#include "store/import_progress.hpp"

#include <functional>

namespace wakesurf::importer {

using ShowProgress = std::function<void(const store::ImportProgress&)>;

/// What the store will be, its ranges from the first time-step; writes nothing. The second and the last are read, too: the note
/// says if an import will end before one of them.
core::Result<core::DatasetInfo> describe_source(const ImportRequest& request);

/// Error: what the source or the disk is to blame for, naming file and time-step. The time-steps before it are in the store
/// and can be used; the same call goes on there.
core::Result<void>
convert(const ImportRequest& request, const std::filesystem::path& store, const ShowProgress& show);

} // namespace wakesurf::importer
