// session.rename, session.setUnits, session.delete, session.restore, session.export, session.import,
// session.thumbnail: what becomes of a session as a whole.
#include "core/base/plain_text.hpp"
#include "protocol/api/generated/session.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/base/limits.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/records_json.hpp"
#include "server/net/methods/session_import.hpp"
#include "server/sessions/records/thumbnail.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <utility>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void session_rename(const Call& call, const protocol::SessionRename& to, Reply reply) {
    const std::string name = core::display_name(to.name, limits::name_bytes);
    if (name.empty())
        return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                       "`name` must have a visible character",
                                       "give a name of at least one letter"});
    const auto session = choose_session(call, to.session);
    if (!session)
        return reply.fault(session.error());
    (*session)->rename(name);
    reply.result({{"session", (*session)->id()}, {"name", name}});
}

void session_set_units(const Call& call, const protocol::SessionSetUnits& to, Reply reply) {
    const auto session = choose_session(call, to.session);
    if (!session)
        return reply.fault(session.error());
    // Words that everyone gets to see, as names are.
    const protocol::SessionUnits units{core::display_name(to.length, limits::unit_bytes),
                                       core::display_name(to.time, limits::unit_bytes)};
    (*session)->set_units(units);
    reply.result(session_name_json({(*session)->id(), (*session)->name(), units}));
}

/// Ends links after the answer: a caller by a share link of the session loses the connection with it.
void after_answer(const Call& call, std::function<void()> end_links) {
    if (call.context.journal == nullptr)
        return end_links();
    call.context.journal->settled(
        [end_links = std::move(end_links)](const core::Result<void>&) { end_links(); });
}

/// Deletes a copy for the caller, who made it by a share link.
void delete_copy(const Call& call, const std::string& id, Reply reply) {
    const std::string& grant = call.identity.grant;
    if (!call.context.sessions.may_give_up(id, grant))
        return reply.fault(protocol::RpcFault{
            protocol::RpcCode::NotPermitted,
            "the copy has been edited, named or shared, or somebody else is in it",
            "ask someone with the server's token to delete it",
            {},
            {}});
    reply.result({{"session", id}});
    after_answer(call, [&sessions = call.context.sessions, id, grant] {
        if (sessions.may_give_up(id, grant))
            sessions.give_up(id);
    });
}

void session_delete(const Call& call, const protocol::SessionDelete& of, Reply reply) {
    const std::string& id = of.session;
    auto& sessions = call.context.sessions;
    if (role_in(id, call) < Role::Host)
        return delete_copy(call, id, std::move(reply));
    if (of.forever) {
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
    after_answer(call, [&context = call.context, id] {
        if (context.sessions.trash().find(id) != nullptr)
            context.grants.suspend(id);
    });
}

void session_restore(const Call& call, const protocol::SessionRestore& of, Reply reply) {
    const std::string& id = of.session;
    const auto session = call.context.sessions.bring_back(id);
    if (!session)
        return reply.fault(session.error());
    call.context.grants.resume(id);
    reply.result({{"session", id}, {"name", (*session)->name()}});
}

void session_export(const Call& call, const protocol::SessionExport& of, Reply reply) {
    const auto session = choose_session(call, of.session);
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

void session_import(const Call& call, const protocol::SessionImport& from, Reply reply) {
    const std::string name = core::display_name(from.name, limits::name_bytes);
    auto read = read_session_text(from.file);
    if (!read)
        return reply.fault(read.error());
    const auto made =
        import_session(call.context.sessions, call.context.datasets, std::move(*read), name);
    if (!made)
        return reply.fault(made.error());
    reply.result(*made);
}

void session_thumbnail(const Call& call, const protocol::SessionThumbnail& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    if (const auto sound = read_thumbnail(of.image); !sound)
        return reply.fault(sound.error());
    (*session)->set_thumbnail(of.image);
    reply.result(json::object());
}

} // namespace

std::vector<Method> session_keeping_methods() {
    return {method(session_rename),   method(session_set_units), method(session_delete),
            method(session_restore),  method(session_export),    method(session_import),
            method(session_thumbnail)};
}

} // namespace wakesurf::server
