// session.create, session.fork, session.list, session.join, session.leave, session.state.
#include "protocol/checked_json.hpp"
#include "server/limits.hpp"
#include "server/rpc/durability_notice.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/patch_json.hpp"
#include "server/rpc/records_json.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/session/colours.hpp"
#include "server/session/display_name.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json participants_json(Session& session) {
    json list = json::array();
    for (const auto& each : session.participants().shown())
        list.push_back(protocol::participant_json(each, protocol::member::person |
                                                            protocol::said(each.presence)));
    return list;
}

void create(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string name = in.text_or("name", {}, limits::name_bytes);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.create(display_name(name, limits::name_bytes));
    if (!session)
        return reply.fault(session.error());
    reply.result({{"session", (*session)->id()}});
}

/// For the server's own token only: whoever came by a share link could not enter the copy.
void fork(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string name = in.text_or("name", {}, limits::name_bytes);
    const auto from = read_session(in, call);
    if (!from)
        return reply.fault(from.error());
    const auto session =
        call.context.sessions.fork((*from)->id(), display_name(name, limits::name_bytes));
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
    Arrival arrival;
    arrival.name = in.text_or("name", {}, limits::name_bytes);
    arrival.colour = in.text_or("colour", {});
    arrival.resume_token = in.text_or("resumeToken", {});
    const auto last_seq = in.count_if("lastSeq", 0, std::uint64_t{1} << 53);
    if (!arrival.colour.empty() && !is_colour(arrival.colour))
        in.fault("colour", "must be written #rrggbb");
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.find(id);
    if (!session)
        return reply.fault(session.error());
    const auto joined = call.client->join(*session, std::move(arrival));
    if (!joined)
        return reply.fault(joined.error());
    json out{{"seq", (*session)->seq()},
             {"participants", participants_json(**session)},
             {"you", joined->you.id},
             {"role", name(joined->you.role)},
             {"resumeToken", joined->resume_token}};
    const auto missed =
        joined->same_life && last_seq ? (*session)->changes_since(*last_seq) : std::nullopt;
    out["resumed"] = missed.has_value();
    if (missed)
        out["patches"] = patches_json(*missed);
    else
        out["snapshot"] = records_json(**session);
    reply.result(out);
    // Those who were here when the disk began to refuse have been told then.
    if (const Journal* journal = call.context.journal)
        if (auto refusal = journal->refusal())
            call.client->notify(durability_notice(tl::unexpected(std::move(*refusal))));
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
        {"session.fork",
         "Makes a new session with the records of another, but none of its people, links and "
         "history. Not for share links.",
         {session_parameter(), name},
         "{session}",
         server_editor,
         fork},
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
          {"colour", R"({"type":"string","pattern":"^#[0-9a-fA-F]{6}$"})", false,
           "#rrggbb; left out: one that few others have"},
          {"resumeToken", text, false, "of an earlier stay, to take up its place again"},
          {"lastSeq", R"({"type":"integer","minimum":0})", false,
           "with resumeToken: the last seq seen; what was missed comes instead of the snapshot"}},
         "{resumed, snapshot: {session, name, rakes, surfaces, bookmarks, annotations, clock} or "
         "patches: "
         "[{op, type, id, record?}], seq, participants: [{participant, name, colour, role, "
         "connected, pointer, camera, dragging, selected}], you, role, resumeToken}",
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
         "{session, name, seq, rakes, surfaces, bookmarks, annotations, clock, participants}",
         any_viewer,
         state},
    };
}

} // namespace wakesurf::server
