// Connections take turns at writing, a few at a time. So the messages of one event to hundreds of viewers do
// not delay the next event, and go out in few writes, because all of them are queued by the time a connection
// has its turn.
#pragma once

#include "core/base/clock.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

namespace wakesurf::server {

/// Distributes turns. Loop thread only. REQUIRES: it outlives its writers.
class WriteTurns {
  public:
    class Writer {
      public:
        virtual ~Writer() = default;
        /// Writes what is queued. It may ask for a further turn.
        virtual void write_turn() = 0;
    };

    using Post = std::function<void(std::function<void()>)>;

    /// The number of writers between two posts. There are more only if the events in between took long:
    /// writing gets as much of the loop's time as they do.
    static constexpr std::size_t at_once = 16;

    /// @param post   runs a task later on the loop, after those already posted
    /// @param clock  outlives this
    WriteTurns(Post post, const core::Clock& clock) : post_(std::move(post)), clock_(clock) {}

    /// Queues a writer, in order of asking. Destroyed writers are skipped.
    void ask(std::weak_ptr<Writer> writer);

  private:
    void go_on();
    void turn();

    Post post_;
    std::deque<std::weak_ptr<Writer>> waiting_;
    const core::Clock& clock_;
    /// The time at which the first writer queued, or the last turn ended.
    std::chrono::steady_clock::time_point since_{};
    bool posted_ = false;
};

} // namespace wakesurf::server
