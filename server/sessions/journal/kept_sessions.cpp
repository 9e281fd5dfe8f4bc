#include "server/sessions/journal/kept_sessions.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<KeptSessions> KeptSessions::open(const std::filesystem::path& path) {
    auto folder = StateFolder::hold(path);
    if (!folder)
        return tl::unexpected(folder.error());
    auto store = StateStore::open(folder->file());
    if (!store)
        return tl::unexpected(store.error());
    StateStore::Loaded found = store->take_loaded();
    KeptSessions out{std::move(*folder), std::move(*store), std::move(found.sessions), {}, {}};
    const auto sort = [&](std::vector<AsideRow>& rows, auto& into) {
        for (AsideRow& each : rows) {
            into[each.session].push_back(std::move(each.label));
            out.sessions.try_emplace(each.session);
        }
    };
    sort(found.aside, out.aside);
    sort(found.damaged, out.damaged);
    return out;
}

} // namespace wakesurf::server
