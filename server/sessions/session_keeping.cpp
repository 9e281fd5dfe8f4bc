// A session beyond its life: to the journal, back from it, and as a copy.
#include "protocol/api/record_text.hpp"
#include "server/base/limits.hpp"
#include "server/sessions/session.hpp"

#include <algorithm>
#include <iterator>

namespace wakesurf::server {

namespace {

/// Epochs and seq start this far above what was kept: what was told but had not reached the disk when the
/// server ended is not known.
constexpr std::uint32_t restart_gap = 1u << 16;

/// Returns whether it was shared. The link of the maker of a copy into that copy does not share it.
bool was_shared(const JournalEntry& entry) {
    if (entry.type != "grant" || !entry.record)
        return false;
    const auto grant = protocol::parse_grant(*entry.record);
    return !grant || grant->copier.empty();
}

} // namespace

/// Older versions kept no profile of a session: each of their sessions counts as work, unless it is empty.
protocol::SessionProfile Session::profile_of(StoredRecords& kept,
                                             std::span<const JournalEntry> entries) const {
    protocol::SessionProfile profile;
    if (kept.profile) {
        profile = std::move(*kept.profile);
    } else {
        profile.last_used = profile_.value().last_used;
        profile.edited = kept.seq > 0 || !records_.empty();
        profile.on_purpose = !name_.empty() && name_ != id_;
    }
    profile.on_purpose =
        profile.on_purpose || std::any_of(entries.begin(), entries.end(), was_shared);
    return profile;
}

protocol::SessionHead Session::head() const {
    return {name_,
            seq_,
            records_.next_number(RecordType::Rake),
            records_.next_number(RecordType::Surface),
            records_.next_number(RecordType::Bookmark),
            records_.next_number(RecordType::Annotation),
            units_,
            records_.next_number(RecordType::Slice),
            records_.next_number(RecordType::Lines)};
}

std::vector<JournalEntry> Session::own_entries() const {
    const auto records = records_.list();
    std::vector<JournalEntry> entries{entry_of(head()), profile_.entry()};
    std::transform(records.begin(), records.end(), std::back_inserter(entries),
                   [](const Record& each) { return entry_of(each); });
    if (const protocol::ClockRecord clock = clock_.record(); clock != protocol::ClockRecord{})
        entries.push_back(entry_of(clock));
    if (!thumbnail_.empty())
        entries.push_back(entry_of_thumbnail(thumbnail_));
    return entries;
}

void Session::keep() {
    if (services_.journal != nullptr)
        services_.journal->write(id_, own_entries());
}

std::vector<JournalEntry> Session::entries() const {
    auto entries = own_entries();
    auto places = participants_.entries();
    std::move(places.begin(), places.end(), std::back_inserter(entries));
    return entries;
}

void Session::end() {
    services_.journal = nullptr;
    participants_.end();
    for (const auto& [id, surface] : records_.all<protocol::SurfaceRecord>())
        builds_.retire(id);
    clock_.pause();
    attendance_.end();
}

void Session::keep_time() {
    if (services_.journal == nullptr || !clock_.playing())
        return;
    services_.journal->write(id_, {entry_of(clock_.record())});
    time_kept_ = services_.now();
}

void Session::time_moved(bool jumped) {
    if (services_.now() - time_kept_ >= limits::clock_kept)
        keep_time();
    builds_.show(clock_.time(), clock_.playing(), jumped);
}

void Session::begin(std::uint32_t epochs_before, bool rest) {
    std::vector<RecordChange> changes;
    for (Record record : records_.list()) {
        if (auto* surface = std::get_if<protocol::SurfaceRecord>(&record))
            surface->epoch = epochs_before == 0 ? 0 : surface->epoch + epochs_before;
        if (auto* rake = std::get_if<protocol::RakeRecord>(&record)) {
            rake->dragging = false;
            rake->leased_by.clear();
        }
        records_.put(record);
        changes.push_back({key_of(record), nullptr, std::make_shared<const Record>(record)});
    }
    build(changes, rest);
    keep();
    count_memory();
}

RestoreReport Session::restore(std::span<const JournalEntry> entries) {
    StoredRecords kept = read_entries(entries);
    if (!kept.name.empty())
        name_ = std::move(kept.name);
    units_ = std::move(kept.units);
    seq_ = kept.seq + restart_gap;
    changes_.start(seq_);
    records_ = std::move(kept.records);
    if (kept.clock) { // its surfaces are built for that time
        clock_.restore(*kept.clock);
        builds_.show(clock_.time(), false, true);
    }
    for (const JournalEntry& each : entries)
        if (each.type == "participant" && each.record)
            if (auto back = participants_.restore(each.id, *each.record); !back)
                kept.report.refused.push_back(refused_entry(each, std::move(back.error())));
    thumbnail_ = std::move(kept.thumbnail);
    profile_.restore(profile_of(kept, entries));
    set_aside(kept.report.refused); // before what is put in their place
    begin(restart_gap, true);       // it may never be viewed
    return std::move(kept.report);
}

void Session::set_aside(const std::vector<RefusedEntry>& refused) {
    std::vector<KeptAside> records;
    for (const RefusedEntry& each : refused)
        records.push_back({each.type, each.id, each.error.message, services_.unix_time()});
    if (records.empty())
        return;
    if (services_.journal != nullptr)
        services_.journal->set_aside(id_, records);
    recall_aside(std::move(records), true);
}

void Session::recall_aside(std::vector<KeptAside> records, bool fresh) {
    newly_aside_ += fresh ? records.size() : 0;
    aside_.insert(fresh ? aside_.end() : aside_.begin(), std::make_move_iterator(records.begin()),
                  std::make_move_iterator(records.end()));
}

void Session::copy(const Session& other, bool on_purpose) {
    records_ = other.records_;
    units_ = other.units_;
    profile_.copied(other.id_, other.name_);
    if (on_purpose) {
        profile_.made_on_purpose();
        profile_.edited();
    }
    clock_.restore(other.clock_.record());
    builds_.show(clock_.time(), false, true);
    begin(0, false); // a copy is made to be looked at
}

void Session::take_over(StoredRecords kept) {
    records_ = std::move(kept.records);
    units_ = std::move(kept.units);
    if (kept.clock) {
        clock_.restore(*kept.clock);
        builds_.show(clock_.time(), false, true);
    }
    profile_.made_on_purpose();
    profile_.edited();
    begin(0, true); // a file may hold more surfaces than will be viewed
}

void Session::delete_at(std::optional<std::int64_t> when) {
    profile_.deleted(when);
    keep_profile();
}

} // namespace wakesurf::server
