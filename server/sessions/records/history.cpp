#include "server/sessions/records/history.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

std::size_t bytes_of(const Edit& edit) {
    std::size_t bytes = sizeof(Edit);
    for (const EditStep& step : edit.steps)
        for (const auto& record : {step.before, step.after})
            bytes += record ? server::bytes_of(*record) : 0;
    return bytes;
}

EditStep* find_step(Edit& edit, const RecordKey& key) {
    const auto found = std::find_if(edit.steps.begin(), edit.steps.end(),
                                    [&](const EditStep& each) { return each.key == key; });
    return found == edit.steps.end() ? nullptr : &*found;
}

/// `next` deletes what `into` made, and with it what others had made of that: forgotten with the one, the
/// other could not come back.
bool takes_others_along(Edit& into, const Edit& next) {
    bool unmakes = false;
    bool takes = false;
    for (const EditStep& each : next.steps) {
        const EditStep* mine = find_step(into, each.key);
        unmakes = unmakes || (!each.after && mine != nullptr && !mine->before);
        takes = takes || (!each.after && mine == nullptr);
    }
    return unmakes && takes;
}

/// Makes `into`, of the same gesture, the edit that did both. False where something else came between, or it
/// would be of too many records, or could not be taken back or done again.
bool merge(Edit& into, const Edit& next) {
    if (next.gesture.empty() || into.gesture != next.gesture)
        return false;
    std::size_t more = 0;
    for (const EditStep& each : next.steps) {
        const EditStep* mine = find_step(into, each.key);
        if (mine != nullptr && mine->after_rev != each.before_rev)
            return false;
        more += mine == nullptr ? 1 : 0;
    }
    if (into.steps.size() + more > limits::gesture_records || takes_others_along(into, next))
        return false;
    for (const EditStep& each : next.steps) {
        if (EditStep* mine = find_step(into, each.key)) {
            mine->latest = std::max({mine->latest, mine->after_rev, each.latest});
            mine->after = each.after;
            mine->after_rev = each.after_rev;
        } else {
            into.steps.push_back(each);
        }
    }
    // Made and deleted within one gesture: it never was.
    std::erase_if(into.steps, [](const EditStep& each) { return !each.before && !each.after; });
    return true;
}

} // namespace

void History::add(const std::string& author, Edit edit) {
    Stacks& mine = authors_[author];
    mine.used = next_age_;
    clear(mine.redo);
    if (!mine.undo.empty()) {
        Kept& newest = mine.undo.back();
        if (merge(newest.edit, edit)) {
            bytes_ -= std::exchange(newest.bytes, bytes_of(newest.edit));
            bytes_ += newest.bytes;
            if (newest.edit.steps.empty())
                drop(mine.undo, true);
            return make_room();
        }
    }
    push(mine.undo, std::move(edit));
    make_room();
}

std::optional<Edit> History::take(const std::string& author, HistoryMove move) {
    const auto found = authors_.find(author);
    if (found == authors_.end())
        return std::nullopt;
    Stack& stack = move == HistoryMove::Undo ? found->second.undo : found->second.redo;
    std::optional<Edit> edit;
    if (!stack.empty()) {
        edit = std::move(stack.back().edit);
        drop(stack, true);
    }
    if (Stack& undo = found->second.undo; !undo.empty())
        undo.back().edit.gesture.clear();
    return edit;
}

void History::moved(const std::string& author,
                    HistoryMove move,
                    Edit edit,
                    std::span<const std::uint64_t> revs) {
    Stacks& mine = authors_[author];
    mine.used = next_age_;
    // The edit before this one left what is there again, at a revision of now.
    Stack& from = move == HistoryMove::Undo ? mine.undo : mine.redo;
    for (std::size_t i = 0; i < edit.steps.size(); ++i) {
        EditStep& step = edit.steps[i];
        const std::uint64_t old =
            std::exchange(move == HistoryMove::Undo ? step.before_rev : step.after_rev, revs[i]);
        for (Kept& kept : from)
            for (EditStep& each : kept.edit.steps) {
                std::uint64_t& rev = move == HistoryMove::Undo ? each.after_rev : each.before_rev;
                if (each.key == step.key && rev == old)
                    rev = revs[i];
            }
    }
    edit.gesture.clear();
    push(move == HistoryMove::Undo ? mine.redo : mine.undo, std::move(edit));
    make_room();
}

History::Depth History::depth(const std::string& author) const {
    const auto found = authors_.find(author);
    if (found == authors_.end())
        return {};
    return {found->second.undo.size(), found->second.redo.size()};
}

void History::push(Stack& stack, Edit edit) {
    const std::size_t bytes = bytes_of(edit);
    stack.push_back({std::move(edit), next_age_++, bytes});
    bytes_ += bytes;
    if (stack.size() > limits::undo_steps)
        drop(stack, false);
}

void History::drop(Stack& stack, bool newest) {
    bytes_ -= newest ? stack.back().bytes : stack.front().bytes;
    if (newest)
        stack.pop_back();
    else
        stack.pop_front();
}

void History::clear(Stack& stack) {
    while (!stack.empty())
        drop(stack, true);
}

void History::make_room() {
    while (authors_.size() > limits::undo_authors) {
        const auto idlest =
            std::min_element(authors_.begin(), authors_.end(), [](const auto& a, const auto& b) {
                return a.second.used < b.second.used;
            });
        clear(idlest->second.undo);
        clear(idlest->second.redo);
        authors_.erase(idlest);
    }
    while (bytes_ > limits::undo_bytes) {
        Stack* oldest = nullptr;
        for (auto& [author, stacks] : authors_)
            for (Stack* each : {&stacks.undo, &stacks.redo})
                if (!each->empty() &&
                    (oldest == nullptr || each->front().age < oldest->front().age))
                    oldest = each;
        drop(*oldest, false);
    }
}

} // namespace wakesurf::server
