// session.create, session.fork, session.list, session.join, session.leave, session.state.
#include "protocol/api/checked_json.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/limits.hpp"
#include "server/rpc/aside_json.hpp"
#include "server/rpc/durability_notice.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/patch_json.hpp"
#include "server/rpc/records_json.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/rpc/session_entry.hpp"
#include "server/session/people/display_name.hpp"
#include "server/session/records/colours.hpp"

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

json made_json(const Call& call, const Session& session) {
    return {{"session", session.id()},
            {"name", session.name()},
            {"remaining", call.context.sessions.remaining()}};
}

void create(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string name = in.text_or("name", {}, limits::name_bytes);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const auto session = call.context.sessions.create(display_name(name, limits::name_bytes));
    if (!session)
        return reply.fault(session.error());
    reply.result(made_json(call, **session));
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
    reply.result(made_json(call, **session));
}

void list(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const bool trash = in.flag_or("trash", false);
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const SessionDirectory& sessions = call.context.sessions;
    const std::string& own = call.identity.session;
    json out = json::array();
    if (trash) {
        for (const auto& [id, session] : sessions.trash().all())
            if (own.empty())
                out.push_back(session_entry(session));
    } else {
        for (const auto& [id, session] : sessions.all())
            if (own.empty() || id == own)
                out.push_back(session_entry(*session, sessions.unix_time()));
    }
    reply.result({{"sessions", std::move(out)},
                  {"limit", limits::kept_sessions},
                  {"trashLimit", limits::trash}});
}

void join(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string given = in.text_or("session", {});
    Arrival arrival;
    arrival.name = in.text_or("name", {}, limits::name_bytes);
    arrival.colour = in.text_or("colour", {});
    arrival.resume_token = in.text_or("resumeToken", {});
    const auto last_seq = in.count_if("lastSeq", 0, std::uint64_t{1} << 53);
    if (!arrival.colour.empty() && !is_colour(arrival.colour))
        in.fault("colour", "must be written #rrggbb");
    if (auto verdict = in.verdict(); !verdict)
        return reply.fault(verdict.error());
    const std::string& own = call.identity.session;
    const auto session = call.context.sessions.find(!given.empty() ? given
                                                    : own.empty()  ? "main"
                                                                   : own);
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
    if (const auto created = (*session)->profile().created)
        out["created"] = protocol::utc_text(*created);
    const auto missed =
        joined->same_life && last_seq ? (*session)->changes_since(*last_seq) : std::nullopt;
    out["resumed"] = missed.has_value();
    if (missed)
        out["patches"] = patches_json(*missed);
    else
        out["snapshot"] = records_json(**session);
    reply.result(out);
    if (!call.context.notice.empty())
        call.client->notify(call.context.notice);
    // Those who were here when the disk began to refuse have been told then.
    if (const Journal* journal = call.context.journal)
        if (auto refusal = journal->refusal())
            call.client->notify(durability_notice(tl::unexpected(std::move(*refusal))));
    if (const auto notice = kept_aside_notice(**session))
        call.client->notify(*notice);
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
         "Makes a new, empty session. One without a name that no one edits, shares or is in goes "
         "again when there are "
         "too many; no other does.",
         {name},
         "{session, name, remaining}: how many more can be made",
         server_editor,
         create},
        {"session.fork",
         "Makes a new session with the records of another, but none of its people, links and "
         "history. Not for share links.",
         {session_parameter(), name},
         "{session, name, remaining}",
         server_editor,
         fork},
        {"session.list",
         "The sessions of this server; with a share link, its own.",
         {{"trash", R"({"type":"boolean"})", false, "true: those that were deleted instead"}},
         "{sessions: [{session, name, participants, people: [{name, colour}], created?, lastUsed, "
         "edited, rakes, surfaces, bookmarks, annotations, thumbnail, deletedAt?, deletedUntil?}], "
         "limit, trashLimit}: participants are here now, people were, who came last first",
         any_viewer,
         list},
        {"session.join",
         "Enters a session: its changes are told to this WebSocket from now on.",
         {{"session", text, false,
           "an id from session.list or session.create; left out: the share link's, else `main`"},
          name,
          {"colour", R"({"type":"string","pattern":"^#[0-9a-fA-F]{6}$"})", false,
           "#rrggbb; left out: one that few others have"},
          {"resumeToken", text, false, "of an earlier stay, to take up its place again"},
          {"lastSeq", R"({"type":"integer","minimum":0})", false,
           "with resumeToken: the last seq seen; what was missed comes instead of the snapshot"}},
         "{resumed, snapshot: {session, name, rakes, surfaces, bookmarks, annotations, clock, "
         "keptAside?: {count, records: [{type, id, why, since}]}} or patches: "
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
         "{session, name, seq, rakes, surfaces, bookmarks, annotations, clock, participants, "
         "keptAside?: {count, records: [{type, id, why, since}]}}",
         any_viewer,
         state},
    };
}

} // namespace wakesurf::server
