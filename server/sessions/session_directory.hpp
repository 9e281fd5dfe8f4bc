// All sessions of the server, and those in the trash. One, `main`, is there from the start, so that a page
// and a script meet without arranging anything. The server deletes no work: where there are too many
// sessions it refuses to make more.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "protocol/api/record_text.hpp"
#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/base/unix_time.hpp"
#include "server/live/compute/history_budget.hpp"
#include "server/live/memory_reclaim.hpp"
#include "server/sessions/records/session_records.hpp"
#include "server/sessions/session.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Sessions that were deleted: for thirty days each can be restored as it was, then it is gone for good. What
/// is kept of one is what the journal has of it, as text; nothing of it runs.
struct TrashedSession {
    std::string id;
    std::string name;
    protocol::SessionProfile profile;
    std::array<std::size_t, record_types.size()> records{}; ///< how many of each type
    bool thumbnail = false;
    std::vector<JournalEntry> entries;      ///< all of it but its share links
    core::MemoryAccount::Share memory = {}; ///< of those
};

/// Returns the second since 1970 at which it will be gone for good.
std::int64_t deleted_until(const protocol::SessionProfile& profile);

/// Loop thread only. By the wall clock, so that thirty days are thirty days across restarts. As that can be
/// wrong for a while, as after a start, nothing goes before it has been over for two looks, an hour apart.
class SessionTrash {
  public:
    /// `purged` is told of each session whose time is over, after it has left the trash.
    /// @param account  may be null
    SessionTrash(Loop& loop,
                 UnixTime unix_time,
                 std::function<void(const TrashedSession&)> purged,
                 const core::MemoryAccount* account = nullptr);
    SessionTrash(const SessionTrash&) = delete;
    SessionTrash& operator=(const SessionTrash&) = delete;

    /// REQUIRES: the profile says since when it is deleted.
    void put(TrashedSession session);

    /// Returns null where there is none.
    const TrashedSession* find(const std::string& id) const;

    /// Takes a session out of the trash. Error: NotFound.
    core::Result<TrashedSession> take(const std::string& id);

    const std::map<std::string, TrashedSession>& all() const { return sessions_; }

  private:
    void purge();
    void schedule();

    Loop& loop_;
    UnixTime unix_time_;
    std::function<void(const TrashedSession&)> purged_;
    const core::MemoryAccount* account_;
    std::map<std::string, TrashedSession> sessions_;
    std::set<std::string> over_; ///< at the last look
    std::shared_ptr<void> timer_;
};

/// Loop thread only.
class SessionDirectory {
  public:
    explicit SessionDirectory(SessionServices services);

    /// Makes a session. Where there are too many, the one that has been unused for longest goes, of those
    /// that were never edited, named or shared and are empty. Error: OverLimit when there is none of those.
    core::Result<std::shared_ptr<Session>> create(std::string name);

    /// Makes a session with the records of another, at the time that this one shows. Error: NotFound,
    /// OverLimit.
    /// @param on_purpose  false: it may go once it is not needed, like one that was never edited
    /// @param copier  as of a Session. Its copies that hold no work make room
    core::Result<std::shared_ptr<Session>> fork(const std::string& id,
                                                std::string name,
                                                bool on_purpose = true,
                                                const std::string& copier = {});

    /// Gives up the one of these sessions that has been unused for longest, of those that were never edited,
    /// named or shared and are empty. False: all of them hold work.
    bool give_up_one(std::span<const std::string> ids);

    /// Returns whether it was never edited, named or shared, and all its participants came by that link: it
    /// holds no work.
    bool may_give_up(const std::string& id, const std::string& grant) const;

    /// Deletes it for good, past the trash; its participants are disconnected from it. REQUIRES: find(id),
    /// and that it is not main.
    void give_up(const std::string& id);

    /// Makes a session of records that have been checked. Error: OverLimit.
    core::Result<std::shared_ptr<Session>> import(StoredRecords records, std::string name);

    /// Brings a session back from what the journal kept of it, into the trash if it was there. Before any
    /// client is served.
    RestoreReport
    restore(const std::string& id, std::string name, std::span<const JournalEntry> entries);

    /// Error: NotFound.
    core::Result<std::shared_ptr<Session>> find(const std::string& id) const;

    /// Returns how many more can be made, those counted that would go for them.
    std::size_t remaining() const;

    /// Moves a session to the trash; its people are sent away. Returns the second since 1970 until which it
    /// can be brought back. Error: NotFound, InvalidArgument (main), OverLimit (full trash).
    core::Result<std::int64_t> remove(const std::string& id);

    /// Takes it out of the trash, as it was. Error: NotFound, OverLimit.
    core::Result<std::shared_ptr<Session>> bring_back(const std::string& id);

    /// Deletes it from the trash for good. Error: NotFound.
    core::Result<void> erase(const std::string& id);

    /// Returns the seconds since 1970.
    std::int64_t unix_time() const { return services_.unix_time(); }

    const SessionTrash& trash() const { return trash_; }

    /// Tells every session that more time-steps of a dataset can be read, or that it was opened again.
    void dataset_changed(const std::string& dataset);

    /// Writes the times of clocks that run into the journal: the server is ending.
    void keep_times() const;

    /// Sets what is called with the id of a session that is gone for good.
    void on_gone(std::function<void(const std::string&)> tell) { gone_ = std::move(tell); }

    const std::map<std::string, std::shared_ptr<Session>>& all() const { return sessions_; }

    /// Returns the surfaces of all sessions.
    std::vector<std::shared_ptr<LiveSurface>> surfaces() const;

  private:
    std::shared_ptr<Session> add(std::string id, std::string name, std::string copier = {});
    core::Result<void> room_for(const SessionRecords& records, const std::string& copier = {});
    std::vector<std::string> copies_by(const std::string& link) const;
    core::Result<void> make_room();
    core::Result<std::shared_ptr<Session>> add_new(std::string name,
                                                   const std::string& copier = {});
    void forget(const std::string& id);

    HistoryBudget histories_;
    SessionServices services_;
    std::optional<MemoryReclaim> giving_back_;
    std::uint32_t next_surface_number_ = 1;
    std::size_t next_session_ = 1;
    std::map<std::string, std::shared_ptr<Session>> sessions_;
    SessionTrash trash_;
    std::function<void(const std::string&)> gone_;
};

} // namespace wakesurf::server
