// The records of all sessions in one SQLite file: read whole at the start, then changed by transactions,
// each of which is on the disk before it counts (write-ahead log, synchronous=FULL).
#pragma once

#include "server/service/journal/commit_mark.hpp"
#include "server/service/journal/database.hpp"
#include "server/service/journal/pending_writes.hpp"
#include "server/service/journal/state_folder.hpp"
#include "server/service/journal/state_opening.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Is used by one thread at a time; everything here waits for the disk.
class StateStore {
  public:
    /// Holds what a start found.
    struct Loaded {
        std::map<std::string, std::vector<JournalEntry>> sessions;
        std::vector<AsideRow> aside;   ///< kept aside by earlier starts
        std::vector<AsideRow> damaged; ///< kept aside since this one
    };

    /// Error: as open_state.
    static core::Result<StateStore> open(StateOptions options);

    static core::Result<StateStore> open(std::string file, const char* vfs = nullptr) {
        return open(StateOptions{std::move(file), vfs});
    }

    /// Returns what open() has read; once.
    Loaded take_loaded() { return std::move(loaded_); }

    /// All of it or, with an error (Io, Corrupt), none. After an error the next call opens the file again;
    /// deletions that are needless have been dropped from `changes` then. A change reported as failed may be
    /// found on the disk all the same.
    core::Result<void> apply(PendingWrites& changes);

    /// False once the file was deleted or replaced behind our back. The next apply() fails and says so, the
    /// one after it puts all there was in its place, where nothing else is there by then.
    bool in_place() const;

    /// Until release() the file alone, without its log, is all there is now, and it is not written to.
    /// Error: as apply().
    core::Result<void> hold();

    /// Returns whether the file was left alone all the time.
    bool release();

  private:
    explicit StateStore(StateOptions options)
        : options_(std::move(options)), mark_(options_.file + ".commits") {}

    /// Says which file it is, whatever its name.
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
    std::optional<Database> database_;  ///< nothing after a failure
    std::optional<StateFolder> folder_; ///< made in place of one that was deleted
    std::optional<Identity> identity_;  ///< of the file that is open; nothing where it has none
    std::optional<Identity> log_identity_;
    bool lost_ = false;       ///< it has been told that the file is not in its place
    bool log_is_new_ = false; ///< since the file was opened
    bool held_ = false;
    Loaded loaded_;
    StateHead head_;
    std::map<StoredKey, std::uint64_t> stored_; ///< digests of all that may be on the disk
    std::map<StoredKey, std::uint64_t> going_;  ///< erased by the transaction under way
    std::map<std::string, RowSum> sums_;        ///< of them; of all under an empty name
};

} // namespace wakesurf::server
