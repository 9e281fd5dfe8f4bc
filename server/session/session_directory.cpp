#include "server/session/session_directory.hpp"

#include "server/limits.hpp"

#include <algorithm>

namespace wakesurf::server {

SessionDirectory::SessionDirectory(SessionServices services) : services_(services) {
    add("main", "main");
}

std::shared_ptr<Session> SessionDirectory::add(std::string id, std::string name) {
    auto session = std::make_shared<Session>(id, std::move(name), services_, next_surface_number_);
    sessions_[std::move(id)] = session;
    return session;
}

core::Result<std::shared_ptr<Session>> SessionDirectory::create(std::string name) {
    if (sessions_.size() >= limits::sessions && !make_room())
        return core::fail(core::Error::Code::OverLimit,
                          "the server has as many sessions as it may have, " +
                              std::to_string(limits::sessions),
                          "join one of them: session.list");
    std::string id = "session-" + std::to_string(next_session_++);
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
    const auto empty =
        std::find_if(created_.begin(), created_.end(), [this](const std::string& id) {
            return sessions_.at(id)->participants().present().empty();
        });
    if (empty == created_.end())
        return false;
    sessions_.erase(*empty);
    created_.erase(empty);
    return true;
}

void SessionDirectory::dataset_changed(const std::string& dataset) {
    for (const auto& [id, session] : sessions_)
        session->dataset_changed(dataset);
}

} // namespace wakesurf::server
