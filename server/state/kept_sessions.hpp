// What a server that ended has left in the folder of `--state`, ready to be gone on with.
#pragma once

#include "server/state/state_folder.hpp"
#include "server/state/state_store.hpp"

#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

struct KeptSessions {
    StateFolder folder;
    StateStore store;
    std::map<std::string, std::vector<JournalEntry>> sessions;

    /// Waits for the disk. Error: as StateFolder::hold, StateStore::open and load.
    static core::Result<KeptSessions> open(const std::filesystem::path& folder);
};

} // namespace wakesurf::server
