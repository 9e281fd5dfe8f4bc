#include "server/session/record_entries.hpp"

#include "server/limits.hpp"
#include "server/session/surface_rules.hpp"
#include "server/session/thumbnail.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr protocol::RecordLimits record_limits{
    {limits::seeds_least, limits::seeds_most, limits::rake_points, limits::name_bytes},
    {limits::quads_default, limits::quads_most},
    {limits::name_bytes, limits::view_bytes},
    {limits::annotation_bytes, limits::name_bytes},
    limits::clock_speed};

core::Result<Record> parse(RecordType type, const std::string& text) {
    const auto wide = [](auto record) { return Record(std::move(record)); };
    switch (type) {
    case RecordType::Surface:
        return protocol::parse_surface(text, record_limits).map(wide);
    case RecordType::Bookmark:
        return protocol::parse_bookmark(text, record_limits).map(wide);
    case RecordType::Annotation:
        return protocol::parse_annotation(text, record_limits).map(wide);
    case RecordType::Rake:
        break;
    }
    return protocol::parse_rake(text, record_limits).map(wide);
}

core::Result<void> check_surface(const protocol::SurfaceRecord& record,
                                 const SessionRecords& records) {
    if (!records.holds_rakes_of(record))
        return core::fail(Error::Code::Corrupt, "its rake is not there");
    protocol::SurfaceSetting setting;
    setting.rake = record.rake;
    setting.rake2 = record.rake2;
    setting.parameters = record.parameters;
    return check_kind(setting);
}

core::Result<void> take(const RecordKey& key, const std::string& text, SessionRecords& into) {
    const std::uint64_t number = SessionRecords::number_of(key);
    if (number == 0)
        return core::fail(Error::Code::Corrupt, "this is no id");
    const auto record = parse(key.type, text);
    if (!record)
        return tl::unexpected(record.error());
    if (key_of(*record) != key)
        return core::fail(Error::Code::Corrupt, "the record has another id");
    if (into.count(key.type) >= most_records(key.type))
        return core::over_limit(most_records(key.type), "there are too many");
    if (const auto* surface = std::get_if<protocol::SurfaceRecord>(&*record))
        if (auto sound = check_surface(*surface, into); !sound)
            return sound;
    into.put(*record);
    into.skip_numbers(key.type, number + 1);
    return {};
}

void take_head(const std::string& text, KeptRecords& into) {
    const auto head = protocol::parse_session_head(text);
    if (!head) {
        into.report.refused.push_back(head.error());
        return;
    }
    into.name = head->name;
    into.seq = head->seq;
    into.records.skip_numbers(RecordType::Rake, head->next_rake);
    into.records.skip_numbers(RecordType::Surface, head->next_surface);
    into.records.skip_numbers(RecordType::Bookmark, head->next_bookmark);
    into.records.skip_numbers(RecordType::Annotation, head->next_annotation);
}

void take_clock(const std::string& text, KeptRecords& into) {
    auto clock = protocol::parse_clock(text, record_limits);
    if (clock)
        into.clock = *clock;
    else
        into.report.refused.push_back(
            {clock.error().code, "clock: " + clock.error().message, clock.error().hint});
}

void take_profile(const std::string& text, KeptRecords& into) {
    auto profile = protocol::read_profile(text);
    if (profile)
        into.profile = std::move(*profile);
    else
        into.report.refused.push_back(std::move(profile.error()));
}

void take_thumbnail(const std::string& text, KeptRecords& into) {
    const std::string base64 = text.size() < 2 ? text : text.substr(1, text.size() - 2);
    if (const auto image = read_thumbnail(base64))
        into.thumbnail = base64;
    else
        into.report.refused.push_back(
            {Error::Code::Corrupt, "thumbnail: " + image.error().message, {}});
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

JournalEntry entry_without(const RecordKey& key) {
    return {std::string(name(key.type)), key.id, std::nullopt};
}

KeptRecords read_entries(std::span<const JournalEntry> entries) {
    KeptRecords out;
    for (const JournalEntry& entry : entries)
        if (entry.type == "session" && entry.record)
            take_head(*entry.record, out);
        else if (entry.type == "clock" && entry.record)
            take_clock(*entry.record, out);
        else if (entry.type == "profile" && entry.record)
            take_profile(*entry.record, out);
        else if (entry.type == "thumbnail" && entry.record)
            take_thumbnail(*entry.record, out);
    for (const RecordType type : record_types) // rakes first: surfaces hang on them
        for (const JournalEntry& entry : entries) {
            if (entry.type != name(type) || !entry.record)
                continue;
            auto taken = take({type, entry.id}, *entry.record, out.records);
            if (taken) {
                ++out.report.restored;
                continue;
            }
            Error error = std::move(taken.error());
            error.message = entry.type + " " + entry.id.substr(0, 64) + ": " + error.message;
            out.report.refused.push_back(std::move(error));
        }
    colour_rakes(out.records);
    return out;
}

} // namespace wakesurf::server
