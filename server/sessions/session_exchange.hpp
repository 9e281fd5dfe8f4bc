// Sessions between servers: what goes into a session file, and what comes out of one, checked as if a
// stranger had written it.
#pragma once

#include "protocol/api/session_file.hpp"
#include "server/base/journal.hpp"
#include "server/data/datasets.hpp"
#include "server/sessions/records/record_entries.hpp"
#include "server/sessions/session.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// All that a server before this one kept of its sessions, given to those whose it is.
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

/// Holds a session's values at one moment, so that its file can be written elsewhere.
struct SessionSnapshot {
    std::string name;
    SessionRecords records;
    protocol::ClockRecord clock;
    std::vector<protocol::DatasetMark> datasets; ///< that the surfaces name
    std::int64_t taken = 0;                      ///< seconds since 1970
    protocol::SessionUnits units{};
};

/// Loop thread only. @param now  seconds since 1970
SessionSnapshot snapshot_of(const Session& session, const Datasets& datasets, std::int64_t now);

/// May run on any thread.
protocol::SessionFile file_of(const SessionSnapshot& snapshot);

/// Holds a session file whose records are sound.
struct ReadSession {
    StoredRecords records;
    std::vector<protocol::DatasetMark> datasets; ///< as the file names them
};

/// Reads JSON text; any thread. Error: InvalidArgument, OverLimit, Unsupported: the first record that is not
/// sound refuses the whole.
core::Result<ReadSession> read_session_text(std::string_view text);

/// Returns sentences about the datasets that are not here, or are other ones than the file's. Loop thread
/// only.
std::vector<std::string> dataset_notes(const ReadSession& read, const Datasets& datasets);

} // namespace wakesurf::server
