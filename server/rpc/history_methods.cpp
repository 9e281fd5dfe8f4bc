// history.undo, history.redo.
#include "protocol/api/checked_json.hpp"
#include "server/rpc/author.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

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

void turn(Turn way, const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const TurnResult result = (*session)->turn(way, author_of(call, **session));
    json changes = json::array();
    for (const RecordChange& each : result.changes)
        changes.push_back(change_json(each));
    json skipped = json::array();
    for (const TurnResult::Skip& each : result.skipped)
        skipped.push_back({{"type", name(each.key.type)}, {"id", each.key.id}, {"why", each.why}});
    json out{{"skipped", std::move(skipped)},
             {"undo", result.left.undo},
             {"redo", result.left.redo},
             {"seq", (*session)->seq()}};
    out[way == Turn::Undo ? "undone" : "redone"] =
        changes.empty() ? json(nullptr) : std::move(changes);
    reply.result(out);
}

} // namespace

std::vector<Method> history_methods() {
    return {
        {"history.undo",
         "Takes back the caller's newest edit, a whole gesture (or drag) at once. Never undoes "
         "others' work: an "
         "edit whose records someone else has changed since is skipped, once and for all.",
         {session_parameter()},
         "{undone: [{op, type, id, rev?}] or null, skipped: [{type, id, why}], undo, redo, seq}: "
         "undo and redo are how many more there are",
         any_editor,
         [](const Call& call, Reply reply) { turn(Turn::Undo, call, std::move(reply)); }},
        {"history.redo",
         "Does the caller's newest undone edit again.",
         {session_parameter()},
         "{redone, skipped, undo, redo, seq}, as history.undo",
         any_editor,
         [](const Call& call, Reply reply) { turn(Turn::Redo, call, std::move(reply)); }},
    };
}

} // namespace wakesurf::server
