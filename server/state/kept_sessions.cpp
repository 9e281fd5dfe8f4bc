#include "server/state/kept_sessions.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<KeptSessions> KeptSessions::open(const std::filesystem::path& path) {
    auto folder = StateFolder::hold(path);
    if (!folder)
        return tl::unexpected(folder.error());
    auto store = StateStore::open(folder->file());
    if (!store)
        return tl::unexpected(store.error());
    auto sessions = store->load();
    if (!sessions)
        return tl::unexpected(sessions.error());
    return KeptSessions{std::move(*folder), std::move(*store), std::move(*sessions)};
}

} // namespace wakesurf::server
