// The import itself: a source -> a store, several time-steps at once. It resumes an earlier import of the
// same source, and adds what a source has grown by.
#pragma once

#include "core/base/result.hpp"
#include "importer/import_plan.hpp"
#include "store/import_progress.hpp"

#include <functional>

namespace wakesurf::importer {

using ShowProgress = std::function<void(const store::ImportProgress&)>;

/// Describes the store to be, with ranges of the first time-step; writes nothing. It also reads the second
/// and the last time-step: the note says if an import would end before one of them.
core::Result<core::DatasetInfo> describe_source(const ImportRequest& request);

/// Imports a source. An error blames the source or the disk, and names file and time-step. The time-steps
/// before it are in the store and can be used; the same call resumes there.
core::Result<void>
convert(const ImportRequest& request, const std::filesystem::path& store, const ShowProgress& show);

} // namespace wakesurf::importer
