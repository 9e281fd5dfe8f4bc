// What a process that reads files of strangers gives up before it opens the first: the network, starting programs,
// looking into other processes, and writing anywhere but in its store. A file that takes a reader over gets no further.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <optional>

namespace wakesurf::importer {

struct LimitedRights {
    std::optional<std::filesystem::path>
        store; ///< the one folder to write to, made when missing; none: nowhere
};

/// For this process and those it forks, for good. Call it before there are threads. A kernel without Landlock (before 5.13, or
/// switched off) leaves writing to the rights of the user, which is no error; anything else that fails is.
/// Error: Io, naming what could not be given up: read nothing then.
core::Result<void> limit_rights(const LimitedRights& rights);

/// Whether writing is limited to the store, besides what the user may write at all.
bool kernel_has_landlock();

} // namespace wakesurf::importer
