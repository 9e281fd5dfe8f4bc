// Undo and redo: an author's own edits, taken back or done again where nothing else has changed their
// records since.
#include "server/sessions/session.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

bool sets(const Edit& edit, HistoryMove move, const RecordKey& key, bool there) {
    return std::any_of(edit.steps.begin(), edit.steps.end(), [&](const EditStep& step) {
        return step.key == key && (step.to(move) != nullptr) == there;
    });
}

/// Returns the record to put, as a later revision than any of it before.
std::shared_ptr<const Record> at_new_rev(const EditStep& step, HistoryMove move) {
    if (!step.to(move))
        return nullptr;
    Record record = *step.to(move);
    set_rev(record, std::max({step.before_rev, step.after_rev, step.latest, rev_of(record)}) + 1);
    if (auto* rake = std::get_if<protocol::RakeRecord>(&record)) {
        rake->dragging = false;
        rake->leased_by.clear();
    }
    return std::make_shared<const Record>(std::move(record));
}

} // namespace

HistoryMoveResult Session::move_in_history(HistoryMove move, const Author& author) {
    HistoryMoveResult result;
    if (auto edit = history_.take(author.participant, move)) {
        result.skipped = obstacles(*edit, move);
        if (result.skipped.empty()) {
            std::vector<std::uint64_t> revs;
            for (EditStep& step : edit->steps) {
                const auto now = records_.find(step.key);
                result.changes.push_back({step.key, now, at_new_rev(step, move)});
                revs.push_back(result.changes.back().after ? rev_of(*result.changes.back().after)
                                                           : 0);
                // Its epoch has gone on; if the record comes back, its epochs do too.
                (move == HistoryMove::Undo ? step.after : step.before) = now;
                if (step.key.type == RecordType::Rake)
                    leases_.end(step.key.id);
            }
            profile_.edited();
            commit(result.changes);
            history_.moved(author.participant, move, std::move(*edit), revs);
            count_memory();
        }
    }
    result.left = history_.depth(author.participant);
    return result;
}

std::vector<HistoryMoveResult::Skip> Session::obstacles(const Edit& edit, HistoryMove move) const {
    std::vector<HistoryMoveResult::Skip> out;
    std::size_t before = 0;
    std::size_t after = 0;
    for (const EditStep& step : edit.steps) {
        if (std::string why = obstacle(edit, step, move); !why.empty())
            out.push_back({step.key, std::move(why)});
        before += records_.bytes(step.key);
        after += step.to(move) ? bytes_of(*step.to(move)) : 0;
    }
    if (const auto room = has_room(before, after); !room && out.empty())
        out.push_back({edit.steps.front().key, room.error().message});
    return out;
}

std::string Session::obstacle(const Edit& edit, const EditStep& step, HistoryMove move) const {
    const std::string label = std::string(server::name(step.key.type)) + " " + step.key.id;
    if (records_.rev(step.key) != step.from_rev(move))
        return label + " has been changed by someone else since";
    const auto& to = step.to(move);
    if (!to && step.key.type == RecordType::Rake)
        for (const std::string& id : records_.hanging_on(step.key.id))
            if (!sets(edit, move, {RecordType::Surface, id}, false))
                return "surface " + id + " belongs to " + label;
    if (!to)
        return {};
    if (const auto* surface = std::get_if<protocol::SurfaceRecord>(to.get()))
        for (const auto& rake : {std::optional(surface->rake), surface->rake2})
            if (rake && records_.find<protocol::RakeRecord>(*rake) == nullptr &&
                !sets(edit, move, {RecordType::Rake, *rake}, true))
                return "rake " + *rake + " of " + label + " has been deleted since";
    if (auto sound = check_record(*to); !sound)
        return label + ": " + sound.error().message;
    const auto comes_back = [&](const EditStep& each) {
        return each.key.type == step.key.type && each.from_rev(move) == 0 && each.to(move);
    };
    const auto more =
        static_cast<std::size_t>(std::count_if(edit.steps.begin(), edit.steps.end(), comes_back));
    if (comes_back(step) && records_.count(step.key.type) + more > most_records(step.key.type))
        return "there is no room for " + label + " any more";
    return {};
}

} // namespace wakesurf::server
