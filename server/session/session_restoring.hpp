// All that a server before this one kept of its sessions, given to those whose it is.
#pragma once

#include "core/base/result.hpp"
#include "server/session/journal.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

class Grants;
class SessionDirectory;

struct RestoredSessions {
    std::size_t sessions = 0;
    std::size_t records = 0;
    std::vector<core::Error> refused; ///< what was left out, and why
};

/// By session. Before anybody is served; surfaces are built afterwards. Loop thread only.
RestoredSessions restore_sessions(const std::map<std::string, std::vector<JournalEntry>>& kept,
                                  SessionDirectory& sessions,
                                  Grants& grants);

} // namespace wakesurf::server
