#include "server/sessions/records/record_entries.hpp"

#include "core/base/plain_text.hpp"
#include "core/surface/time_direction.hpp"
#include "server/sessions/records/thumbnail.hpp"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

namespace wakesurf::server {

using core::Error;

namespace {

/// Cleans what people type (names of rakes and bookmarks, texts of notes, names of authors), so that
/// nothing in it acts.
void clean_names(Record& record) {
    const auto clean = [](std::string& name) { name = core::display_name(name, name.size()); };
    std::visit(
        [&](auto& each) {
            using Kind = std::decay_t<decltype(each)>;
            if constexpr (std::is_same_v<Kind, protocol::AnnotationRecord>)
                each.text = core::display_lines(each.text, each.text.size());
            else if constexpr (!std::is_same_v<Kind, protocol::SurfaceRecord> &&
                               !std::is_same_v<Kind, protocol::SliceRecord> &&
                               !std::is_same_v<Kind, protocol::LinesRecord>)
                clean(each.name);
            if constexpr (std::is_same_v<Kind, protocol::AnnotationRecord> ||
                          std::is_same_v<Kind, protocol::RakeRecord>)
                clean(each.author);
        },
        record);
}

core::Result<Record> parse(RecordType type, const std::string& text) {
    const auto wide = [](auto record) { return Record(std::move(record)); };
    switch (type) {
    case RecordType::Surface:
        return protocol::parse_surface(text).map(wide);
    case RecordType::Slice:
        return protocol::parse_slice(text).map(wide);
    case RecordType::Lines:
        return protocol::parse_lines(text).map(wide);
    case RecordType::Bookmark:
        return protocol::parse_bookmark(text).map(wide);
    case RecordType::Annotation:
        return protocol::parse_annotation(text).map(wide);
    case RecordType::Rake:
        break;
    }
    return protocol::parse_rake(text).map(wide);
}

core::Result<void> check_rules_of(const protocol::SurfaceRecord& record) {
    protocol::SurfaceSetting setting;
    setting.rake = record.rake;
    setting.rake2 = record.rake2;
    setting.parameters = record.parameters;
    if (auto sound = protocol::check_rules(setting); !sound)
        return sound;
    return core::check_direction(record.parameters);
}

/// Returns the record as it is read back: a lease is not kept.
Record without_lease(Record record) {
    if (auto* rake = std::get_if<protocol::RakeRecord>(&record)) {
        rake->dragging = false;
        rake->leased_by.clear();
    }
    return record;
}

/// Level surfaces hung on rakes once: such a one stands by itself now.
void leave_out_rake(Record& record) {
    if (auto* surface = std::get_if<protocol::SurfaceRecord>(&record))
        surface->rake = rake_kept(surface->parameters, surface->rake);
}

core::Result<void> take(const RecordKey& key, const std::string& text, SessionRecords& into) {
    // Also of one that is refused: another record under its id would be taken for it.
    into.skip_numbers(key.type, SessionRecords::number_of(key) + 1);
    const auto record = read_record(key, text);
    if (!record)
        return tl::unexpected(record.error());
    if (into.count(key.type) >= most_records(key.type))
        return core::over_limit(most_records(key.type), "there are too many");
    if (const auto* surface = std::get_if<protocol::SurfaceRecord>(&*record))
        if (!into.holds_rakes_of(*surface))
            return core::fail(Error::Code::Corrupt, "its rake does not exist");
    into.put(*record);
    return {};
}

void refuse(const JournalEntry& entry, Error error, StoredRecords& into) {
    into.report.refused.push_back(refused_entry(entry, std::move(error)));
}

void take_head(const JournalEntry& entry, StoredRecords& into) {
    auto head = protocol::parse_session_head(*entry.record);
    if (!head)
        return refuse(entry, std::move(head.error()), into);
    into.name = head->name;
    into.seq = head->seq;
    into.units = std::move(head->units);
    into.records.skip_numbers(RecordType::Rake, head->next_rake);
    into.records.skip_numbers(RecordType::Surface, head->next_surface);
    into.records.skip_numbers(RecordType::Slice, head->next_slice);
    into.records.skip_numbers(RecordType::Lines, head->next_lines);
    into.records.skip_numbers(RecordType::Bookmark, head->next_bookmark);
    into.records.skip_numbers(RecordType::Annotation, head->next_annotation);
}

void take_clock(const JournalEntry& entry, StoredRecords& into) {
    auto clock = protocol::parse_clock(*entry.record);
    if (!clock)
        return refuse(entry, std::move(clock.error()), into);
    into.clock = *clock;
}

void take_profile(const JournalEntry& entry, StoredRecords& into) {
    auto profile = protocol::parse_profile(*entry.record);
    if (!profile)
        return refuse(entry, std::move(profile.error()), into);
    into.profile = std::move(*profile);
}

void take_thumbnail(const JournalEntry& entry, StoredRecords& into) {
    const std::string& text = *entry.record;
    const std::string base64 = text.size() < 2 ? text : text.substr(1, text.size() - 2);
    auto image = read_thumbnail(base64);
    if (!image)
        return refuse(entry, std::move(image.error()), into);
    into.thumbnail = base64;
}

/// Rakes kept before they had colours get one each, in the order in which they were made.
void colour_rakes(SessionRecords& records) {
    std::map<std::uint64_t, protocol::RakeRecord> plain;
    for (const auto& [id, rake] : records.all<protocol::RakeRecord>())
        if (rake.colour.empty())
            plain.emplace(SessionRecords::number_of({RecordType::Rake, id}), rake);
    for (auto& [number, rake] : plain) {
        rake.colour = records.free_colour();
        records.put(rake);
    }
}

} // namespace

std::optional<std::string> rake_kept(const core::SurfaceParameters& parameters,
                                     const std::optional<std::string>& rake) {
    return parameters.kind == core::SurfaceKind::Level ? std::nullopt : rake;
}

JournalEntry entry_of(const Record& record) {
    RecordKey key = key_of(record);
    return {std::string(name(key.type)), std::move(key.id),
            std::visit([](const auto& each) { return protocol::record_text(each); }, record)};
}

JournalEntry entry_of(const protocol::ClockRecord& clock) {
    return {"clock", "", protocol::record_text(clock)};
}

JournalEntry entry_of(const protocol::SessionHead& head) {
    return {"session", "", protocol::record_text(head)};
}

JournalEntry entry_of_thumbnail(const std::string& base64) {
    return {"thumbnail", "", '"' + base64 + '"'}; // JSON, as all that the journal keeps
}

RefusedEntry refused_entry(const JournalEntry& entry, Error error) {
    error.message =
        entry.type + (entry.id.empty() ? "" : " " + entry.id.substr(0, 64)) + ": " + error.message;
    return {entry.type, entry.id, std::move(error)};
}

core::Result<Record> read_record(const RecordKey& key, const std::string& text) {
    if (SessionRecords::number_of(key) == 0)
        return core::fail(Error::Code::Corrupt, "this is not an id");
    auto record = parse(key.type, text);
    if (!record)
        return record;
    if (key_of(*record) != key)
        return core::fail(Error::Code::Corrupt, "the record has another id");
    if (const auto* surface = std::get_if<protocol::SurfaceRecord>(&*record))
        if (auto sound = check_rules_of(*surface); !sound)
            return tl::unexpected(sound.error());
    leave_out_rake(*record);
    clean_names(*record); // kept by a version that did not, or from a file
    return record;
}

core::Result<void> check_record(const Record& record) {
    const RecordKey key = key_of(record);
    const JournalEntry kept = entry_of(record);
    const auto again = read_record(key, *kept.record);
    if (again && *again == without_lease(record))
        return {};
    return core::fail(Error::Code::InvalidArgument,
                      again ? "this " + kept.type + " cannot be saved as it is"
                            : again.error().message,
                      "correct the " + kept.type);
}

core::Result<void> check_clock(const protocol::ClockRecord& clock) {
    const auto again = protocol::parse_clock(protocol::record_text(clock));
    if (again)
        return {};
    return core::fail(Error::Code::InvalidArgument, again.error().message,
                      "give other times or another speed");
}

StoredRecords read_entries(std::span<const JournalEntry> entries) {
    StoredRecords out;
    for (const JournalEntry& entry : entries)
        if (entry.type == "session" && entry.record)
            take_head(entry, out);
        else if (entry.type == "clock" && entry.record)
            take_clock(entry, out);
        else if (entry.type == "profile" && entry.record)
            take_profile(entry, out);
        else if (entry.type == "thumbnail" && entry.record)
            take_thumbnail(entry, out);
    for (const RecordType type : record_types) // rakes first: surfaces hang on them
        for (const JournalEntry& entry : entries) {
            if (entry.type != name(type) || !entry.record)
                continue;
            auto taken = take({type, entry.id}, *entry.record, out.records);
            if (taken)
                ++out.report.restored;
            else
                refuse(entry, std::move(taken.error()), out);
        }
    colour_rakes(out.records);
    return out;
}

} // namespace wakesurf::server
