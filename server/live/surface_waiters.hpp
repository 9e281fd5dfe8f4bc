// The callers that wait until a surface is complete: unanswered surface.wait calls.
#pragma once

#include "server/base/loop.hpp"
#include "server/live/surface_events.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace wakesurf::server {

/// Holds the waiters. Loop thread only. Owned by shared_ptr, for its timers.
class SurfaceWaiters : public std::enable_shared_from_this<SurfaceWaiters> {
  public:
    using Waiter = std::function<void(core::Result<SurfaceOutcome>)>;

    explicit SurfaceWaiters(Loop& loop) : loop_(loop) {}

    /// Adds a waiter. `give_up` is called after `patience` and returns the state at that time. Error, by the
    /// waiter: OverLimit. Returns a ticket for forget(); 0 once the waiter has been called.
    /// @param checked  waits for the checks too: SurfaceOutcome::checks_pending
    std::uint64_t add(std::uint32_t epoch,
                      std::chrono::milliseconds patience,
                      std::function<SurfaceOutcome()> give_up,
                      Waiter waiter,
                      bool checked = false);

    /// Answers all that wait for this epoch or an earlier one.
    void answer(std::uint32_t epoch, const core::Result<SurfaceOutcome>& outcome);

    /// Releases a waiter without calling it.
    void forget(std::uint64_t ticket);

    bool empty() const { return waiting_.empty(); }

  private:
    struct Waiting {
        std::uint64_t id;
        std::uint32_t epoch;
        Waiter waiter;
        std::function<SurfaceOutcome()> give_up;
        std::shared_ptr<void> timer;
        bool checked;
    };

    void give_up(std::uint64_t id);

    Loop& loop_;
    std::vector<Waiting> waiting_;
    std::uint64_t next_ = 1;
};

} // namespace wakesurf::server
