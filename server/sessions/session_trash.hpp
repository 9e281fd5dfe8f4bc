// Sessions that were deleted: for thirty days each can be restored as it was, then it is gone for good. What
// is kept of one is what the journal has of it, as text; nothing of it runs.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "protocol/api/record_text.hpp"
#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/base/unix_time.hpp"
#include "server/sessions/records/session_records.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::server {

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

} // namespace wakesurf::server
