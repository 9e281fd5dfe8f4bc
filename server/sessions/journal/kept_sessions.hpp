// The sessions that an earlier server has left in the folder of `--state`.
#pragma once

#include "server/sessions/journal/state_folder.hpp"
#include "server/sessions/journal/state_store.hpp"

#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

struct KeptSessions {
    StateFolder folder;
    StateStore store;
    /// All sessions, also those without a usable record.
    std::map<std::string, std::vector<JournalEntry>> sessions;
    std::map<std::string, std::vector<KeptAside>> aside;   ///< by earlier starts
    std::map<std::string, std::vector<KeptAside>> damaged; ///< since this start

    /// Opens the folder; waits for the disk. Error: as StateFolder::hold and StateStore::open.
    static core::Result<KeptSessions> open(const std::filesystem::path& folder);
};

} // namespace wakesurf::server
