// The one thread of all sessions, as they see it: a queue of tasks and a timer. Behind it is the network's
// io_context, or a test's own loop.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace wakesurf::server {

class Loop {
  public:
    virtual ~Loop() = default;

    /// Runs `task` on the loop's thread, in order of posting. Callable from any thread.
    virtual void post(std::function<void()> task) = 0;

    /// Runs `task` once after `delay` unless the ticket is dropped first. Loop thread only.
    [[nodiscard]] virtual std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                                      std::function<void()> task) = 0;
};

} // namespace wakesurf::server
