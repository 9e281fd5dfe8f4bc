// What a server that ended has left in the folder of `--state`, ready to be gone on with.
#pragma once

#include "server/service/journal/state_folder.hpp"
#include "server/service/journal/state_store.hpp"

#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

struct KeptSessions {
    StateFolder folder;
    StateStore store;
    std::map<std::string, std::vector<JournalEntry>>
        sessions; ///< also those of which nothing can be used
    std::map<std::string, std::vector<KeptAside>> aside;   ///< by earlier starts
    std::map<std::string, std::vector<KeptAside>> damaged; ///< since this one

    /// Waits for the disk. Error: as StateFolder::hold and StateStore::open.
    static core::Result<KeptSessions> open(const std::filesystem::path& folder);
};

} // namespace wakesurf::server
