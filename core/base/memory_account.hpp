// The one account of a process's memory: code that takes much opens a share and grows it before it allocates.
// If it does not fit, holders of reproducible data are asked to release some, in the order of
// `ReclaimOrder`, or it is refused.
#pragma once

#include "core/base/result.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace wakesurf::core {

/// Names the purposes of memory.
enum class MemoryUse {
    TimeSteps,
    Meshes,    ///< grids of datasets, what finds cells in them, obstacles
    Builds,    ///< surfaces while they are computed and encoded
    Surfaces,  ///< what a surface that is shown keeps
    Rings,     ///< encoded updates, until the last reader has them
    Histories, ///< checkpoints of moving surfaces, fields of level surfaces
    Downloads,
    Importers, ///< other processes
    Records,   ///< of sessions, and what undo needs of them
    Messages,  ///< that wait for clients to take them
    Other,     ///< what the process was seen to take beyond its shares
};
inline constexpr std::size_t memory_uses = 11;

/// Returns the use's name in metrics and statistics: "timeSteps", "meshes", ...
std::string_view name_of(MemoryUse use);

/// Orders the holders that are asked to release memory: the cheapest to reproduce comes first.
enum class ReclaimOrder {
    SpareHeap, ///< what the allocator keeps of memory that was freed
    Downloads, ///< finished files, cached for the next request
    Histories, ///< checkpoints that are not being played, fields that no level surface uses
    TimeSteps, ///< unused ones beyond the smallest window
    Surfaces, ///< old updates that only slow clients would read, then whole surfaces without viewers
    /// Stops the build that has exceeded small() for the longest; only for requests up to small(), one at a
    /// time.
    Builds,
};

/// The account. Thread-safe; a Share is for one thread at a time. Copies are the same account.
class MemoryAccount {
    struct State;
    struct Holder;

  public:
    /// @param budget  bytes of all shares together
    explicit MemoryAccount(std::size_t budget);

    /// Counts what the process holds beyond its shares as `Other`, measured again whenever another 1/256 of
    /// the budget has been taken; never less than it is now, which is the program itself. REQUIRES: no other
    /// thread uses the account yet.
    /// @param resident  bytes of the process, without importers; called from any thread, also from several at
    ///                  a time
    void watch(std::function<std::size_t()> resident) const;

    /// Measures now.
    void measure() const;

    /// Returns the part of the budget reserved for small work: a share that grows beyond small() leaves that
    /// much free, so that small work can run beside work that takes all there is.
    std::size_t small() const { return small_of(budget()); }

    /// Returns the bytes that large work leaves to small work.
    std::size_t reserved_for_small() const { return budget() / 8; }

    /// A part of the account, from open() until its end.
    class Share {
      public:
        Share() = default; ///< of no account: everything fits
        ~Share();
        Share(Share&& other) noexcept;
        Share& operator=(Share&& other) noexcept;

        /// Returns false, and leaves the share as it was, if it does not fit even after others were asked to
        /// release memory. It does not wait. Cost where it fits: 50 ns.
        bool grow_to(std::size_t bytes);

        /// Tries like `grow_to`, but waits up to `patience`. A share up to small() may end large builds. Do
        /// not call it on a thread that reclaims memory.
        /// @param leave  so many bytes stay free
        bool grow_to(std::size_t bytes,
                     const std::stop_token& stop,
                     std::chrono::milliseconds patience,
                     std::size_t leave = 0);

        /// Grows like grow_to() within free memory: no holder is asked to release any.
        bool grow_within_free(std::size_t bytes, std::size_t leave = 0);

        /// Shrinks the share; does nothing if it is smaller already.
        void shrink_to(std::size_t bytes);

        /// Records what has been taken already, whether it fits or not.
        void set(std::size_t bytes);

        /// Takes over all bytes of another share of the same account.
        void join(Share&& other);

        /// Returns the bytes that the share has taken.
        std::size_t bytes() const { return bytes_; }

      private:
        friend class MemoryAccount;

        Share(std::shared_ptr<State> state, MemoryUse use) : state_(std::move(state)), use_(use) {}

        std::shared_ptr<State> state_;
        MemoryUse use_ = MemoryUse::Other;
        std::size_t bytes_ = 0;
    };

    /// A share without memory yet, which counts as `use`.
    Share open(MemoryUse use) const;

    /// `reclaim` is called with how many bytes are wanted, on the thread that wants them, and not from two
    /// threads at once. Other calls of the account do not wait for it. It shrinks its shares at once, or sees
    /// to it on another thread, and must not grow any. Until the ticket is dropped, which waits for a call
    /// under way.
    [[nodiscard]] std::shared_ptr<void>
    on_need(ReclaimOrder order, std::function<void(std::size_t wanted)> reclaim) const;

    /// Bytes there may be in all.
    std::size_t budget() const;
    /// Bytes that all shares have taken.
    std::size_t used() const;
    /// Returns the bytes that all shares of one use have taken.
    std::size_t used(MemoryUse use) const;
    std::size_t free() const; ///< 0 where more is taken than there may be

    /// Returns how often something did not fit.
    std::size_t refused() const;

    /// Asks others, in their order, until so many bytes are free or all have been asked.
    void make_room(std::size_t bytes) const;

    /// Returns an OverLimit error with a message for people.
    Error refusal(std::string_view what, std::size_t bytes) const;

    /// Returns the error of work that ended so that small work can go on.
    Error gave_way(std::string_view what, std::size_t bytes) const;

  private:
    static constexpr std::size_t small_of(std::size_t budget) { return budget / 32; }

    std::shared_ptr<State> state_;
};

} // namespace wakesurf::core
