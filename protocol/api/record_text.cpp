#include "protocol/api/record_text.hpp"

#include "core/surface/rake.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/utc_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

template <class Io>
void members(Io& io, Of<Io, MembershipRecord>& of) {
    io.needed("name", of.name);
    io.needed("colour", of.colour);
    io.needed("role", of.role);
    io.needed("grant", of.grant);
    io.needed("sha256", of.digest);
    io.newer("roleSet", of.role_set); // before, only those were kept whose role was set
    io.some("left", of.left);
    io.some("formerSha256", of.former);
}

template <class Io>
void members(Io& io, Of<Io, GrantRecord>& of) {
    io.needed("role", of.role);
    io.needed("sha256", of.digest);
    io.some("expires", of.expires);
    io.some("maker", of.maker);
    io.some("lineage", of.lineage);
    io.some("lowered", of.lowered);
    io.some("copier", of.copier);
}

template <class Io>
void members(Io& io, Of<Io, SessionPerson>& of) {
    io.needed("participant", of.participant);
    io.needed("name", of.name);
    io.needed("colour", of.colour);
}

template <class Io>
void members(Io& io, Of<Io, SessionProfile>& of) {
    constexpr Rule second{.lo = 0, .hi = last_utc_second};
    io.some("created", of.created, second);
    io.needed("lastUsed", of.last_used, second);
    io.needed("edited", of.edited);
    io.needed("onPurpose", of.on_purpose);
    io.needed("people", of.people);
    io.some("deleted", of.deleted, second);
    io.some("data", of.data);
    io.some("copyOf", of.copy_of);
    io.some("copyName", of.copy_name);
    if (of.people.size() > most_session_people || of.data.size() > most_session_datasets)
        io.check("people", "are too many, or `data`");
}

template <class Io>
void members(Io& io, Of<Io, SessionUnits>& of) {
    io.needed("length", of.length, {.hi = 256, .text = Text::Line});
    io.needed("time", of.time, {.hi = 256, .text = Text::Line});
}

template <class Io>
void members(Io& io, Of<Io, SessionHead>& of) {
    io.needed("name", of.name, {.hi = 256, .text = Text::Line});
    io.needed("seq", of.seq, {.hi = most_whole});
    io.needed("nextRake", of.next_rake, {.lo = 1, .hi = most_whole});
    io.needed("nextSurface", of.next_surface, {.lo = 1, .hi = most_whole});
    io.needed("nextBookmark", of.next_bookmark, {.lo = 1, .hi = most_whole});
    io.needed("nextAnnotation", of.next_annotation, {.lo = 1, .hi = most_whole});
    io.some("units", of.units);
    io.some("nextSlice", of.next_slice, {.lo = 1, .hi = most_whole}); // older sessions have none
    io.some("nextLines", of.next_lines, {.lo = 1, .hi = most_whole});
}

namespace {

/// The longest record is a rake of a thousand points; a view may nest as deep as a message.
constexpr JsonLimits record_limits{std::size_t{256} << 10, 40};

template <class Record>
core::Result<Record> parse(std::string_view text) {
    return parse_json(text, record_limits).and_then(parse_kept<Record>);
}

template <class Record>
core::Result<Record> parse(std::string_view text, const char* damaged, const char* hint = "") {
    return parse<Record>(text).map_error([&](const core::Error&) {
        return core::Error{core::Error::Code::Corrupt, damaged, hint};
    });
}

} // namespace

template <class Record>
std::string record_text(const Record& record) {
    return json_text(kept(record));
}

template std::string record_text(const RakeRecord&);
template std::string record_text(const SurfaceRecord&);
template std::string record_text(const SliceRecord&);
template std::string record_text(const LinesRecord&);
template std::string record_text(const BookmarkRecord&);
template std::string record_text(const AnnotationRecord&);
template std::string record_text(const ClockRecord&);
template std::string record_text(const SessionHead&);
template std::string record_text(const MembershipRecord&);
template std::string record_text(const GrantRecord&);
template std::string record_text(const SessionProfile&);

json units_json(const SessionUnits& units) {
    return written(units);
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

core::Result<SliceRecord> parse_slice(std::string_view text) {
    return parse<SliceRecord>(text);
}

core::Result<LinesRecord> parse_lines(std::string_view text) {
    return parse<LinesRecord>(text);
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

core::Result<MembershipRecord> parse_membership(std::string_view text) {
    return parse<MembershipRecord>(text, "a saved participant is damaged",
                                   "join the session again");
}

core::Result<GrantRecord> parse_grant(std::string_view text) {
    return parse<GrantRecord>(text, "a saved share link is damaged",
                              "make a new one with `session.share`");
}

core::Result<SessionProfile> parse_profile(std::string_view text) {
    return parse<SessionProfile>(
        text, "the record of when and by whom a session was used cannot be read");
}

} // namespace wakesurf::protocol
