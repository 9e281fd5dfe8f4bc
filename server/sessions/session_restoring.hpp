// All that a server before this one kept of its sessions, given to those whose it is.
#pragma once

#include "server/base/journal.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

class Grants;
class SessionDirectory;

struct RestoredSessions {
    struct Refused {
        std::string session;
        KeptAside record;
    };

    std::size_t sessions = 0;
    std::size_t records = 0;
    /// The entries that could not be used; the journal has been asked to keep them aside.
    std::vector<Refused> refused;
};

/// Restores them by session, before any client is served; surfaces are built afterwards. Loop thread only.
RestoredSessions restore_sessions(const std::map<std::string, std::vector<JournalEntry>>& kept,
                                  SessionDirectory& sessions,
                                  Grants& grants);

} // namespace wakesurf::server
