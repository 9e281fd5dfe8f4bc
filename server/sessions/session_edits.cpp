// The way of every edit of a session: the records, the surfaces that follow from them, the journal, the
// participants, the author's history.

#include "server/sessions/session.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
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
        for (const auto& rake : {surface->rake, surface->rake2})
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

namespace {

std::vector<Patch> patches_of(const std::vector<RecordChange>& changes,
                              const SessionRecords& records,
                              const std::set<std::string>& surfaces) {
    std::vector<Patch> patches;
    // Of what hangs together the dependent goes first and comes last.
    for (auto type = std::rbegin(record_types); type != std::rend(record_types); ++type)
        for (const RecordChange& each : changes)
            if (each.key.type == *type && !each.after)
                patches.emplace_back(DeletedRecord{name(*type), each.key.id});
    for (const RecordChange& each : changes)
        if (each.after && each.key.type != RecordType::Surface)
            std::visit([&](const auto& record) { patches.emplace_back(record); }, *each.after);
    for (const std::string& id : surfaces)
        patches.emplace_back(*records.find<protocol::SurfaceRecord>(id));
    return patches;
}

/// Returns whether only its name or colour is another: then what hangs on it stays as it is.
bool looks_only(const RecordChange& change) {
    if (!change.before)
        return false;
    const auto& before = std::get<protocol::RakeRecord>(*change.before);
    const auto& after = std::get<protocol::RakeRecord>(*change.after);
    return before.shape == after.shape &&
           (before.name != after.name || before.colour != after.colour);
}

/// Returns the name of the edit's gesture. A drag is one gesture also where the client names none; names of
/// clients are never taken for a drag.
std::string gesture_of(const Author& author, std::uint64_t drag) {
    if (!author.gesture.empty())
        return "named " + author.gesture;
    return drag == 0 ? std::string{} : "drag " + std::to_string(drag);
}

/// Returns nothing for what the session's head says.
std::optional<JournalEntry> entry_of_patch(const Patch& patch) {
    return std::visit(
        [](const auto& each) -> std::optional<JournalEntry> {
            using Changed = std::decay_t<decltype(each)>;
            if constexpr (std::is_same_v<Changed, DeletedRecord>)
                return JournalEntry{std::string(each.type), each.id, std::nullopt};
            else if constexpr (std::is_same_v<Changed, SessionName>)
                return std::nullopt;
            else if constexpr (std::is_same_v<Changed, protocol::ClockRecord>)
                return entry_of(each);
            else
                return entry_of(Record(each));
        },
        patch);
}

} // namespace

Session::Epochs Session::edit(std::vector<RecordChange> changes,
                              const Author& author,
                              std::uint64_t drag,
                              std::optional<SurfaceJob> job) {
    if (!author.default_scene)
        profile_.edited();
    Epochs epochs = commit(changes, std::move(job));
    if (author.participant.empty() || author.default_scene)
        return epochs;
    Edit done{{}, gesture_of(author, drag)};
    for (const RecordChange& each : changes)
        done.steps.push_back({each.key, each.before, each.after,
                              each.before ? rev_of(*each.before) : 0,
                              each.after ? rev_of(*each.after) : 0});
    history_.add(author.participant, std::move(done));
    count_memory();
    return epochs;
}

Session::Epochs Session::commit(const std::vector<RecordChange>& changes,
                                std::optional<SurfaceJob> job) {
    for (const RecordChange& each : changes) {
        if (each.after) {
            records_.put(*each.after);
            continue;
        }
        records_.erase(each.key);
        if (each.key.type == RecordType::Surface)
            builds_.retire(each.key.id);
        if (each.key.type == RecordType::Rake)
            leases_.end(each.key.id);
    }
    Epochs epochs = build(changes, false, std::move(job));
    std::set<std::string> surfaces;
    for (const auto& [id, epoch] : epochs)
        surfaces.insert(id);
    announce(patches_of(changes, records_, surfaces));
    count_memory();
    return epochs;
}

Session::Epochs
Session::build(const std::vector<RecordChange>& changes, bool rest, std::optional<SurfaceJob> job) {
    if (!rest)
        attendance_.seen();
    std::set<std::string> set;
    std::set<std::string> hanging;
    for (const RecordChange& each : changes) {
        if (each.after && each.key.type == RecordType::Surface)
            set.insert(each.key.id);
        if (each.after && each.key.type == RecordType::Rake && !looks_only(each))
            for (std::string& id : records_.hanging_on(each.key.id))
                hanging.insert(std::move(id));
    }
    Epochs epochs;
    for (const auto& [id, record] : records_.all<protocol::SurfaceRecord>())
        if (set.contains(id))
            epochs.emplace_back(id, job ? builds_.build(record, *std::exchange(job, std::nullopt))
                                        : builds_.build(record, rest));
        else if (hanging.contains(id))
            if (const auto epoch = builds_.rebuild(record))
                epochs.emplace_back(id, *epoch);
    for (const auto& [id, epoch] : epochs) {
        protocol::SurfaceRecord record = *records_.find<protocol::SurfaceRecord>(id);
        record.epoch = epoch;
        records_.put(record);
        note_data(record.dataset, false);
    }
    return epochs;
}

void Session::announce(const std::vector<Patch>& patches) {
    changes_.add(++seq_, patches);
    if (services_.journal != nullptr) {
        std::vector<JournalEntry> entries{entry_of(head())};
        for (const Patch& each : patches)
            if (auto entry = entry_of_patch(each))
                entries.push_back(std::move(*entry));
        if (auto profile = profile_.due())
            entries.push_back(std::move(*profile));
        services_.journal->write(id_, std::move(entries));
    }
    Telling telling;
    for (const Participant& each : participants_.present())
        each.observer->patched(id_, seq_, patches, telling);
}

void Session::lease_ended(const std::string& rake) {
    const auto* held = records_.find<protocol::RakeRecord>(rake);
    if (held == nullptr || !held->dragging)
        return;
    protocol::RakeRecord record = *held; // its revision stays: nothing of it was edited
    record.dragging = false;
    record.leased_by.clear();
    records_.put(record);
    announce({record});
}

void Session::end_leases(const std::string& participant) {
    for (const std::string& rake : leases_.of(participant)) {
        leases_.end(rake);
        lease_ended(rake);
    }
}

SurfaceBuilds::Events Session::build_events() {
    SurfaceBuilds::Events events;
    events.progress = [this](const SurfaceProgress& progress) {
        Telling telling;
        for (const Participant& each : participants_.present())
            each.observer->progress(progress, telling);
    };
    events.ranges = [this](const SurfaceRanges& ranges) {
        Telling telling;
        for (const Participant& each : participants_.present())
            each.observer->ranges(ranges, telling);
    };
    events.done = [this](const SurfaceOutcome& outcome) {
        Telling telling;
        for (const Participant& each : participants_.present())
            each.observer->done(outcome, telling);
    };
    events.rebuilt = [this](const std::string& surface, std::uint32_t epoch) {
        protocol::SurfaceRecord record = *records_.find<protocol::SurfaceRecord>(surface);
        record.epoch = epoch;
        records_.put(record);
        announce({record});
        attendance_.seen(); // what it computes ends with a check of whether a client is there
    };
    return events;
}

} // namespace wakesurf::server
