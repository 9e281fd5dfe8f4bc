// What of a calculation many threads can share, and what waits for one: loops report here to a thread that wants to know.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Collects the loops that this thread starts as long as it exists; of loops within loops the outer ones. Measures work where
/// the thread is the only one of its arena.
class LoopTimes {
  public:
    struct Taken {
        double seconds;
        double tasks; ///< that may be done at the same time
    };

    LoopTimes() : before_(std::exchange(listening, this)) {}

    ~LoopTimes() { listening = before_; }

    LoopTimes(const LoopTimes&) = delete;
    LoopTimes& operator=(const LoopTimes&) = delete;

    std::span<const Taken> loops() const { return loops_; }

    /// A loop over `count` numbers that is divided into ranges of about `grain`, while it runs.
    class Loop {
      public:
        Loop(std::size_t count, std::size_t grain) : to_(std::exchange(listening, nullptr)) {
            if (to_ == nullptr)
                return;
            tasks_ = static_cast<double>((count + grain - 1) / grain);
            began_ = std::chrono::steady_clock::now();
        }

        ~Loop() {
            if (to_ == nullptr)
                return;
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began_;
            to_->loops_.push_back({taken.count(), tasks_});
            listening = to_;
        }

        Loop(const Loop&) = delete;
        Loop& operator=(const Loop&) = delete;

      private:
        LoopTimes* to_;
        double tasks_ = 0.0;
        std::chrono::steady_clock::time_point began_;
    };

  private:
    inline static thread_local LoopTimes* listening = nullptr;

    LoopTimes* before_;
    std::vector<Taken> loops_;
};

} // namespace wakesurf::core
