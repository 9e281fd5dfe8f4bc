// Bricks of time-steps in memory within a byte budget: the counterpart of a time-step cache for time-steps
// that are larger than memory. The sampler finds out which bricks are missing, asks for all of them at once,
// and continues when they are there.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/dataset/brick_source.hpp"
#include "core/dataset/brick_table.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// A brick of a time-step.
struct BrickName {
    std::size_t step;
    std::size_t brick;
    std::size_t field = 0; ///< as in BrickRead

    auto operator<=>(const BrickName&) const = default;
};

/// Bricks that are not in use make room for others, those not used for longest first.
/// Thread safety: every call may come from any thread.
class BrickCache {
    struct State;

  public:
    struct Options {
        std::size_t budget_bytes = std::size_t{4} << 30; ///< raised to smallest_budget()
        /// The account; with one the budget is smallest_budget(), taken at once, and what others leave free.
        std::optional<MemoryAccount> account{};
        /// Called from any thread, without the cache's lock, when the result of held() has changed.
        std::function<void()> changed{};
    };

    struct Status {
        std::size_t bytes = 0;      ///< of bricks and tables, those that are being read among them
        std::size_t most_bytes = 0; ///< so far
        std::size_t budget = 0;     ///< the most of them
        std::uint64_t reads = 0;    ///< bricks read, asked for and ahead
        std::uint64_t waits = 0;    ///< times that a caller had to wait for bricks
        std::uint64_t rounds = 0;   ///< of them for some that had not been requested before
    };

    /// Room for one particle's step wherever it is.
    static std::size_t smallest_budget(const BrickLayout& layout);

    /// @param source  lives longer
    BrickCache(const BrickSource& source, Options options);
    ~BrickCache();
    BrickCache(const BrickCache&) = delete;
    BrickCache& operator=(const BrickCache&) = delete;

    const BrickLayout& layout() const;

    /// Returns the bricks of a field at a time-step, as they come and go. The table is the same for all while
    /// it is in use.
    std::shared_ptr<const BrickTable> table(std::size_t step, std::size_t field = 0);

    /// Returns the values that are read in place of a missing brick.
    const float* zeros() const;

    /// Returns the age that BrickTable::use notes.
    BrickTable::Age age() const;

    /// Keeps the memory of bricks that its owner has seen unchanged. It should be short: the cache waits for
    /// it when it needs memory.
    class Reading {
      public:
        explicit Reading(BrickCache& cache);
        ~Reading();
        Reading(const Reading&) = delete;
        Reading& operator=(const Reading&) = delete;

      private:
        BrickCache& cache_;
        std::uint64_t began_;
    };

    /// Returns how many bricks the budget holds.
    std::size_t capacity() const;

    /// Returns how many bricks fetch() can bring together.
    std::size_t most_at_once() const;

    /// Waits until all are in memory; some may have gone again when it returns. REQUIRES: at most
    /// most_at_once(), and the caller holds no Reading. Error: what reading one of them reports; Cancelled
    /// when `stop` fires first.
    /// @param soon  is asked for as by prefetch(), before the wait
    Result<void> fetch(std::span<const BrickName> bricks,
                       const std::stop_token& stop,
                       std::span<const BrickName> soon = {});

    /// Asks for what is not there yet, as far as there is room that no recently used brick has, and returns
    /// at once.
    void prefetch(std::span<const BrickName> bricks);

    /// Bricks of velocity of a time-step in memory that were used at `since` or later.
    std::vector<std::uint32_t> used(std::size_t step, BrickTable::Age since) const;

    struct Held {
        std::size_t resident = 0; ///< bricks in memory
        std::size_t loading = 0;  ///< on their way
    };

    /// Returns how many bricks of the velocity are in memory, by time-step; time-steps without a brick are
    /// left out. Cost: that of a few time-steps, however many bricks there are.
    std::map<std::size_t, Held> held() const;

    Status status() const;

  private:
    std::shared_ptr<State> state_;
};

} // namespace wakesurf::core
