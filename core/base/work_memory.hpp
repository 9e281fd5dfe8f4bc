// Tracks what one piece of work takes of the account of memory. All threads of the work report an allocation
// before they make it; the first refusal ends the work.
#pragma once

#include "core/base/memory_account.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace wakesurf::core {

/// Once it is larger than the account's small(), it may be asked to end so that small work can go on.
/// Thread safety: everything may be called from any thread.
class WorkMemory {
  public:
    /// @param stop      of the work: it does not wait for memory then
    /// @param patience  how long it waits for others to give memory back
    /// @param what      the work makes, for refusals
    explicit WorkMemory(const MemoryAccount& account,
                        std::stop_token stop = {},
                        std::chrono::milliseconds patience = std::chrono::seconds(1),
                        std::string what = "this surface")
        : account_(account), stop_(std::move(stop)), patience_(patience), what_(std::move(what)),
          forward_(stop_, [this] { end_.request_stop(); }),
          share_(account.open(MemoryUse::Builds)) {}

    WorkMemory(const WorkMemory&) = delete;
    WorkMemory& operator=(const WorkMemory&) = delete;

    /// Takes so many bytes more. Returns false where there is no memory: the work should end, see refusal().
    /// The account is asked for large parts at a time; a call in between costs some 5 ns.
    bool grow(std::size_t bytes);

    /// Takes so many bytes more if they are free: no holder of others is asked, and nothing is refused.
    bool grow_within_free(std::size_t bytes);

    /// Sees to it that so many bytes more are there to be taken. Returns false as grow() does.
    bool make_room(std::size_t bytes) { return reserve(taken_ + std::min(bytes, most)); }

    /// Releases so many bytes.
    void shrink(std::size_t bytes) { taken_ -= bytes; }

    /// Makes the total so many bytes. Returns false as grow() does.
    bool grow_to(std::size_t bytes);

    /// Returns the bytes that it takes now.
    std::size_t bytes() const { return taken_; }

    /// Says whether memory was refused once.
    bool exhausted() const { return exhausted_; }

    /// Returns why the work ended, after grow() returned false: OverLimit where there was no memory,
    /// Cancelled where it was stopped meanwhile.
    Error refusal() const;

  private:
    /// Sums of so many bytes do not wrap round.
    static constexpr std::size_t most = std::size_t{1} << 50;

    bool reserve(std::size_t bytes);
    std::size_t ahead_of(std::size_t bytes) const;
    std::size_t left_beside(std::size_t bytes) const;
    void give_way_from_now_on();

    MemoryAccount account_;
    std::stop_token stop_;
    std::stop_source end_; ///< fires with stop_, and when it has to give way
    std::chrono::milliseconds patience_;
    std::string what_;
    std::stop_callback<std::function<void()>> forward_;
    std::atomic<std::size_t> taken_{0};
    std::atomic<std::size_t> reserved_{0};
    std::atomic<bool> exhausted_{false};
    std::atomic<std::size_t> wanted_{0}; ///< when it was refused
    std::atomic<bool> gives_way_{false}; ///< it has been asked to
    std::mutex mutex_;                   ///< guards share_
    MemoryAccount::Share share_;
    std::shared_ptr<void> ticket_; ///< asked through it, once it is large
};

} // namespace wakesurf::core
