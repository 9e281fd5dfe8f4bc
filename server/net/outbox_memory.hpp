// The bound on what waits to be sent to all clients together: a sixteenth of `--memory`. Each client may have
// a quarter of the remaining memory waiting, so that clients that do not read, with any number of sockets,
// never exhaust it. A minimum is always available to each.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <memory>

namespace wakesurf::server {

/// Bounds the memory of all outboxes. Loop thread only. REQUIRES: it outlives its shares.
class OutboxMemory {
  public:
    explicit OutboxMemory(const core::MemoryAccount& account);
    OutboxMemory(const OutboxMemory&) = delete;
    OutboxMemory& operator=(const OutboxMemory&) = delete;

    /// Counts what one client, or one answer, has waiting.
    class Share {
      public:
        /// @param all  null: no bound
        explicit Share(OutboxMemory* all = nullptr) : all_(all) {}

        ~Share() { shrink(bytes_); }

        Share(const Share&) = delete;
        Share& operator=(const Share&) = delete;

        /// Returns false, and changes nothing, if it does not fit.
        [[nodiscard]] bool grow(std::size_t more);
        void shrink(std::size_t less);

      private:
        OutboxMemory* all_;
        std::size_t bytes_ = 0;
    };

    /// Counts one answer until it has been sent; null if it does not fit.
    std::shared_ptr<void> hold(std::size_t bytes);

    /// Returns the sum of all shares, in bytes.
    std::size_t bytes() const { return bytes_; }

  private:
    bool fits(std::size_t own, std::size_t more) const;
    void changed();

    std::size_t most_;
    std::size_t bytes_ = 0;
    core::MemoryAccount::Share counted_; ///< follows bytes_ in steps
};

} // namespace wakesurf::server
