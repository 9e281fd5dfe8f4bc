// Turns for work that nobody waits for, a little at a time: surfaces that come back with a restarted server. All at once they
// would stand before the first edit.
#pragma once

#include "server/session/loop.hpp"

#include <cstddef>
#include <functional>
#include <memory>

namespace wakesurf::server {

/// Loop thread only. The loop outlives it.
class BuildTurns {
  public:
    /// @param at_once  so many have their turn at a time
    BuildTurns(Loop& loop, std::size_t at_once);

    /// Begins something; its turn lasts until it drops the ticket.
    using Begin = std::function<void(std::shared_ptr<void> ticket)>;

    /// Calls `begin` from the loop when its turn comes: first queued, first begun.
    void queue(Begin begin);

  private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace wakesurf::server
