#include "protocol/api/record_text.hpp"

#include "core/surface/rake_check.hpp"
#include "protocol/api/json_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

/// The longest record is a rake of a thousand points; a view may nest as deep as a message.
constexpr JsonLimits record_limits{std::size_t{256} << 10, 40};

template <class Read>
auto parse(std::string_view text, const Read& read)
    -> core::Result<decltype(read(std::declval<CheckedJson&>()))> {
    auto value = parse_json(text, record_limits);
    if (!value)
        return tl::unexpected(value.error());
    CheckedJson in(*value);
    auto record = read(in);
    if (auto sound = in.record_verdict(); !sound)
        return tl::unexpected(sound.error());
    return record;
}

} // namespace

std::string record_text(const RakeRecord& record) {
    json value = rake_json(record);
    value.erase("dragging");
    value.erase("leasedBy");
    return json_text(value);
}

std::string record_text(const SurfaceRecord& record) {
    return json_text(surface_json(record));
}

std::string record_text(const BookmarkRecord& record) {
    return json_text(bookmark_json(record));
}

std::string record_text(const AnnotationRecord& record) {
    return json_text(annotation_json(record));
}

std::string record_text(const ClockRecord& record) {
    return json_text(clock_json(record));
}

std::string record_text(const SessionHead& head) {
    return json_text({{"name", head.name},
                      {"seq", head.seq},
                      {"nextRake", head.next_rake},
                      {"nextSurface", head.next_surface},
                      {"nextBookmark", head.next_bookmark},
                      {"nextAnnotation", head.next_annotation}});
}

core::Result<RakeRecord> parse_rake(std::string_view text, const RecordLimits& limits) {
    auto record = parse(text, [&](CheckedJson& in) { return read_rake_record(in, limits.rake); });
    if (record)
        if (auto sound = core::check_rake(record->shape); !sound)
            return core::fail(core::Error::Code::Corrupt, sound.error().message);
    return record;
}

core::Result<SurfaceRecord> parse_surface(std::string_view text, const RecordLimits& limits) {
    return parse(text, [&](CheckedJson& in) { return read_surface_record(in, limits.surface); });
}

core::Result<BookmarkRecord> parse_bookmark(std::string_view text, const RecordLimits& limits) {
    return parse(text, [&](CheckedJson& in) { return read_bookmark_record(in, limits.bookmark); });
}

core::Result<AnnotationRecord> parse_annotation(std::string_view text, const RecordLimits& limits) {
    return parse(text,
                 [&](CheckedJson& in) { return read_annotation_record(in, limits.annotation); });
}

core::Result<ClockRecord> parse_clock(std::string_view text, const RecordLimits& limits) {
    return parse(text, [&](CheckedJson& in) { return read_clock_record(in, limits.clock_speed); });
}

core::Result<SessionHead> parse_session_head(std::string_view text) {
    return parse(text, [](CheckedJson& in) {
        SessionHead head;
        head.name = in.text("name");
        head.seq = in.count("seq", 0, most_rev);
        head.next_rake = in.count("nextRake", 1, most_rev);
        head.next_surface = in.count("nextSurface", 1, most_rev);
        head.next_bookmark = in.count("nextBookmark", 1, most_rev);
        head.next_annotation = in.count("nextAnnotation", 1, most_rev);
        return head;
    });
}

} // namespace wakesurf::protocol
