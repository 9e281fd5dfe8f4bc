// The methods on sessions: making and listing them, joining, presence, undo.

#include "core/base/plain_text.hpp"
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/history.hpp"
#include "protocol/api/generated/session.hpp"
#include "protocol/api/messages_presence.hpp"
#include "protocol/api/plural.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/base/limits.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/notifications.hpp"
#include "server/net/methods/records_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace wakesurf::server {

namespace {

void presence_update(const Call& call, const protocol::PresenceUpdate& update, Reply reply) {
    const auto session = choose_session(call, update.session);
    if (!session)
        return reply.fault(session.error());
    if (call.client->session() != *session)
        return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                       "presence can only be sent to the session you joined",
                                       "join it first"});
    (*session)->participants().update(*call.client, update);
    reply.result(nlohmann::json::object());
}

} // namespace

std::vector<Method> presence_methods() {
    return {method(presence_update)};
}

using nlohmann::json;

namespace {

json change_json(const RecordChange& change) {
    json out{{"op", change.after ? "put" : "delete"},
             {"type", name(change.key.type)},
             {"id", change.key.id}};
    if (change.after)
        out["rev"] = rev_of(*change.after);
    return out;
}

json skip_json(const HistoryMoveResult::Skip& each) {
    return {{"type", name(each.key.type)}, {"id", each.key.id}, {"why", each.why}};
}

void move(HistoryMove by, const Call& call, const std::optional<std::string>& named, Reply reply) {
    const auto session = choose_session(call, named);
    if (!session)
        return reply.fault(session.error());
    const HistoryMoveResult result = (*session)->move_in_history(by, author_of(call, **session));
    json out{{"skipped", protocol::list_json(result.skipped, skip_json)},
             {"undo", result.left.undo},
             {"redo", result.left.redo},
             {"seq", (*session)->seq()}};
    out[by == HistoryMove::Undo ? "undone" : "redone"] =
        result.changes.empty() ? json(nullptr) : protocol::list_json(result.changes, change_json);
    reply.result(out);
}

void history_undo(const Call& call, const protocol::HistoryUndo& of, Reply reply) {
    move(HistoryMove::Undo, call, of.session, std::move(reply));
}

void history_redo(const Call& call, const protocol::HistoryRedo& of, Reply reply) {
    move(HistoryMove::Redo, call, of.session, std::move(reply));
}

} // namespace

std::vector<Method> history_methods() {
    return {method(history_undo), method(history_redo)};
}

using nlohmann::json;

namespace {

json participants_json(Session& session) {
    return protocol::list_json(session.participants().shown(), [](const auto& each) {
        return protocol::participant_json(each,
                                          protocol::member::person | protocol::said(each.presence));
    });
}

/// Says whether a caller by a share link may make a copy. Unchanged copies make room for further ones: so
/// one holder of the link cannot keep the others from theirs by making many.
core::Result<void> room_for_copy(const Call& call) {
    if (call.identity.grant.empty())
        return {};
    const auto over = [&](const std::string& by, std::size_t most) {
        const auto copies = call.context.grants.copies(by);
        std::vector<std::string> ids;
        for (const Grant& each : copies)
            ids.push_back(each.session);
        return copies.size() >= most && !call.context.sessions.give_up_one(ids);
    };
    // As many as are left of all: what some links have leaves a share to the others.
    const std::size_t left =
        limits::copies_by_links -
        std::min(limits::copies_by_links, call.context.grants.copies({}).size());
    const std::size_t most = std::clamp<std::size_t>(left, 1, limits::copies_by_link);
    if (over(call.identity.account(), most))
        return core::over_limit(
            most,
            "those who came by this share link have " + std::to_string(most) +
                " copies already, and have changed each of them",
            "go on in one of them, or ask a host of the session for a link to edit");
    if (over({}, limits::copies_by_links))
        return core::over_limit(limits::copies_by_links,
                                "those who came by share links have " +
                                    std::to_string(limits::copies_by_links) +
                                    " copies already, and have changed each of them",
                                "ask someone with the server's token to delete some");
    return {};
}

json made_json(const Call& call, const Session& session) {
    return {{"session", session.id()},
            {"name", session.name()},
            {"remaining", call.context.sessions.remaining()}};
}

void session_create(const Call& call, const protocol::SessionCreate& of, Reply reply) {
    const auto session =
        call.context.sessions.create(core::display_name(of.name, limits::name_bytes));
    if (!session)
        return reply.fault(session.error());
    reply.result(made_json(call, **session));
}

void session_fork(const Call& call, const protocol::SessionFork& of, Reply reply) {
    const auto from = choose_session(call, of.session);
    if (!from)
        return reply.fault(from.error());
    if (const auto room = room_for_copy(call); !room)
        return reply.fault(room.error());
    const bool by_link = !call.identity.grant.empty();
    const auto session = call.context.sessions.fork(
        (*from)->id(), core::display_name(of.name, limits::name_bytes), !by_link,
        call.identity.grant.empty() ? std::string() : call.identity.account());
    if (!session)
        return reply.fault(session.error());
    json out = made_json(call, **session);
    if (by_link) {
        const auto made =
            call.context.grants.make_for_copy((*session)->id(), maker_of(call, **from));
        if (!made) { // a copy that no participant could enter
            call.context.sessions.give_up_one(std::array{(*session)->id()});
            return reply.fault(made.error());
        }
        out["key"] = made->key;
        out["link"] = link_to((*session)->id(), made->key);
    }
    reply.result(std::move(out));
}

json profile_json(const protocol::SessionProfile& profile) {
    const auto visitor = [](const protocol::SessionPerson& each) {
        return json{{"name", each.name}, {"colour", each.colour}};
    };
    json out{{"people", protocol::list_json(profile.people, visitor)},
             {"lastUsed", protocol::utc_text(profile.last_used)},
             {"edited", profile.edited}};
    if (profile.created)
        out["created"] = protocol::utc_text(*profile.created);
    return out;
}

void add_counts(json& out, const std::array<std::size_t, record_types.size()>& records) {
    for (const RecordType type : record_types)
        out[protocol::plural_of(name(type))] = records[static_cast<std::size_t>(type)];
}

/// Returns a SessionEntry. @param now  seconds since 1970: a session with participants is in use now
json session_entry(const Session& session, std::int64_t now) {
    const std::size_t here = session.participants().present().size();
    protocol::SessionProfile profile = session.profile();
    if (here > 0)
        profile.last_used = std::clamp<std::int64_t>(now, 0, protocol::last_utc_second);
    json out = profile_json(profile);
    std::array<std::size_t, record_types.size()> records{};
    for (const RecordType type : record_types)
        records[static_cast<std::size_t>(type)] = session.records().count(type);
    add_counts(out, records);
    out["session"] = session.id();
    out["name"] = session.name();
    out["participants"] = here;
    out["thumbnail"] = !session.thumbnail().empty();
    return out;
}

json session_entry(const TrashedSession& session) {
    json out = profile_json(session.profile);
    add_counts(out, session.records);
    out["session"] = session.id;
    out["name"] = session.name;
    out["participants"] = 0;
    out["thumbnail"] = session.thumbnail;
    out["deletedAt"] = protocol::utc_text(session.profile.deleted.value_or(0));
    out["deletedUntil"] = protocol::utc_text(deleted_until(session.profile));
    return out;
}

void session_list(const Call& call, const protocol::SessionList& of, Reply reply) {
    const SessionDirectory& sessions = call.context.sessions;
    const std::string& own = call.identity.session;
    json out = json::array();
    if (of.trash) {
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

void session_join(const Call& call, const protocol::SessionJoin& asked, Reply reply) {
    const std::string given = asked.session.value_or("");
    Arrival arrival;
    arrival.name = asked.name;
    arrival.colour = asked.colour;
    arrival.resume_token = asked.resume_token.value_or("");
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
    const protocol::SessionProfile& profile = (*session)->profile();
    if (profile.created)
        out["created"] = protocol::utc_text(*profile.created);
    if (!profile.copy_of.empty())
        out["copyOf"] = {{"session", profile.copy_of}, {"name", profile.copy_name}};
    const auto missed = joined->same_life && asked.last_seq
                            ? (*session)->changes_since(*asked.last_seq)
                            : std::nullopt;
    out["resumed"] = missed.has_value();
    if (missed)
        out["patches"] = patches_json(*missed);
    else
        out["snapshot"] = records_json(**session);
    reply.result(out);
    if (!call.context.notice.empty())
        call.client->notify(call.context.notice);
    // Clients that were connected when the disk began to refuse have been told then.
    if (const Journal* journal = call.context.journal)
        if (auto refusal = journal->refusal())
            call.client->notify(durability_notice(tl::unexpected(std::move(*refusal))));
    if (const auto notice = kept_aside_notice(**session))
        call.client->notify(*notice);
    if (const auto& names = (*session)->replaced_data(); !names.empty())
        call.client->notify(replaced_data_meanwhile_notice(names));
}

void session_leave(const Call& call, const protocol::SessionLeave&, Reply reply) {
    call.client->leave();
    reply.result(json::object());
}

void session_state(const Call& call, const protocol::SessionState& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    json out = records_json(**session);
    out["seq"] = (*session)->seq();
    out["participants"] = participants_json(**session);
    reply.result(out);
}

} // namespace

std::vector<Method> session_methods() {
    return {method(session_create), method(session_fork),  method(session_list),
            method(session_join),   method(session_leave), method(session_state)};
}

} // namespace wakesurf::server
