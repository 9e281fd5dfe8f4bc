// session.rename, session.delete, session.restore, session.export, session.import, session.thumbnail: what becomes of a session
// as a whole.
#include "protocol/api/checked_json.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/rpc/session_import.hpp"
#include "server/session/people/display_name.hpp"
#include "server/session/records/thumbnail.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void rename(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string name = display_name(in.text("name", limits::name_bytes), limits::name_bytes);
    if (name.empty())
        in.fault("name", "must have something in it that can be seen");
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    (*session)->rename(name);
    reply.result({{"session", (*session)->id()}, {"name", name}});
}

/// The answer first: whoever called by a share link of this session loses the connection with it.
void suspend_links(const Call& call, const std::string& session) {
    const auto suspend = [&context = call.context, session] {
        if (context.sessions.trash().find(session) != nullptr)
            context.grants.suspend(session);
    };
    if (call.context.journal == nullptr)
        return suspend();
    call.context.journal->settled([suspend](const core::Result<void>&) { suspend(); });
}

void remove(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("session");
    const bool forever = in.flag_or("forever", false);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    auto& sessions = call.context.sessions;
    if (forever) {
        if (sessions.trash().find(id) == nullptr && sessions.find(id))
            return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                           "`forever` is for a session in the trash",
                                           "delete it without `forever` first"});
        if (const auto gone = sessions.erase(id); !gone)
            return reply.fault(gone.error());
        return reply.result({{"session", id}});
    }
    const auto until = sessions.remove(id);
    if (!until)
        return reply.fault(until.error());
    reply.result({{"session", id}, {"deletedUntil", protocol::utc_text(*until)}});
    suspend_links(call, id);
}

void restore(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("session");
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.bring_back(id);
    if (!session)
        return reply.fault(session.error());
    call.context.grants.resume(id);
    reply.result({{"session", id}, {"name", (*session)->name()}});
}

void export_session(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if ((*session)->records().bytes() > limits::session_message_bytes)
        return reply.fault(
            core::Error{core::Error::Code::OverLimit,
                        "the session is too large for a message",
                        "get it from /api/v1/sessions/" + (*session)->id() + "/session.json",
                        {},
                        limits::session_message_bytes});
    const auto snapshot =
        snapshot_of(**session, call.context.datasets, call.context.sessions.unix_time());
    reply.result({{"file", protocol::session_file_json(file_of(snapshot))}});
}

void import(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string file = in.object_text("file", limits::message_bytes);
    const std::string name =
        display_name(in.text_or("name", {}, limits::name_bytes), limits::name_bytes);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    auto read = read_session_text(file);
    if (!read)
        return reply.fault(read.error());
    const auto made =
        import_session(call.context.sessions, call.context.datasets, std::move(*read), name);
    if (!made)
        return reply.fault(made.error());
    reply.result(*made);
}

void thumbnail(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string image = in.text("image", limits::message_bytes);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto sound = read_thumbnail(image); !sound)
        return reply.fault(sound.error());
    (*session)->set_thumbnail(image);
    reply.result(json::object());
}

} // namespace

std::vector<Method> session_keeping_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter session{"session", text, true, "an id from session.list"};
    const std::string days = std::to_string(limits::trash_kept.count() / (24 * 3600));
    return {
        {"session.rename",
         "Gives a session another name; everyone in it is told.",
         {session_parameter(), {"name", text, true, "for people"}},
         "{session, name}",
         any_host,
         rename},
        {"session.delete",
         "Moves a session to the trash, from where session.restore brings it back for " + days +
             " days; its people are told, its share links let no one in meanwhile. `main` cannot "
             "be deleted.",
         {session,
          {"forever", R"({"type":"boolean"})", false,
           "true: removes a session that is in the trash for good"}},
         "{session, deletedUntil?}",
         any_host,
         remove},
        {"session.restore",
         "Brings a session back from the trash as it was, with its share links.",
         {session},
         "{session, name}",
         server_editor,
         restore},
        {"session.export",
         "A session as one document: its records, and the names and fingerprints of their "
         "datasets. A large one is "
         "refused here: GET /api/v1/sessions/SESSION/session.json answers with any.",
         {session_parameter()},
         "{file}",
         any_viewer,
         export_session},
        {"session.import",
         "Makes a new session of such a document. Notes say which datasets are not here, or are "
         "other ones. POST "
         "/api/v1/sessions takes larger documents than a message may be.",
         {{"file", R"({"type":"object"})", true, "what session.export answered"},
          {"name", text, false, "left out: the document's"}},
         "{session, name, remaining, notes}",
         server_editor,
         import},
        {"session.thumbnail",
         "Keeps a small picture of the session for lists: the newest one sent. GET "
         "/api/v1/sessions/SESSION/thumbnail answers with it.",
         {session_parameter(),
          {"image", text, true,
           fmt::format("base64 of a PNG, JPEG or WebP picture of at most {} bytes",
                       limits::thumbnail_bytes)}},
         "{}",
         any_editor,
         thumbnail},
    };
}

} // namespace wakesurf::server
