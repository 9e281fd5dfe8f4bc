// The number of imports at a time, and the memory for each: an equal part of the total. One that does not fit
// into its part runs again alone, with all of it.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>

namespace wakesurf::server {

/// Bounds concurrent imports. Thread-safe.
class ImportLanes {
  public:
    explicit ImportLanes(std::size_t lanes) : lanes_(lanes) {}

    ImportLanes(const ImportLanes&) = delete;
    ImportLanes& operator=(const ImportLanes&) = delete;

    std::size_t lanes() const { return lanes_; }

    /// Holds a slot, or all of them, until destroyed.
    class Taken {
      public:
        Taken(ImportLanes& of, std::size_t lanes) : of_(of), lanes_(lanes) {}

        ~Taken() { of_.leave(lanes_); }

        Taken(const Taken&) = delete;
        Taken& operator=(const Taken&) = delete;

      private:
        ImportLanes& of_;
        std::size_t lanes_;
    };

    /// Waits for a slot: imports that want all slots go first. It stops waiting when `stop` fires.
    Taken one(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        left_.wait(lock, stop, [this] { return taken_ < lanes_ && alone_ == 0; });
        ++taken_;
        return {*this, 1};
    }

    Taken all(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        ++alone_;
        left_.wait(lock, stop, [this] { return taken_ == 0; });
        --alone_;
        taken_ += lanes_;
        return {*this, lanes_};
    }

  private:
    void leave(std::size_t lanes) {
        {
            const std::scoped_lock lock(mutex_);
            taken_ -= lanes;
        }
        left_.notify_all();
    }

    const std::size_t lanes_;
    std::mutex mutex_;
    std::condition_variable_any left_;
    std::size_t taken_ = 0;
    std::size_t alone_ = 0; ///< waiting for all slots
};

} // namespace wakesurf::server
