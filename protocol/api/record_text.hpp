// Records as the text they are kept in beyond the server's life, and back. A file may be damaged, so what is
// read is checked as if a stranger had sent it.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/annotation.hpp"
#include "protocol/api/generated/bookmark.hpp"
#include "protocol/api/generated/rake.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/api/generated/time.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

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

    bool operator==(const SessionHead&) const = default;
};

/// Returns one line of JSON. A lease is not kept.
std::string record_text(const RakeRecord& record);
std::string record_text(const SurfaceRecord& record);
std::string record_text(const BookmarkRecord& record);
std::string record_text(const AnnotationRecord& record);
std::string record_text(const ClockRecord& record);
std::string record_text(const SessionHead& head);

nlohmann::json units_json(const SessionUnits& units);

/// Read it back. Error: Corrupt, OverLimit. A number comes back with the very same bits.
core::Result<RakeRecord> parse_rake(std::string_view text);
core::Result<SurfaceRecord> parse_surface(std::string_view text);
core::Result<BookmarkRecord> parse_bookmark(std::string_view text);
core::Result<AnnotationRecord> parse_annotation(std::string_view text);
core::Result<ClockRecord> parse_clock(std::string_view text);
core::Result<SessionHead> parse_session_head(std::string_view text);

} // namespace wakesurf::protocol
