// Rights that a process which reads untrusted files gives up before it opens the first: the network, starting
// programs, inspecting other processes, reading outside its source, and writing outside its store. A file that
// takes a reader over, or names other files to a library, gets no further.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace wakesurf::importer {

struct LimitedRights {
    /// The one folder to write to, made if missing; without it no folder may be written to.
    std::optional<std::filesystem::path> store;
    /// The files to read, and folders with all below, beside the store and the libraries' own.
    std::vector<std::filesystem::path> sources{};
    /// Files and folders that may not be read, wherever they lie but in the store.
    std::vector<std::filesystem::path> secrets{};
};

/// Limits this process and its future children for good. Call it before there are threads. Without Landlock
/// in the kernel (before 5.13, or switched off) the rights of the user bound reading and writing, which is no
/// error; any other failure is. Error: Io, naming what could not be given up; then read nothing.
core::Result<void> limit_rights(const LimitedRights& rights);

/// Says whether this kernel can limit reading and writing beyond the rights of the user.
bool kernel_has_landlock();

} // namespace wakesurf::importer
