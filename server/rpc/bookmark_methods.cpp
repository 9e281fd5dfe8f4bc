// bookmark.set, bookmark.delete, bookmark.list.
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

constexpr RecordHandlers<protocol::BookmarkRecord> bookmark_handlers{
    "bookmark", &Session::bookmark, protocol::bookmark_json, &Session::delete_bookmark};

void bookmark_set(const Call& call, const protocol::BookmarkSetting& setting, Reply reply) {
    const auto session = choose_session(call, setting.session);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = bookmark_handlers.stale(**session, setting.bookmark, setting.if_rev))
        return reply.fault(*stale);
    const auto record =
        (*session)->set_bookmark(setting, author_of(call, **session, setting.gesture));
    if (!record)
        return reply.fault(record.error());
    reply.result(
        {{"bookmark", record->bookmark}, {"rev", record->rev}, {"seq", (*session)->seq()}});
}

void bookmark_delete(const Call& call, const protocol::BookmarkDelete& of, Reply reply) {
    bookmark_handlers.remove(call, of, of.bookmark, std::move(reply));
}

void bookmark_list(const Call& call, const protocol::BookmarkList& of, Reply reply) {
    list_records(call, of.session, std::move(reply), "bookmarks", bookmarks_json);
}

} // namespace

std::vector<Method> bookmark_methods() {
    return {method(bookmark_set), method(bookmark_delete), method(bookmark_list)};
}

} // namespace wakesurf::server
