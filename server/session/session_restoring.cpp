#include "server/session/session_restoring.hpp"

#include "server/session/grants.hpp"
#include "server/session/session_directory.hpp"

#include <iterator>
#include <utility>

namespace wakesurf::server {

namespace {

void restore_links(const std::string& id,
                   const std::vector<JournalEntry>& entries,
                   Grants& grants,
                   std::vector<core::Error>& refused) {
    for (const JournalEntry& each : entries)
        if (each.type == "grant" && each.record)
            if (auto done = grants.restore(id, each.id, *each.record); !done)
                refused.push_back(done.error());
}

} // namespace

RestoredSessions restore_sessions(const std::map<std::string, std::vector<JournalEntry>>& kept,
                                  SessionDirectory& sessions,
                                  Grants& grants) {
    RestoredSessions out;
    for (const auto& [id, entries] : kept) {
        RestoreReport report = sessions.restore(id, id, entries);
        ++out.sessions;
        out.records += report.restored;
        std::move(report.refused.begin(), report.refused.end(), std::back_inserter(out.refused));
        restore_links(id, entries, grants, out.refused);
        if (sessions.trash().find(id) != nullptr)
            grants.suspend(id);
    }
    return out;
}

} // namespace wakesurf::server
