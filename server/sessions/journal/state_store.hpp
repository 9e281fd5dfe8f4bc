// The records of all sessions in one SQLite file: read whole at the start, then changed by transactions, each
// of which is on the disk before it counts (write-ahead log, synchronous=FULL).
#pragma once

#include "server/sessions/journal/commit_mark.hpp"
#include "server/sessions/journal/database.hpp"
#include "server/sessions/journal/pending_writes.hpp"
#include "server/sessions/journal/state_folder.hpp"
#include "server/sessions/journal/state_opening.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Stores records. One thread at a time; every call waits for the disk.
class StateStore {
  public:
    /// Holds the findings of a start.
    struct Loaded {
        std::map<std::string, std::vector<JournalEntry>> sessions;
        std::vector<AsideRow> aside;   ///< kept aside by earlier starts
        std::vector<AsideRow> damaged; ///< set aside since this start
    };

    /// Opens the file. Error: as open_state.
    static core::Result<StateStore> open(StateOptions options);

    static core::Result<StateStore> open(std::string file, const char* vfs = nullptr) {
        return open(StateOptions{std::move(file), vfs});
    }

    /// Returns what open() has read; once.
    Loaded take_loaded() { return std::move(loaded_); }

    /// Applies all changes or, with an error (Io, Corrupt), none. After an error the next call opens the file
    /// again; needless deletions have been dropped from `changes` then. A change reported as failed may still
    /// be found on the disk.
    core::Result<void> apply(PendingWrites& changes);

    /// Returns false once the file was deleted or replaced. The next apply() fails with that error; the one
    /// after it writes everything to its place, if that is free.
    bool in_place() const;

    /// Keeps the file unchanged until release(): alone, without its log, it has everything. Error: as
    /// apply().
    core::Result<void> hold();

    /// Returns whether the file was unchanged all the time.
    bool release();

  private:
    explicit StateStore(StateOptions options)
        : options_(std::move(options)), mark_(options_.file + ".commits") {}

    /// Identifies a file, whatever its name.
    struct Identity {
        std::uint64_t device = 0;
        std::uint64_t inode = 0;

        bool operator==(const Identity&) const = default;
    };

    static std::optional<Identity> identity_of(const std::string& file);

    core::Result<Loaded> connect();
    core::Result<void> put_back();
    core::Result<void> begin_log();
    core::Result<void> write(const PendingWrites& changes);
    core::Result<void> forget(const std::string& session);
    core::Result<void> move_aside(const StoredKey& key, const KeptAside& label);
    core::Result<void> change(const StoredKey& key, const std::optional<std::string>& json);
    core::Result<void> write_sums(const std::set<std::string>& sessions);
    void count(const StoredKey& key, std::optional<std::uint64_t> digest);

    StateOptions options_;
    CommitMark mark_;
    /// Empty after a failure.
    std::optional<Database> database_;
    std::optional<StateFolder> folder_; ///< made in place of one that was deleted
    /// The open file's identity; empty if it has none.
    std::optional<Identity> identity_;
    std::optional<Identity> log_identity_;
    bool lost_ = false;       ///< a caller has been told that the file is not in its place
    bool log_is_new_ = false; ///< since the file was opened
    bool held_ = false;
    Loaded loaded_;
    StateHead head_;
    std::map<StoredKey, std::uint64_t> stored_; ///< digests of all that may be on the disk
    std::map<StoredKey, std::uint64_t> going_;  ///< erased by the pending transaction
    std::map<std::string, RowSum> sums_;        ///< of them; of all under an empty name
};

/// The sessions that an earlier server has left in the folder of `--state`.
struct StoredSessions {
    StateFolder folder;
    StateStore store;
    /// All sessions, also those without a usable record.
    std::map<std::string, std::vector<JournalEntry>> sessions;
    std::map<std::string, std::vector<KeptAside>> aside;   ///< by earlier starts
    std::map<std::string, std::vector<KeptAside>> damaged; ///< since this start

    /// Opens the folder; waits for the disk. Error: as StateFolder::hold and StateStore::open.
    static core::Result<StoredSessions> open(const std::filesystem::path& folder);
};

} // namespace wakesurf::server
