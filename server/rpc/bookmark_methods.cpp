// bookmark.set, bookmark.delete, bookmark.list.
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr RecordHandlers<protocol::BookmarkRecord> handlers{
    "bookmark", &Session::bookmark, protocol::bookmark_json, &Session::delete_bookmark};

void set(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto setting =
        protocol::read_bookmark_setting(in, {limits::name_bytes, limits::view_bytes});
    const std::string gesture = read_gesture(in);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = handlers.stale(**session, setting.bookmark, setting.if_rev))
        return reply.fault(*stale);
    const auto record = (*session)->set_bookmark(setting, author_of(call, **session, gesture));
    if (!record)
        return reply.fault(record.error());
    reply.result(
        {{"bookmark", record->bookmark}, {"rev", record->rev}, {"seq", (*session)->seq()}});
}

void remove(const Call& call, Reply reply) {
    handlers.remove(call, std::move(reply));
}

void list(const Call& call, Reply reply) {
    list_records(call, std::move(reply), "bookmarks", bookmarks_json);
}

} // namespace

std::vector<Method> bookmark_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter if_rev{"ifRev", R"({"type":"integer"})", false,
                           "refuse if the bookmark is at another revision"};
    return {
        {"bookmark.set",
         "Creates a bookmark, a view of the session with a name, or replaces one as a whole.",
         {session_parameter(),
          {"bookmark", text, false, "left out: create one"},
          {"name", text, false, "for people"},
          {"view", R"({"type":"object"})", true,
           fmt::format("camera, colours and the like, as the client likes; at most {} bytes of "
                       "JSON text",
                       limits::view_bytes)},
          {"time", R"({"type":"number"})", false, "the session's time the view belongs to"},
          gesture_parameter(),
          if_rev},
         "{bookmark, rev, seq}",
         any_editor,
         set},
        {"bookmark.delete",
         "Deletes a bookmark.",
         {session_parameter(),
          {"bookmark", text, true, "an id from bookmark.list"},
          gesture_parameter(),
          if_rev},
         "{seq}",
         any_editor,
         remove},
        {"bookmark.list",
         "The bookmarks of a session.",
         {session_parameter()},
         "{bookmarks}",
         any_viewer,
         list},
    };
}

} // namespace wakesurf::server
