// The sending half of a WebSocket, as the methods' side sees it.
#pragma once

#include "server/session/surface_job.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Loop thread only. Nothing here blocks or calls back.
class Wire {
  public:
    virtual ~Wire() = default;
    virtual void send(std::string message) = 0;
    virtual void send(std::uint32_t surface, const std::shared_ptr<const SurfaceState>& state) = 0;
    /// Frames of `surface` that belong to an epoch before `epoch` need not be sent any more.
    virtual void drop_frames(std::uint32_t surface, std::uint32_t epoch) = 0;
};

} // namespace wakesurf::server
