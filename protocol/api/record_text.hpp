// Records as the text they are kept in beyond the server's life, and back. A file may be damaged, so what is
// read is checked as if a stranger had sent it.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/annotation.hpp"
#include "protocol/api/generated/bookmark.hpp"
#include "protocol/api/generated/lines.hpp"
#include "protocol/api/generated/rake.hpp"
#include "protocol/api/generated/slice.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/api/generated/time.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Holds the units that people of a session have typed; an empty one is as the dataset says.
struct SessionUnits {
    std::string length;
    std::string time;

    bool empty() const { return length.empty() && time.empty(); }

    bool operator==(const SessionUnits&) const = default;
};

/// Holds what a session is besides its records.
struct SessionHead {
    std::string name;
    std::uint64_t seq = 0;
    std::uint64_t next_rake = 1; ///< numbers of ids given next; none is given twice
    std::uint64_t next_surface = 1;
    std::uint64_t next_bookmark = 1;
    std::uint64_t next_annotation = 1;
    SessionUnits units{};
    std::uint64_t next_slice = 1;
    std::uint64_t next_lines = 1;

    bool operator==(const SessionHead&) const = default;
};

/// Holds a membership of a session: of the resume token only the digest.
struct MembershipRecord {
    std::string name;
    std::string colour;
    std::string role;
    std::string grant;                  ///< share link it came by, or empty
    std::string digest;                 ///< of the resume token, 64 hexadecimal digits
    bool role_set = true;               ///< by a host, and so not the link's
    std::optional<std::int64_t> left{}; ///< seconds since 1970; nothing: was connected
    std::string former{};               ///< digest of the token before, or empty

    bool operator==(const MembershipRecord&) const = default;
};

/// Holds a share link: never its key.
struct GrantRecord {
    std::string role;
    std::string digest;                         ///< SHA-256 of the key, 64 hexadecimal digits
    std::optional<std::int64_t> expires;        ///< seconds since 1970
    std::string maker;                          ///< name of who made it; empty: a script
    std::vector<std::string> lineage;           ///< links it was made by, the first one first
    std::map<std::string, std::string> lowered; ///< participant -> lesser role that a host set
    std::string copier = {}; ///< link by which its session was copied; empty: no copy

    bool operator==(const GrantRecord&) const = default;
};

/// Names a participant of a session, also after the membership has ended.
struct SessionPerson {
    std::string participant;
    std::string name;
    std::string colour; ///< #rrggbb

    bool operator==(const SessionPerson&) const = default;
};

/// Holds what a list of sessions tells of one besides its records. Times are seconds since 1970.
struct SessionProfile {
    std::optional<std::int64_t> created; ///< nothing: kept by a wakesurf that did not note it
    std::int64_t last_used = 0;
    bool edited = false;                       ///< beyond the page's default scene
    bool on_purpose = false;                   ///< it was named, shared, copied or imported
    std::vector<SessionPerson> people;         ///< who came last comes first
    std::optional<std::int64_t> deleted;       ///< in the trash since then
    std::map<std::string, std::string> data{}; ///< by dataset, which values its surfaces were of
    std::string copy_of = {};   ///< id of the session that it is a copy of; empty: none
    std::string copy_name = {}; ///< that this one had then

    bool operator==(const SessionProfile&) const = default;
};

/// Bounds how many people are remembered.
inline constexpr std::size_t most_session_people = 8;

/// Bounds of how many datasets the values are remembered.
inline constexpr std::size_t most_session_datasets = 32;

/// Returns one line of JSON. A lease is not kept.
template <class Record>
std::string record_text(const Record& record);

nlohmann::json units_json(const SessionUnits& units);

/// Read it back. Error: Corrupt, OverLimit. A number comes back with the very same bits.
core::Result<RakeRecord> parse_rake(std::string_view text);
core::Result<SurfaceRecord> parse_surface(std::string_view text);
core::Result<SliceRecord> parse_slice(std::string_view text);
core::Result<LinesRecord> parse_lines(std::string_view text);
core::Result<BookmarkRecord> parse_bookmark(std::string_view text);
core::Result<AnnotationRecord> parse_annotation(std::string_view text);
core::Result<ClockRecord> parse_clock(std::string_view text);
core::Result<SessionHead> parse_session_head(std::string_view text);
core::Result<MembershipRecord> parse_membership(std::string_view text);
core::Result<GrantRecord> parse_grant(std::string_view text);
core::Result<SessionProfile> parse_profile(std::string_view text);

} // namespace wakesurf::protocol
