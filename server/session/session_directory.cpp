#include "server/session/session_directory.hpp"

#include "server/limits.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace wakesurf::server {

namespace {

constexpr std::string_view id_start = "session-";

/// Of an id that add_new gives, else 0.
std::size_t number_of(std::string_view id) {
    std::size_t number = 0;
    if (id.starts_with(id_start))
        std::from_chars(id.data() + id_start.size(), id.data() + id.size(), number);
    return number;
}

} // namespace

SessionDirectory::SessionDirectory(SessionServices services)
    : turns_(services.loop, limits::restoring),
      histories_(limits::histories_bytes, limits::history_bytes), services_(std::move(services)) {
    services_.turns = &turns_;
    services_.histories = &histories_;
    add("main", "main");
}

std::shared_ptr<Session> SessionDirectory::add(std::string id, std::string name) {
    auto session = std::make_shared<Session>(id, std::move(name), services_, next_surface_number_);
    sessions_[std::move(id)] = session;
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::create(std::string name) {
    auto session = add_new(std::move(name));
    if (session)
        (*session)->keep();
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::fork(const std::string& id,
                                                              std::string name) {
    const auto from = find(id); // held, lest it make room for its own fork
    if (!from)
        return from;
    auto session = add_new(name.empty() ? (*from)->name() : std::move(name));
    if (session)
        (*session)->copy(**from);
    return session;
}

RestoreReport SessionDirectory::restore(const std::string& id,
                                        std::string name,
                                        std::span<const JournalEntry> entries) {
    auto& session = sessions_[id];
    if (!session) {
        session = std::make_shared<Session>(id, std::move(name), services_, next_surface_number_);
        created_.push_back(id);
        next_session_ = std::max(next_session_, number_of(id) + 1);
    }
    return session->restore(entries);
}

core::Result<std::shared_ptr<Session>> SessionDirectory::add_new(std::string name) {
    if (sessions_.size() >= limits::sessions && !make_room())
        return core::over_limit(limits::sessions,
                                "the server has as many sessions as it may have, " +
                                    std::to_string(limits::sessions),
                                "join one of them: session.list");
    std::string id = std::string(id_start) + std::to_string(next_session_++);
    if (name.empty())
        name = id;
    created_.push_back(id);
    return add(std::move(id), std::move(name));
}

core::Result<std::shared_ptr<Session>> SessionDirectory::find(const std::string& id) const {
    const auto found = sessions_.find(id);
    if (found == sessions_.end())
        return core::fail(core::Error::Code::NotFound,
                          "there is no session `" + id.substr(0, 64) + "`",
                          "create one with session.create, or use `main`");
    return found->second;
}

/// Every visit of the page without a session's address makes one; most are left for good.
bool SessionDirectory::make_room() {
    const auto alone = [this](const std::string& id) {
        return sessions_.at(id)->participants().present().empty();
    };
    const auto unused = [&](const std::string& id) {
        return alone(id) && sessions_.at(id)->records().empty();
    };
    auto going = std::find_if(created_.begin(), created_.end(), unused);
    if (going == created_.end())
        going = std::find_if(created_.begin(), created_.end(), alone);
    if (going == created_.end())
        return false;
    const std::string id = *going;
    if (removed_)
        removed_(id);
    if (services_.journal != nullptr)
        services_.journal->remove(id);
    sessions_.erase(id);
    created_.erase(going);
    return true;
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
