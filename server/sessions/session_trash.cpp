#include "server/sessions/session_trash.hpp"

#include "protocol/api/utc_text.hpp"
#include "server/base/limits.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace wakesurf::server {

namespace {

/// Is the time between two readings of the wall clock, which may be set meanwhile.
constexpr std::chrono::hours trash_look{1};

} // namespace

std::int64_t deleted_until(const protocol::SessionProfile& profile) {
    return std::min(profile.deleted.value_or(0) + limits::trash_kept.count(),
                    protocol::last_utc_second);
}

SessionTrash::SessionTrash(Loop& loop,
                           UnixTime unix_time,
                           std::function<void(const TrashedSession&)> purged,
                           const core::MemoryAccount* account)
    : loop_(loop), unix_time_(std::move(unix_time)), purged_(std::move(purged)), account_(account) {
}

void SessionTrash::put(TrashedSession session) {
    if (account_ != nullptr) {
        std::size_t bytes = 0;
        for (const JournalEntry& each : session.entries)
            bytes += each.type.size() + each.id.size() + (each.record ? each.record->size() : 0);
        session.memory = account_->open(core::MemoryUse::Records);
        session.memory.set(bytes);
    }
    std::string id = session.id;
    sessions_[std::move(id)] = std::move(session);
    schedule();
}

const TrashedSession* SessionTrash::find(const std::string& id) const {
    const auto found = sessions_.find(id);
    return found == sessions_.end() ? nullptr : &found->second;
}

core::Result<TrashedSession> SessionTrash::take(const std::string& id) {
    auto node = sessions_.extract(id);
    if (!node)
        return core::fail(core::Error::Code::NotFound,
                          "there is no session `" + id.substr(0, 64) + "` in the trash",
                          "`trash` of `session.list` lists those that are");
    return std::move(node.mapped());
}

void SessionTrash::purge() {
    const std::int64_t now = unix_time_();
    std::set<std::string> over;
    for (const auto& [id, session] : sessions_)
        if (deleted_until(session.profile) <= now)
            over.insert(id);
    for (const std::string& id : std::exchange(over_, over))
        if (over_.erase(id) != 0)
            if (const auto gone = take(id))
                purged_(*gone);
    timer_.reset();
    schedule();
}

void SessionTrash::schedule() {
    if (timer_ || sessions_.empty())
        return;
    timer_ = loop_.after(trash_look, [this] { purge(); });
}

} // namespace wakesurf::server
