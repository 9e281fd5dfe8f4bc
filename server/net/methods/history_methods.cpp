// history.undo, history.redo.
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/history.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"

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

} // namespace wakesurf::server
