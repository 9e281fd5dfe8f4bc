// The sliding window: time-steps in memory within a byte budget, with prefetch in the direction of play.
// Everything that samples stored data gets its time-steps here. States a client can see: resident, loading,
// cold.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/dataset/time_step_source.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

class BrickCache;

/// Keeps time-steps in memory within a budget. Thread safety: every call may come from any thread. A
/// time-step handed out stays valid as long as its holder keeps it; it counts against the budget until then.
class TimeStepCache {
  public:
    /// The size of the cache, and how it loads.
    struct Options {
        std::size_t budget_bytes = std::size_t{4} << 30; ///< raised to smallest_budget() if smaller
        std::size_t load_threads = 1; ///< time-steps that are read at the same time
        /// The account; with one the budget is smallest_budget(), which is taken at once, and whatever others
        /// leave free; the latter is released when they need it.
        std::optional<MemoryAccount> account{};
        bool by_brick = false; ///< where the source has bricks, also if four time-steps fit
    };

    /// The content of the cache, for people.
    struct Status {
        std::vector<StepHeld> steps; ///< one a time-step of the series
        std::size_t step_bytes = 0;  ///< of a time-step that is all there
        std::size_t bytes = 0;       ///< accounted: resident, handed out and in flight
        std::size_t budget = 0;      ///< what it may take; with an account: as it stands now
        std::uint64_t hits = 0;      ///< acquire() calls that found their time-step resident
        std::uint64_t loads = 0;     ///< time-steps read, demanded and ahead
    };

    /// Returns the bytes for one caller that interpolates by cubics in time: 4 time-steps, or all if there
    /// are fewer, or some bricks if the source has bricks.
    static std::size_t smallest_budget(const TimeStepSource& source);

    /// Four time-steps, or all where they are fewer.
    static std::size_t smallest_window(const TimeStepSource& source);

    /// Returns whether time-steps are had brick by brick, as they are where the source has bricks and four
    /// time-steps do not fit.
    static bool pages(const TimeStepSource& source, std::size_t budget_bytes);

    /// Returns the bytes that an account of so many bytes leaves to time-steps at most.
    static std::size_t room_in(std::size_t account_bytes) { return account_bytes / 2; }

    /// Loads nothing yet.
    TimeStepCache(std::shared_ptr<const TimeStepSource> source, Options options);
    ~TimeStepCache();
    TimeStepCache(const TimeStepCache&) = delete;
    TimeStepCache& operator=(const TimeStepCache&) = delete;

    /// Returns the source of the time-steps.
    const TimeStepSource& source() const;

    /// Returns the cache of bricks if the source has bricks and four time-steps do not fit the budget.
    /// Time-steps are then handed out at once, and the sampler asks for missing bricks. Null if time-steps
    /// are loaded whole.
    const std::shared_ptr<BrickCache>& bricks() const;

    /// Returns the time-step, loaded if it is not resident; two callers of one cold time-step cause one load.
    /// Blocks. A caller may own three time-steps while it acquires a fourth; while time-steps in use fill the
    /// budget, it waits until one is released. Error: that of the source; Cancelled if `stop` fires first;
    /// OverLimit if the waiting callers may hold everything between them (after 0.3 s), or nothing is
    /// released for 30 s: release yours and try again. Cost of a resident time-step: about 0.1 microseconds.
    /// @param held  how many the caller owns at most: the fewer, the less often it is refused needlessly
    Result<std::shared_ptr<const TimeStep>>
    acquire(std::size_t index, std::stop_token stop = {}, std::size_t held = 3);

    /// Asks for the time-steps after `index` in the direction of play (+1 or -1), nearest first, as many as
    /// fit the budget without evicting `index` itself. Returns at once.
    /// @param behind  how many time-steps before `index` (against the direction) are needed again and again,
    ///                and stay too
    void prefetch(std::size_t index, int direction, std::size_t behind = 0);

    /// Returns a snapshot without waiting; what changes meanwhile may be in one of the numbers and not yet in
    /// another.
    Status status() const;

    /// Sets a listener, called (from any thread, without the cache's lock) whenever the memory of a step
    /// changes. Returns when the previous listener is not running any more; a listener must not set another
    /// one.
    void on_change(std::function<void()> listener);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::core
