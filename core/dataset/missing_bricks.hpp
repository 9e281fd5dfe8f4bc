// Bricks that were found missing while an interval between two stored times was sampled: gathered from all
// threads, then fetched together.
#pragma once

#include "core/base/work_memory.hpp"
#include "core/dataset/brick_cache.hpp"
#include "core/dataset/step_nodes.hpp"

#include <mutex>
#include <optional>
#include <utility>

namespace wakesurf::core {

/// Collects what one pass over an interval misses. Thread safety: add() may come from any thread.
class MissingBricks {
  public:
    /// @param steps  what a brick is wanted of: the time-steps that are sampled together
    /// @param field  likewise, as in BrickRead
    MissingBricks(std::shared_ptr<BrickCache> cache,
                  std::vector<std::size_t> steps,
                  std::size_t field = 0)
        : cache_(std::move(cache)), steps_(std::move(steps)), field_(field) {}

    const BrickLayout& layout() const { return cache_->layout(); }

    const float* zeros() const { return cache_->zeros(); }

    BrickTable::Age age() const { return cache_->age(); }

    void add(std::span<const std::uint32_t> bricks) {
        const std::scoped_lock lock(mutex_);
        bricks_.insert(bricks_.end(), bricks.begin(), bricks.end());
    }

    /// Asks for memory of the work that samples: it is had where no brick is being read, so that the cache can
    /// give some back. All ask for the same work's.
    void want(WorkMemory& memory, std::size_t bytes) {
        const std::scoped_lock lock(mutex_);
        memory_ = &memory;
        bytes_ += bytes;
    }

    /// Asks for a brick that will be wanted soon: it is read along with what is missing, where there is room.
    /// REQUIRES: called from one thread.
    void look_ahead(std::size_t brick) {
        if (ahead_.empty() || ahead_.back() != brick)
            ahead_.push_back(static_cast<std::uint32_t>(brick));
    }

    /// Marks the first pass over an interval, which reads ahead even if nothing is missing yet.
    void begins() { begins_ = true; }

    enum class Outcome {
        None,    ///< nothing was missing
        Fetched, ///< it is there now
        TooMany, ///< they do not fit together: fewer particles should go at a time
        Failed   ///< see error()
    };

    /// Fetches what has been added since the last time, and sees to the memory that was asked for. Failed
    /// without an error: there is none.
    /// @param anyway  fetches as many as fit where they are too many
    Outcome fetch(const std::stop_token& stop, bool anyway);

    /// Returns why the last fetch failed.
    const std::optional<Error>& error() const { return error_; }

    /// The way in which items of a range continue in the next round.
    enum class Again {
        /// Begins all again, also those that are done: what all need has to be there at the same time.
        Redo,
        Restart, ///< those that are not done, from the start: what one needs has to be there at the same time
        GoOn ///< those that are not done, from where they wait
    };

    struct Nothing {
        void operator()(std::size_t, std::size_t) const {}
    };

    /// Calls `go(begin, end)` for ranges of `count` items, again for those of which some were waiting for
    /// bricks, until none is. Returns false where `go` did, or what was missing cannot be had.
    /// @param missing  null: all is there
    /// @param ahead    `ahead(begin, end)` is called where some are waiting or the interval begins, and may
    ///                 call look_ahead()
    template <class Go, class Ahead = Nothing>
    static bool in_rounds(MissingBricks* missing,
                          std::size_t count,
                          const std::stop_token& stop,
                          Again again,
                          Go&& go,
                          Ahead&& ahead = {}) {
        if (missing == nullptr)
            return go(std::size_t{0}, count);
        const int enough = again == Again::Redo ? 2 : again == Again::Restart ? 16 : most_rounds;
        int rounds = 0;
        for (std::size_t begin = 0, end = count; begin < count;) {
            if (++rounds > enough && end - begin > 1) { // what one brought the next took away
                end = begin + (end - begin) / 2;
                rounds = 1;
            }
            if (rounds > most_rounds)
                return missing->give_up();
            {
                const BrickCache::Reading reading(*missing->cache_);
                if (!go(begin, end))
                    return false;
                if (missing->begins_ || !missing->bricks_.empty())
                    ahead(begin, end);
            }
            switch (missing->fetch(stop, end - begin == 1)) {
            case Outcome::None:
                rounds = 0;
                begin = std::exchange(end, std::min(count, end + 2 * (end - begin)));
                break;
            case Outcome::Fetched:
                break;
            case Outcome::TooMany:
                end = begin + (end - begin + 1) / 2;
                rounds = 0;
                break;
            case Outcome::Failed:
                return false;
            }
        }
        return true;
    }

  private:
    /// Limits the rounds of one range. A way that needs more would lead through more bricks one after the
    /// other than grids have.
    static constexpr int most_rounds = 10'000;

    bool give_up();

    std::shared_ptr<BrickCache> cache_;
    std::vector<std::size_t> steps_;
    std::size_t field_;
    std::mutex mutex_;
    std::vector<std::uint32_t> bricks_;
    std::vector<std::uint32_t> ahead_;
    WorkMemory* memory_ = nullptr;
    std::size_t bytes_ = 0; ///< wanted of it
    bool begins_ = false;
    std::optional<Error> error_;
};

/// Collects what one thread finds missing in a sampler's view that no other thread has.
class BrickMisses {
  public:
    BrickMisses() = default;

    /// @param all  null: nothing can be missing
    explicit BrickMisses(MissingBricks* all)
        : all_(all), zeros_(all != nullptr ? all->zeros() : nullptr),
          age_(all != nullptr ? all->age() : BrickTable::Age{0}) {}

    BrickMisses(const BrickMisses& other) : BrickMisses(other.all_) {}

    BrickMisses& operator=(const BrickMisses&) = delete;

    ~BrickMisses() {
        if (!bricks_.empty())
            all_->add(bricks_);
    }

    MissingBricks* all() const { return all_; }

    BrickTable::Age age() const { return age_; }

    /// Notes a missing brick. Returns zeros to read in its place; what is made of them is thrown away.
    const float* note(std::size_t brick) const {
        missed_ = true;
        want(brick);
        return zeros_;
    }

    /// Asks for a brick for something else than what this view samples now.
    void want(std::size_t brick) const {
        if (bricks_.empty() || bricks_.back() != brick)
            bricks_.push_back(static_cast<std::uint32_t>(brick));
    }

    /// Forgets what was missing.
    void forget() const {
        missed_ = false;
        bricks_.clear();
    }

    bool any() const { return missed_; }

    /// Returns whether anything was missing since the last time.
    bool take() const { return std::exchange(missed_, false); }

  private:
    MissingBricks* all_ = nullptr;
    const float* zeros_ = nullptr;
    BrickTable::Age age_ = 0;
    mutable bool missed_ = false;
    mutable std::vector<std::uint32_t> bricks_;
};

} // namespace wakesurf::core
