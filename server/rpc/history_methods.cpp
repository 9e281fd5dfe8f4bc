// history.undo, history.redo.
#include "protocol/api/generated/history.hpp"
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

void move(HistoryMove by, const Call& call, const std::optional<std::string>& named, Reply reply) {
    const auto session = choose_session(call, named);
    if (!session)
        return reply.fault(session.error());
    const HistoryMoveResult result = (*session)->move_in_history(by, author_of(call, **session));
    json changes = json::array();
    for (const RecordChange& each : result.changes)
        changes.push_back(change_json(each));
    json skipped = json::array();
    for (const HistoryMoveResult::Skip& each : result.skipped)
        skipped.push_back({{"type", name(each.key.type)}, {"id", each.key.id}, {"why", each.why}});
    json out{{"skipped", std::move(skipped)},
             {"undo", result.left.undo},
             {"redo", result.left.redo},
             {"seq", (*session)->seq()}};
    out[by == HistoryMove::Undo ? "undone" : "redone"] =
        changes.empty() ? json(nullptr) : std::move(changes);
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

} // namespace wakesurf::server
