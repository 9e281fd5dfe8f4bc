// Shares memory for stepping back between the moving surfaces of a server. Histories that are not in use
// make room for those that are, so that all together never exceed one budget.
#pragma once

#include "core/base/memory_account.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace wakesurf::server {

/// Thread safety: everything may be called from any thread.
class HistoryBudget {
    struct State;
    struct Entry;

  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param total    bytes of all histories together
    /// @param each     bytes of one at most
    /// @param account  what they take is counted there, and given back to others that need it; null: they
    /// are not counted. Outlives this
    HistoryBudget(std::size_t total,
                  std::size_t each,
                  const core::MemoryAccount* account = nullptr);

    /// One surface's history, which is counted while this lives.
    class Permit {
      public:
        /// Makes the history fit into so many bytes, 0: forgets it; returns what it takes now. Called while
        /// this history is not in use, on the thread that needs room. Must not call the budget.
        using GiveWay = std::function<std::size_t(std::size_t bytes)>;

        Permit(const HistoryBudget& budget, GiveWay give_way);
        ~Permit();
        Permit(const Permit&) = delete;
        Permit& operator=(const Permit&) = delete;

        /// The history is in use until end(): no other thread touches it. Returns the bytes it may take:
        /// none where there is no memory, the surface is then stepped from its beginning. Those not used for
        /// `limits::history_rest` go first if there is no room, then all are made smaller.
        std::size_t begin(Time now);

        /// @param bytes  that it takes now
        void end(std::size_t bytes);

        /// Forgets the history. REQUIRES: not in use.
        void clear();

      private:
        std::shared_ptr<State> state_;
        std::unique_ptr<Entry> entry_;
    };

    /// Returns the bytes that idle histories take and those in use may take.
    std::size_t bytes() const;

  private:
    std::shared_ptr<State> state_;
    std::shared_ptr<void> asked_; ///< by others
};

} // namespace wakesurf::server
