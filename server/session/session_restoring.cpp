#include "server/session/session_restoring.hpp"

#include "server/session/grants.hpp"
#include "server/session/session_directory.hpp"

#include <iterator>
#include <utility>

namespace wakesurf::server {

namespace {

void restore_people(const std::string& id,
                    const std::vector<JournalEntry>& entries,
                    Session& session,
                    Grants& grants,
                    std::vector<core::Error>& refused) {
    for (const JournalEntry& each : entries) {
        if (!each.record)
            continue;
        core::Result<void> done;
        if (each.type == "grant")
            done = grants.restore(id, each.id, *each.record);
        else if (each.type == "participant")
            done = session.participants().restore(each.id, *each.record);
        if (!done)
            refused.push_back(done.error());
    }
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
        if (const auto session = sessions.find(id))
            restore_people(id, entries, **session, grants, out.refused);
    }
    return out;
}

} // namespace wakesurf::server
