// What a session tells those who look at it: record changes, progress, frames. Values, not text; the methods' side
// puts them into messages.
#pragma once

#include "server/session/session_records.hpp"
#include "server/session/surface_job.hpp"

#include <cstdint>
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

using Patch = std::variant<protocol::RakeRecord,
                           protocol::SurfaceRecord,
                           protocol::BookmarkRecord,
                           protocol::AnnotationRecord,
                           DeletedRecord>;

/// How an epoch of a surface ended.
struct SurfaceOutcome {
    std::string surface;
    std::uint32_t epoch = 0;
    bool complete = false;
    std::uint32_t crc = 0;
    core::SurfaceStatistics statistics; ///< of the newest state; all zero before the first
    std::optional<core::Error> error;
};

/// Why a participant is sent away.
enum class Farewell : std::uint8_t {
    Displaced, ///< a newer connection has taken its place
    Removed    ///< by a host
};

/// Who has joined a session. Calls come on the loop's thread and must not change the session.
class Observer {
  public:
    virtual ~Observer() = default;
    virtual void
    patched(const std::string& session, std::uint64_t seq, std::span<const Patch> patches) = 0;
    virtual void progress(const std::string& surface, std::uint32_t epoch, bool final) = 0;
    virtual void done(const SurfaceOutcome& outcome) = 0;

    /// Others came, went or moved: a notification, as text.
    virtual void presence(const std::string& /*message*/) {}

    /// It is no participant any more.
    virtual void sent_away(Farewell /*why*/) {}
};

/// Who has subscribed to a surface's mesh.
class FrameSink {
  public:
    virtual ~FrameSink() = default;
    virtual void frames(std::uint32_t number, const std::shared_ptr<const SurfaceState>& state) = 0;
    /// Everything of the surface before `epoch` is out of date.
    virtual void superseded(std::uint32_t number, std::uint32_t epoch) = 0;
};

} // namespace wakesurf::server
