// session.create, session.list, session.join, session.leave, session.state.
#include "protocol/checked_json.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/records_json.hpp"
#include "server/rpc/session_choice.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json participants_json(Session& session) {
    json list = json::array();
    for (const Participant& each : session.participants().present())
        list.push_back({{"participant", each.id}, {"name", each.name}});
    return list;
}

void create(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string name = in.text_or("name", {}, limits::name_bytes);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.create(name);
    if (!session)
        return reply.fault(session.error());
    reply.result({{"session", (*session)->id()}});
}

void list(const Call& call, Reply reply) {
    json out = json::array();
    for (const auto& [id, session] : call.context.sessions.all()) {
        if (!call.identity.session.empty() && id != call.identity.session)
            continue;
        out.push_back({{"session", id},
                       {"name", session->name()},
                       {"participants", session->participants().present().size()},
                       {"surfaces", session->surfaces().size()}});
    }
    reply.result({{"sessions", std::move(out)}});
}

void join(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("session");
    const std::string name = in.text_or("name", {}, limits::name_bytes);
    const std::string resume_token = in.text_or("resumeToken", {});
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.find(id);
    if (!session)
        return reply.fault(session.error());
    const auto you = call.client->join(*session, name, resume_token);
    if (!you)
        return reply.fault(you.error());
    reply.result({{"snapshot", records_json(**session)},
                  {"seq", (*session)->seq()},
                  {"participants", participants_json(**session)},
                  {"you", you->id},
                  {"resumeToken", you->resume_token}});
}

void state(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    json out = records_json(**session);
    out["seq"] = (*session)->seq();
    out["participants"] = participants_json(**session);
    reply.result(out);
}

} // namespace

std::vector<Method> session_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter name{"name", text, false, "for people"};
    return {
        {"session.create",
         "Makes a new, empty session.",
         {name},
         "{session}",
         server_editor,
         create},
        {"session.list",
         "The sessions of this server; with a share link, its own.",
         {},
         "{sessions: [{session, name, participants, surfaces}]}",
         any_viewer,
         list},
        {"session.join",
         "Enters a session: its changes are told to this WebSocket from now on.",
         {{"session", text, true, "an id from session.list or session.create"},
          name,
          {"resumeToken", text, false, "of an earlier stay, to take up its place again"}},
         "{snapshot: {session, name, rakes, surfaces, bookmarks, annotations}, seq, participants, "
         "you, resumeToken}",
         websocket_viewer,
         join},
        {"session.leave",
         "Leaves the session joined; its changes are not told any more.",
         {},
         "{}",
         websocket_viewer,
         [](const Call& call, Reply reply) {
             call.client->leave();
             reply.result(json::object());
         }},
        {"session.state",
         "Every record of a session.",
         {session_parameter()},
         "{session, name, seq, rakes, surfaces, bookmarks, annotations, participants}",
         any_viewer,
         state},
    };
}

} // namespace wakesurf::server
