#include "protocol/api/record_text.hpp"

#include "core/surface/rake.hpp"
#include "protocol/api/base/json_table.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/utc_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

template <>
inline constexpr auto table_of<MembershipRecord> = std::tuple(
    needed("name", &MembershipRecord::name),
    needed("colour", &MembershipRecord::colour),
    needed("role", &MembershipRecord::role),
    needed("grant", &MembershipRecord::grant),
    needed("sha256", &MembershipRecord::digest),
    newer("roleSet",
          &MembershipRecord::role_set), // before, only those were kept whose role was set
    some("left", &MembershipRecord::left),
    some("formerSha256", &MembershipRecord::former));

template <>
inline constexpr auto table_of<GrantRecord> = std::tuple(needed("role", &GrantRecord::role),
                                                         needed("sha256", &GrantRecord::digest),
                                                         some("expires", &GrantRecord::expires),
                                                         some("maker", &GrantRecord::maker),
                                                         some("lineage", &GrantRecord::lineage),
                                                         some("lowered", &GrantRecord::lowered),
                                                         some("copier", &GrantRecord::copier));

template <>
inline constexpr auto
    table_of<SessionPerson> = std::tuple(needed("participant", &SessionPerson::participant),
                                         needed("name", &SessionPerson::name),
                                         needed("colour", &SessionPerson::colour));

template <>
inline constexpr auto
    table_of<SessionProfile> = std::tuple(some("created", &SessionProfile::created),
                                          needed("lastUsed", &SessionProfile::last_used),
                                          needed("edited", &SessionProfile::edited),
                                          needed("onPurpose", &SessionProfile::on_purpose),
                                          needed("people", &SessionProfile::people),
                                          some("deleted", &SessionProfile::deleted),
                                          some("data", &SessionProfile::data),
                                          some("copyOf", &SessionProfile::copy_of),
                                          some("copyName", &SessionProfile::copy_name));

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

template <class Record>
core::Result<Record> parse(std::string_view text, const char* damaged, const char* hint = "") {
    return parse_json(text, record_limits)
        .and_then(parse_table<Record, json>)
        .map_error([&](const core::Error&) {
            return core::Error{core::Error::Code::Corrupt, damaged, hint};
        });
}

} // namespace

template <class Record>
std::string record_text(const Record& record) {
    if constexpr (HasTable<Record>)
        return json_text(written<json>(record));
    else
        return json_text(kept_json(record));
}

template std::string record_text(const RakeRecord&);
template std::string record_text(const SurfaceRecord&);
template std::string record_text(const BookmarkRecord&);
template std::string record_text(const AnnotationRecord&);
template std::string record_text(const ClockRecord&);
template std::string record_text(const MembershipRecord&);
template std::string record_text(const GrantRecord&);
template std::string record_text(const SessionProfile&);

template <>
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

core::Result<MembershipRecord> parse_membership(std::string_view text) {
    return parse<MembershipRecord>(text, "a saved participant is damaged",
                                   "join the session again");
}

core::Result<GrantRecord> parse_grant(std::string_view text) {
    return parse<GrantRecord>(text, "a saved share link is damaged",
                              "make a new one with `session.share`");
}

core::Result<SessionProfile> parse_profile(std::string_view text) {
    const char* const damaged = "the record of when and by whom a session was used cannot be read";
    auto profile = parse<SessionProfile>(text, damaged);
    if (!profile)
        return profile;
    const auto is_time = [](std::int64_t second) {
        return second >= 0 && second <= last_utc_second;
    };
    if (!is_time(profile->last_used) || !is_time(profile->created.value_or(0)) ||
        !is_time(profile->deleted.value_or(0)) || profile->people.size() > most_session_people ||
        profile->data.size() > most_session_datasets)
        return core::fail(core::Error::Code::Corrupt, damaged);
    return profile;
}

} // namespace wakesurf::protocol
