// Surfaces release memory when others need it: first the updates that only clients behind the newest would
// read, then whole surfaces without viewers, which are suspended as parameters until a client asks for them.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/base/loop.hpp"
#include "server/live/live_surface.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace wakesurf::server {

/// Releases memory of surfaces. Loop thread only; the account asks from any thread.
class MemoryReclaim {
  public:
    using Surfaces = std::function<std::vector<std::shared_ptr<LiveSurface>>()>;

    /// @param surfaces  returns all surfaces; called from the loop
    MemoryReclaim(Loop& loop, const core::MemoryAccount& account, Surfaces surfaces);
    ~MemoryReclaim();
    MemoryReclaim(const MemoryReclaim&) = delete;
    MemoryReclaim& operator=(const MemoryReclaim&) = delete;

  private:
    struct State;
    std::shared_ptr<State> state_;
    std::shared_ptr<void> ticket_; ///< the registration with the account
};

} // namespace wakesurf::server
