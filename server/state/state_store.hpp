// The records of all sessions in one SQLite file: read whole at the start, then changed by transactions, each of which is on
// the disk before it counts (write-ahead log, synchronous=FULL).
#pragma once

#include "server/state/database.hpp"
#include "server/state/pending_writes.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::server {

/// One thread at a time; everything here waits for the disk.
class StateStore {
  public:
    /// Layout of the file, kept in its user_version.
    static constexpr int version = 1;

    /// Makes the file where there is none. Error: Io; Corrupt; Unsupported for a file of a newer program or of another one, which
    /// is left as it is.
    static core::Result<StateStore> open(std::string file, const char* vfs = nullptr);

    /// The records of each session. Error: Io, Corrupt.
    core::Result<std::map<std::string, std::vector<JournalEntry>>> load();

    /// All of it or, with an error (Io, Corrupt), none. After an error the next call opens the file anew; deletions that are needless have
    /// been dropped from `changes` then. A change reported as failed may be found on the disk all the same.
    core::Result<void> apply(PendingWrites& changes);

  private:
    StateStore(std::string file, const char* vfs) : file_(std::move(file)), vfs_(vfs) {}

    core::Result<void> connect();
    core::Result<void> read_keys();
    core::Result<void> begin_log();
    void erase_session_keys(const std::string& session);
    core::Result<void> write(const PendingWrites& changes);

    std::string file_;
    const char* vfs_;
    std::optional<Database> database_; ///< nothing after a failure
    bool log_is_new_ = false;          ///< since the file was opened
    std::set<StoredKey> stored_;       ///< all that may be on the disk
};

} // namespace wakesurf::server
