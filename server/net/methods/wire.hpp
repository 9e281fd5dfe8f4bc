// The sending half of a WebSocket, as the methods' side sees it.
#pragma once

#include "server/live/frame_cursor.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Why a connection ends, as the code of its close frame. Coming back by oneself would not help.
enum class Goodbye : std::uint16_t {
    Displaced = 4001, ///< a newer connection has taken its participant's place
    Removed = 4002,   ///< a host sent the participant away
    LinkEnded = 4003, ///< the share link expired or was taken back
    LoggedOut = 4004  ///< the browser it came from has logged out
};

/// Loop thread only. Nothing here blocks or calls back.
class Wire {
  public:
    virtual ~Wire() = default;
    virtual void send(std::string message) = 0;

    /// Sends the same text to many.
    virtual void send_shared(const std::shared_ptr<const std::string>& message) { send(*message); }

    /// Says whether a further surface may be followed.
    virtual bool may_follow(std::uint32_t surface) = 0;

    /// Sends a surface's updates from where the cursor stands, until unfollow() or the ring's end; one cursor
    /// a surface.
    virtual void follow(FrameCursor cursor) = 0;

    /// False when the surface was not followed.
    virtual bool unfollow(std::uint32_t surface) = 0;

    /// Is told that the client has folded update `seq`; without an epoch, of the newest. False when the
    /// surface is not followed.
    virtual bool
    acknowledge(std::uint32_t surface, std::optional<std::uint32_t> epoch, std::uint32_t seq) = 0;

    /// Ends the connection soon; `reason` has at most 120 bytes. The client is gone after this call has
    /// returned.
    virtual void close(Goodbye goodbye, const std::string& reason) = 0;
};

} // namespace wakesurf::server
