// The clock all surfaces of a session are shown at: simulation time that runs, stands or has never been set.
// It is a record like others, told when it is changed; its ticks are not, clients carry the time on by
// themselves.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "protocol/api/generated/time.hpp"
#include "server/base/loop.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace wakesurf::server {

/// Loop thread only.
class SessionClock {
  public:
    struct Events {
        /// Called after the record has changed: a participant acted, or the end was reached.
        std::function<void()> changed;
        /// Called after every change of the time, and 30 times a second while it runs.
        std::function<void(bool jumped)> moved;
    };

    SessionClock(Loop& loop, const core::Clock& wall, Events events)
        : loop_(loop), wall_(wall), events_(std::move(events)) {}

    SessionClock(const SessionClock&) = delete;
    SessionClock& operator=(const SessionClock&) = delete;

    /// Jumps to a time; goes on running if it runs. Nothing: stops, and forgets the time.
    void set(std::optional<double> time);

    /// Runs on from where it stands, or from the start where that is outside of what is played or at its
    /// end.
    /// @param natural  what is played unless it was said: now or in an earlier call
    /// Error: InvalidArgument when it was never said, or the ends are not in order.
    core::Result<void> play(const protocol::PlaySetting& setting,
                            std::optional<std::array<double, 2>> natural);

    void pause();

    /// Restores the record as it was kept, stopped, without notifying clients.
    void restore(const protocol::ClockRecord& kept);

    /// Simulation time now; nothing: never set.
    std::optional<double> time() const;

    bool playing() const { return record_.playing; }

    /// Returns the record as of now.
    protocol::ClockRecord record() const;

  private:
    void start_from(double time);
    void tick();
    void told();

    Loop& loop_;
    const core::Clock& wall_;
    Events events_;
    protocol::ClockRecord record_; ///< its time is that at `since_`
    std::chrono::steady_clock::time_point since_;
    double last_ = 0.0; ///< told by moved()
    std::shared_ptr<void> ticker_;
};

} // namespace wakesurf::server
