// What a process that reads files of strangers gives up before it opens the first: the network, starting programs,
// looking into other processes, and writing anywhere but in its store. A file that takes a reader over gets no further.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

namespace wakesurf::server {

struct LimitedRights {
    std::optional<std::filesystem::path>
        store; ///< the one folder to write to, made when missing; none: nowhere
    std::chrono::seconds stall{
        0}; ///< without progress for so long the process ends itself; 0: never
};

/// For this process and those it forks, for good. What the kernel does not know (Landlock before 5.13) is left out without a
/// word; the return value tells whether system calls are limited. Call it before there are threads.
bool limit_rights(const LimitedRights& rights);

/// Sets the clock of `stall` back.
void made_progress();

} // namespace wakesurf::server
