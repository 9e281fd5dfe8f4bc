// What surfaces give back when others need memory: first the updates that only those who have fallen behind would read, then whole
// surfaces no one looks at, which rest as parameters until somebody does.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/service/base/loop.hpp"
#include "server/service/live/live_surface.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace wakesurf::server {

/// Loop thread only; it is asked from any thread.
class GivingBack {
  public:
    using Surfaces = std::function<std::vector<std::shared_ptr<LiveSurface>>()>;

    /// @param surfaces  all there are; called from the loop
    GivingBack(Loop& loop, const core::MemoryAccount& account, Surfaces surfaces);
    ~GivingBack();
    GivingBack(const GivingBack&) = delete;
    GivingBack& operator=(const GivingBack&) = delete;

  private:
    struct State;
    std::shared_ptr<State> state_;
    std::shared_ptr<void> ticket_; ///< asked through it
};

} // namespace wakesurf::server
