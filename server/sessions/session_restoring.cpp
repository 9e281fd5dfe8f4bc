#include "server/sessions/session_restoring.hpp"

#include "server/sessions/people/grants.hpp"
#include "server/sessions/session_directory.hpp"

#include <utility>

namespace wakesurf::server {

namespace {

void restore_links(const std::string& id,
                   const std::vector<JournalEntry>& entries,
                   Grants& grants,
                   std::vector<RefusedEntry>& refused) {
    for (const JournalEntry& each : entries)
        if (each.type == "grant" && each.record)
            if (auto done = grants.restore(id, each.id, *each.record); !done)
                refused.push_back(refused_entry(each, std::move(done.error())));
}

} // namespace

RestoredSessions restore_sessions(const std::map<std::string, std::vector<JournalEntry>>& kept,
                                  SessionDirectory& sessions,
                                  Grants& grants) {
    RestoredSessions out;
    for (const auto& [id, entries] : kept) {
        const RestoreReport report = sessions.restore(id, id, entries);
        ++out.sessions;
        out.records += report.restored;
        std::vector<RefusedEntry> refused;
        restore_links(id, entries, grants, refused);
        if (sessions.trash().find(id) != nullptr)
            grants.suspend(id); // what of it cannot be used is put aside once it is brought back
        const auto session = sessions.find(id);
        if (!session)
            continue;
        (*session)->set_aside(refused);
        for (const KeptAside& each : (*session)->kept_aside())
            out.refused.push_back({id, each});
    }
    return out;
}

} // namespace wakesurf::server
