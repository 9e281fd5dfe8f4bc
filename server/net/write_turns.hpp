// Connections that have something to write take turns, a few at a time: what one event tells hundreds of viewers neither holds up the
// next event nor goes out in more writes than it must, because all of it is there by the time a connection has its turn.
#pragma once

#include "core/base/clock.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

namespace wakesurf::server {

/// Loop thread only. Outlives those who ask for turns.
class WriteTurns {
  public:
    class Writer {
      public:
        virtual ~Writer() = default;
        /// Writes what there is. It may ask for a further turn.
        virtual void write_turn() = 0;
    };

    using Post = std::function<void(std::function<void()>)>;

    /// Between two posts so many writers have a turn, more only where the events in between took long: writing gets as much of the
    /// loop's time as they do.
    static constexpr std::size_t at_once = 16;

    /// @param post  runs a task later on the loop, after what is there already
    /// @param clock  outlives it
    WriteTurns(Post post, const core::Clock& clock) : post_(std::move(post)), clock_(clock) {}

    /// In order of asking. Who has gone meanwhile is left out.
    void ask(std::weak_ptr<Writer> writer);

  private:
    void go_on();
    void turn();

    Post post_;
    std::deque<std::weak_ptr<Writer>> waiting_;
    const core::Clock& clock_;
    std::chrono::steady_clock::time_point
        since_{}; ///< when somebody began to wait, or the last turn ended
    bool posted_ = false;
};

} // namespace wakesurf::server
