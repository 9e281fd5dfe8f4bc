// Tells whether a session is in use: by a connected client, a reader of a surface, an unanswered call, wait
// or download, or a call a moment ago. A session that is not in use neither plays nor computes, and
// releases its memory.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/loop.hpp"

#include <chrono>
#include <functional>
#include <memory>

namespace wakesurf::server {

/// Loop thread only. Costs a timer while the session is in use, and nothing afterwards.
class Attendance {
  public:
    static constexpr std::chrono::seconds nobody{20};    ///< without a client: then it is empty
    static constexpr std::chrono::seconds look_every{4}; ///< found out so much later at most

    struct Events {
        std::function<bool()> somebody; ///< says whether a client is seen just now
        std::function<void()> empty;    ///< called once it is empty
        std::function<void()> back;     ///< called when a client comes after that
    };

    Attendance(Loop& loop, const core::Clock& clock, Events events)
        : loop_(loop), clock_(clock), events_(std::move(events)) {}

    Attendance(const Attendance&) = delete;
    Attendance& operator=(const Attendance&) = delete;

    /// Notes that a client asks for something, or has just gone.
    void seen();

    /// Returns a token: the session is in use for as long as a caller holds it, while it waits for an
    /// answer.
    std::shared_ptr<void> stay();

    /// Ends it: no client comes any more.
    void end() { look_.reset(); }

  private:
    void look();
    void look_later();

    Loop& loop_;
    const core::Clock& clock_;
    Events events_;
    std::shared_ptr<void> look_; ///< the timer; null: no client is there
    std::weak_ptr<void> stay_;   ///< shared by all tokens of stay()
    std::chrono::steady_clock::time_point seen_{};
    bool empty_ = false;
};

} // namespace wakesurf::server
