// Tracks what the cache holds at a time: which time-steps are resident, which are being loaded, and what
// makes room for the next. The cache's threads and callers share one window, by its mutex.
#pragma once

#include "core/base/event_count.hpp"
#include "core/base/memory_account.hpp"
#include "core/dataset/time_step_source.hpp"

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

struct StepEntry {
    std::atomic<StepState> state{StepState::Cold}; ///< status() reads it without the lock
    std::shared_ptr<const TimeStep> step;          ///< while resident
    std::weak_ptr<const TimeStep> lease;           ///< what is handed out
    std::size_t leases = 0;                        ///< handed out and not yet given back
    std::size_t waiters = 0;                       ///< acquire() calls waiting for it
    bool in_window = false;                        ///< wanted by the last prefetch()
    std::uint64_t last_use = 0;
    std::uint64_t failures = 0;
    Error error;           ///< of the last failure
    std::stop_source load; ///< of the load in flight
};

struct StepJob {
    std::size_t index = 0;
    std::stop_token stop;
    std::shared_ptr<const TimeStep> evicted; ///< freed before the load, so that both never coexist
};

/// The states of the steps, changed only by load threads; acquire() only requests and waits. A step's memory
/// counts from the moment its load is picked until it is evicted, and only unused steps are evicted: that
/// makes the budget hard.
struct StepWindow {
    /// Keeps 1/8 of the account free for others.
    static constexpr std::size_t left_free = 8;

    std::mutex mutex;
    EventCount changed; ///< a load ended
    EventCount work;    ///< something to load, or room for it
    std::vector<StepEntry> entries;
    std::deque<std::size_t> demanded;   ///< cold steps with waiting callers, oldest first
    std::deque<std::size_t> prefetched; ///< cold steps to load ahead, nearest first
    std::size_t position = 0;           ///< of the last prefetch()
    std::size_t capacity = 0; ///< time-steps the budget holds; with an account: could at most
    std::size_t smallest = 0; ///< that are always there
    std::size_t step_bytes = 0;
    std::optional<MemoryAccount> account;
    MemoryAccount::Share share; ///< of the account: `used`, at least `smallest`
    bool starved = false;       ///< the last load had to wait: there was no memory beyond `used`
    std::atomic<std::size_t> used{
        0}; ///< resident and in flight; read as `state` is, like the next two
    std::atomic<std::uint64_t> hits{0}, loads{0};
    std::size_t lent = 0; ///< entries handed out
    std::size_t held = 0; ///< by those whose acquire() waits, together
    std::size_t idle_threads = 0;
    bool closing = false;
    std::uint64_t clock = 0;    ///< order of use
    std::uint64_t progress = 0; ///< counts loads ended and leases given back

    std::shared_ptr<const TimeStep> lend(const std::shared_ptr<StepWindow>& self,
                                         std::size_t index);
    void put_back(std::size_t index);
    void demand(std::size_t index);
    void withdraw(std::size_t index);

    template <class Unwanted>
    void stop_loads(Unwanted unwanted) {
        for (StepEntry& entry : entries)
            if (entry.state == StepState::Loading && unwanted(entry))
                entry.load.request_stop();
    }

    std::size_t room() const;

    bool hungry() const { return starved && !demanded.empty(); }

    bool make_room(std::size_t leave);
    void count();
    std::vector<std::shared_ptr<const TimeStep>> reclaim_spare(std::size_t bytes);
    bool may_be_deadlocked() const;
    std::optional<std::size_t> victim(bool spare_window) const;
    std::shared_ptr<const TimeStep> evict(std::size_t index);
    std::optional<StepJob> pick();
    std::optional<StepJob> start(std::size_t index, bool spare_window);
    void finish(std::size_t index, Result<std::shared_ptr<const TimeStep>> loaded);
};

} // namespace wakesurf::core
