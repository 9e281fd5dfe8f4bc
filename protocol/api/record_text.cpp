#include "protocol/api/record_text.hpp"

#include "core/surface/rake.hpp"
#include "protocol/api/base/json_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

/// The longest record is a rake of a thousand points; a view may nest as deep as a message.
constexpr JsonLimits record_limits{std::size_t{256} << 10, 40};

void read(CheckedJson& in, SessionHead& head) {
    head.name = in.text("name");
    head.seq = in.count("seq", 0, most_whole);
    head.next_rake = in.count("nextRake", 1, most_whole);
    head.next_surface = in.count("nextSurface", 1, most_whole);
    head.next_bookmark = in.count("nextBookmark", 1, most_whole);
    head.next_annotation = in.count("nextAnnotation", 1, most_whole);
    if (in.has("units"))
        in.inside("units", [&](CheckedJson& units) {
            head.units.length = units.text("length");
            head.units.time = units.text("time");
        });
}

template <class Record>
core::Result<Record> parse(std::string_view text) {
    auto value = parse_json(text, record_limits);
    if (!value)
        return tl::unexpected(value.error());
    CheckedJson in(*value);
    Record record;
    read(in, record);
    if (auto sound = in.record_verdict(); !sound)
        return tl::unexpected(sound.error());
    return record;
}

} // namespace

std::string record_text(const RakeRecord& record) {
    return json_text(kept_json(record));
}

std::string record_text(const SurfaceRecord& record) {
    return json_text(kept_json(record));
}

std::string record_text(const BookmarkRecord& record) {
    return json_text(kept_json(record));
}

std::string record_text(const AnnotationRecord& record) {
    return json_text(kept_json(record));
}

std::string record_text(const ClockRecord& record) {
    return json_text(kept_json(record));
}

std::string record_text(const SessionHead& head) {
    json out{{"name", head.name},
             {"seq", head.seq},
             {"nextRake", head.next_rake},
             {"nextSurface", head.next_surface},
             {"nextBookmark", head.next_bookmark},
             {"nextAnnotation", head.next_annotation}};
    if (!head.units.empty())
        out["units"] = units_json(head.units);
    return json_text(out);
}

json units_json(const SessionUnits& units) {
    return {{"length", units.length}, {"time", units.time}};
}

core::Result<RakeRecord> parse_rake(std::string_view text) {
    auto record = parse<RakeRecord>(text);
    if (record)
        if (auto sound = core::check_rake(record->shape); !sound)
            return core::fail(core::Error::Code::Corrupt, sound.error().message);
    return record;
}

core::Result<SurfaceRecord> parse_surface(std::string_view text) {
    return parse<SurfaceRecord>(text);
}

core::Result<BookmarkRecord> parse_bookmark(std::string_view text) {
    return parse<BookmarkRecord>(text);
}

core::Result<AnnotationRecord> parse_annotation(std::string_view text) {
    return parse<AnnotationRecord>(text);
}

core::Result<ClockRecord> parse_clock(std::string_view text) {
    return parse<ClockRecord>(text);
}

core::Result<SessionHead> parse_session_head(std::string_view text) {
    return parse<SessionHead>(text);
}

} // namespace wakesurf::protocol
