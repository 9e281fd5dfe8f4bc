#include "server/sessions/session_directory.hpp"

#include "protocol/api/utc_text.hpp"
#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"
#include "server/base/numbered_id.hpp"
#include "server/sessions/records/record_room.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <string_view>
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
                          "`trash` of `session.list` lists the deleted sessions");
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

using core::Error;
using core::fail;

namespace {

constexpr std::string_view id_start = "session-";
constexpr std::string_view main_id = "main";

void log_event(const char* event, const std::string& id) {
    spdlog::info("event={} session={}", event, log_value(id));
}

/// Returns whether it holds no work: only the page's default scene is in it, or nothing.
bool is_unused(const Session& session) {
    return session.id() != main_id && !session.profile().edited && !session.profile().on_purpose;
}

bool may_go(const Session& session) {
    return is_unused(session) && session.participants().present().empty();
}

bool in_trash(std::span<const JournalEntry> entries) {
    return std::any_of(entries.begin(), entries.end(), [](const JournalEntry& each) {
        if (each.type != "profile" || !each.record)
            return false;
        const auto profile = protocol::parse_profile(*each.record);
        return profile && profile->deleted;
    });
}

/// Returns the link of the maker of a copy by a link that is still kept; else empty.
std::string copier_of(std::span<const JournalEntry> entries) {
    for (const JournalEntry& each : entries)
        if (each.type == "grant" && each.record)
            if (const auto grant = protocol::parse_grant(*each.record);
                grant && !grant->copier.empty())
                return grant->copier;
    return {};
}

TrashedSession trashed(const std::string& id,
                       std::string name,
                       protocol::SessionProfile profile,
                       const SessionRecords& records,
                       bool thumbnail) {
    TrashedSession out{id, std::move(name), std::move(profile), {}, thumbnail, {}};
    for (const RecordType type : record_types)
        out.records[static_cast<std::size_t>(type)] = records.count(type);
    return out;
}

/// Takes at most one `nth` of all memory.
std::size_t part_of(const core::MemoryAccount* account, std::size_t nth, std::size_t most) {
    return account == nullptr ? most : std::min(most, account->budget() / nth);
}

} // namespace

SessionDirectory::SessionDirectory(SessionServices services)
    : histories_(part_of(services.memory, 4, limits::histories_bytes),
                 part_of(services.memory, 16, limits::history_bytes),
                 services.memory),
      services_(std::move(services)), trash_(
                                          services_.loop,
                                          services_.unix_time,
                                          [this](const TrashedSession& gone) {
                                              log_event("session_purged", gone.id);
                                              forget(gone.id);
                                          },
                                          services_.memory) {
    services_.histories = &histories_;
    services_.records_of_copies = [this](const std::string& link) {
        std::size_t bytes = 0;
        for (const std::string& id : copies_by(link))
            bytes += sessions_.at(id)->records().bytes();
        return bytes;
    };
    if (services_.memory != nullptr)
        giving_back_.emplace(services_.loop, *services_.memory, [this] { return surfaces(); });
    add(std::string(main_id), std::string(main_id));
}

std::shared_ptr<Session>
SessionDirectory::add(std::string id, std::string name, std::string copier) {
    auto session = std::make_shared<Session>(id, std::move(name), services_, next_surface_number_,
                                             std::move(copier));
    sessions_[std::move(id)] = session;
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::create(std::string name) {
    const bool named = !name.empty();
    auto session = add_new(std::move(name));
    if (!session)
        return session;
    if (named)
        (*session)->made_on_purpose();
    (*session)->keep();
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::fork(const std::string& id,
                                                              std::string name,
                                                              bool on_purpose,
                                                              const std::string& copier) {
    const auto from = find(id); // held, lest it make room for its own fork
    if (!from)
        return from;
    auto room = room_for((*from)->records(), copier);
    while (!room && give_up_one(copies_by(copier)))
        room = room_for((*from)->records(), copier);
    if (!room)
        return tl::unexpected(room.error());
    auto session = add_new(name.empty() ? (*from)->name() : std::move(name), copier);
    if (session)
        (*session)->copy(**from, on_purpose);
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::import(StoredRecords records,
                                                                std::string name) {
    if (auto room = room_for(records.records); !room)
        return tl::unexpected(room.error());
    auto session = add_new(name.empty() ? records.name : std::move(name));
    if (session)
        (*session)->take_over(std::move(records));
    return session;
}

RestoreReport SessionDirectory::restore(const std::string& id,
                                        std::string name,
                                        std::span<const JournalEntry> entries) {
    next_session_ = std::max(next_session_, number_of(id, id_start).value_or(0) + 1);
    if (in_trash(entries)) {
        StoredRecords kept = read_entries(entries);
        TrashedSession session = trashed(id, kept.name.empty() ? id : kept.name, *kept.profile,
                                         kept.records, !kept.thumbnail.empty());
        for (const JournalEntry& each : entries)
            if (each.type != "grant")
                session.entries.push_back(each);
        trash_.put(std::move(session));
        return std::move(kept.report);
    }
    auto& session = sessions_[id];
    if (!session)
        session = std::make_shared<Session>(id, std::move(name), services_, next_surface_number_,
                                            copier_of(entries));
    return session->restore(entries);
}

core::Result<void> SessionDirectory::room_for(const SessionRecords& records,
                                              const std::string& copier) {
    const std::size_t bytes = records.bytes();
    if (copier.empty())
        return room_beside_others(services_.memory, bytes, bytes);
    if (auto room = room_in_session(bytes + services_.records_of_copies(copier), RoomOf::Copies);
        !room)
        return room;
    return room_beside_others(services_.memory, bytes, bytes, RoomOf::Copies);
}

std::vector<std::string> SessionDirectory::copies_by(const std::string& link) const {
    std::vector<std::string> ids;
    for (const auto& [id, session] : sessions_)
        if (!link.empty() && session->copier() == link)
            ids.push_back(id);
    return ids;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::add_new(std::string name,
                                                                 const std::string& copier) {
    if (auto room = make_room(); !room)
        return tl::unexpected(room.error());
    std::string id = std::string(id_start) + std::to_string(next_session_++);
    if (name.empty())
        name = id;
    log_event("session_created", id);
    return add(std::move(id), std::move(name), copier);
}

core::Result<std::shared_ptr<Session>> SessionDirectory::find(const std::string& id) const {
    if (const auto found = sessions_.find(id); found != sessions_.end())
        return found->second;
    if (const TrashedSession* deleted = trash_.find(id))
        return fail(Error::Code::NotFound, "the session `" + id + "` is in the trash",
                    "`session.restore` brings it back until " +
                        protocol::utc_text(deleted_until(deleted->profile)));
    return fail(Error::Code::NotFound, "there is no session `" + id.substr(0, 64) + "`",
                "`session.list` lists them");
}

std::size_t SessionDirectory::remaining() const {
    const auto going = static_cast<std::size_t>(std::count_if(
        sessions_.begin(), sessions_.end(), [](const auto& each) { return may_go(*each.second); }));
    return limits::kept_sessions - std::min(limits::kept_sessions, sessions_.size() - going);
}

core::Result<void> SessionDirectory::make_room() {
    if (sessions_.size() < limits::kept_sessions)
        return {};
    std::vector<std::string> ids;
    for (const auto& [id, session] : sessions_)
        ids.push_back(id);
    if (!give_up_one(ids))
        return core::over_limit(limits::kept_sessions,
                                "the server keeps at most " +
                                    std::to_string(limits::kept_sessions) +
                                    " sessions, and that many are there",
                                "delete one that is no longer needed with `session.delete`; "
                                "`session.export` saves it first");
    return {};
}

bool SessionDirectory::give_up_one(std::span<const std::string> ids) {
    const Session* going = nullptr;
    for (const std::string& each : ids) {
        const auto found = sessions_.find(each);
        if (found == sessions_.end() || !may_go(*found->second))
            continue;
        const Session& session = *found->second;
        if (going == nullptr || session.profile().last_used < going->profile().last_used)
            going = &session;
    }
    if (going == nullptr)
        return false;
    const std::string id = going->id();
    log_event("session_never_used_given_up", id);
    sessions_.erase(id);
    forget(id);
    return true;
}

bool SessionDirectory::may_give_up(const std::string& id, const std::string& grant) const {
    const auto found = sessions_.find(id);
    return found != sessions_.end() && is_unused(*found->second) &&
           std::ranges::all_of(found->second->participants().present(),
                               [&](const Participant& each) { return each.grant == grant; });
}

void SessionDirectory::give_up(const std::string& id) {
    log_event("session_given_up", id);
    sessions_.at(id)->end();
    sessions_.erase(id);
    forget(id);
}

core::Result<std::int64_t> SessionDirectory::remove(const std::string& id) {
    const auto found = find(id);
    if (!found)
        return tl::unexpected(found.error());
    if (id == main_id)
        return fail(Error::Code::InvalidArgument,
                    "`main` is the session that everyone shares and cannot be deleted",
                    "delete its rakes (which deletes their surfaces), bookmarks and notes instead");
    if (trash_.all().size() >= limits::trash)
        return core::over_limit(limits::trash,
                                "the trash keeps at most " + std::to_string(limits::trash) +
                                    " sessions, and that many are there",
                                "delete some permanently: `forever` of `session.delete`");
    Session& session = **found;
    session.delete_at(services_.unix_time());
    TrashedSession deleted = trashed(id, session.name(), session.profile(), session.records(),
                                     !session.thumbnail().empty());
    deleted.entries = session.entries();
    trash_.put(std::move(deleted));
    log_event("session_deleted", id);
    session.end();
    sessions_.erase(id);
    return deleted_until(trash_.find(id)->profile);
}

core::Result<std::shared_ptr<Session>> SessionDirectory::bring_back(const std::string& id) {
    if (trash_.find(id) != nullptr)
        if (auto room = make_room(); !room)
            return tl::unexpected(room.error());
    const auto kept = trash_.take(id);
    if (!kept)
        return tl::unexpected(kept.error());
    auto session = add(id, kept->name);
    session->restore(kept->entries);
    session->delete_at(std::nullopt);
    log_event("session_restored", id);
    return session;
}

core::Result<void> SessionDirectory::erase(const std::string& id) {
    if (const auto gone = trash_.take(id); !gone)
        return tl::unexpected(gone.error());
    log_event("session_erased", id);
    forget(id);
    return {};
}

/// Ends its links before the journal forgets it: they strike themselves from there.
void SessionDirectory::forget(const std::string& id) {
    if (gone_)
        gone_(id);
    if (services_.journal != nullptr)
        services_.journal->remove(id);
}

std::vector<std::shared_ptr<LiveSurface>> SessionDirectory::surfaces() const {
    std::vector<std::shared_ptr<LiveSurface>> all;
    for (const auto& [id, session] : sessions_)
        session->builds().for_each(
            [&](LiveSurface& each) { all.push_back(each.shared_from_this()); });
    return all;
}

void SessionDirectory::keep_times() const {
    for (const auto& [id, session] : sessions_)
        session->keep_time();
}

void SessionDirectory::dataset_changed(const std::string& dataset) {
    for (const auto& [id, session] : sessions_)
        session->dataset_changed(dataset);
}

} // namespace wakesurf::server
