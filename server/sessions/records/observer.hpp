// Receives what a session tells its participants: record changes and progress. Values, not text; the
// methods' side puts them into messages.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/time.hpp"
#include "protocol/api/record_text.hpp"
#include "server/live/surface_events.hpp"
#include "server/sessions/records/session_records.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace wakesurf::server {

struct DeletedRecord {
    std::string_view type; ///< `rake`, `surface`, ...
    std::string id;
};

/// Holds what the session is called now, and its units.
struct SessionName {
    std::string session;
    std::string name;
    protocol::SessionUnits units{};
};

using Patch = std::variant<protocol::RakeRecord,
                           protocol::SurfaceRecord,
                           protocol::SliceRecord,
                           protocol::LinesRecord,
                           protocol::BookmarkRecord,
                           protocol::AnnotationRecord,
                           protocol::ClockRecord,
                           SessionName,
                           DeletedRecord>;

/// Says why a participant is sent away.
enum class Farewell : std::uint8_t {
    Displaced, ///< a newer connection has taken its place
    Removed,   ///< by a host
    Deleted    ///< the session is, by a host
};

/// Is shared by all observers of one event: the first to write it as text leaves the text here for the
/// others.
struct Telling {
    std::shared_ptr<const std::string> text{};
};

/// A participant who has joined a session. Calls come on the loop's thread and must not change the session.
class Observer {
  public:
    virtual ~Observer() = default;
    virtual void patched(const std::string& session,
                         std::uint64_t seq,
                         std::span<const Patch> patches,
                         Telling& telling) = 0;
    /// Is not called while a surface plays, nor of times it only passes.
    virtual void progress(const SurfaceProgress& progress, Telling& telling) = 0;
    virtual void done(const SurfaceOutcome& outcome, Telling& telling) = 0;

    /// Is called before the state that ranges further is sent.
    virtual void ranges(const SurfaceRanges& /*ranges*/, Telling& /*telling*/) {}

    /// Others came, went or moved: a notification, as text.
    virtual void presence(const std::string& /*message*/) {}

    /// It is no participant any more.
    virtual void sent_away(Farewell /*why*/) {}
};

} // namespace wakesurf::server
