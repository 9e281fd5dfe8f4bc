// Threads that run jobs hear when a job waits for data, and may lend its place to another job meanwhile. A
// surface that waits for bricks then occupies no thread that others need.
#pragma once

#include <utility>

namespace wakesurf::core {

/// While it lives, its thread waits for data. One within another counts as one.
class BlockingWait {
  public:
    /// Hears of a thread's waits, from that thread.
    class Listener {
      public:
        /// The thread will wait.
        virtual void blocks() = 0;
        /// Called when the thread continues.
        virtual void goes_on() = 0;

      protected:
        ~Listener() = default;
    };

    /// Registers the listener of the calling thread from now on.
    static void listen(Listener* listener) { of_thread = listener; }

    BlockingWait() : listener_(std::exchange(of_thread, nullptr)) {
        if (listener_ != nullptr)
            listener_->blocks();
    }

    ~BlockingWait() {
        if (listener_ != nullptr)
            listener_->goes_on();
        of_thread = listener_;
    }

    BlockingWait(const BlockingWait&) = delete;
    BlockingWait& operator=(const BlockingWait&) = delete;

  private:
    static inline thread_local Listener* of_thread = nullptr;
    Listener* listener_;
};

} // namespace wakesurf::core
