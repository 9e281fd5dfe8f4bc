// The sending half of a WebSocket, as the methods' side sees it.
#pragma once

#include "server/session/surface_job.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Why a connection ends, as the code of its close frame. Coming back by oneself would not help.
enum class Goodbye : std::uint16_t {
    Displaced = 4001, ///< a newer connection has taken its participant's place
    Removed = 4002,   ///< a host sent the participant away
    LinkEnded = 4003  ///< the share link expired or was taken back
};

/// Loop thread only. Nothing here blocks or calls back.
class Wire {
  public:
    virtual ~Wire() = default;
    virtual void send(std::string message) = 0;
    virtual void send(std::uint32_t surface, const std::shared_ptr<const SurfaceState>& state) = 0;
    /// Frames of `surface` that belong to an epoch before `epoch` need not be sent any more.
    virtual void drop_frames(std::uint32_t surface, std::uint32_t epoch) = 0;
    /// Ends the connection soon; `reason` has at most 120 bytes. The client is gone after this call has returned.
    virtual void close(Goodbye goodbye, const std::string& reason) = 0;
};

} // namespace wakesurf::server
