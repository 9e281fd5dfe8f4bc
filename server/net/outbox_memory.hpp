// What waits to be sent to all clients together: at most a sixteenth of `--memory`. The less of it is left, the less each may have waiting
// (a quarter of what is left), so that those who do not read, however many sockets they have, never take what others need. A little
// is always for each.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <memory>

namespace wakesurf::server {

/// Loop thread only. Outlives its shares.
class OutboxMemory {
  public:
    explicit OutboxMemory(const core::MemoryAccount& account);
    OutboxMemory(const OutboxMemory&) = delete;
    OutboxMemory& operator=(const OutboxMemory&) = delete;

    /// What one client, or one answer, has waiting.
    class Share {
      public:
        /// @param all  null: everything fits
        explicit Share(OutboxMemory* all = nullptr) : all_(all) {}

        ~Share() { shrink(bytes_); }

        Share(const Share&) = delete;
        Share& operator=(const Share&) = delete;

        /// False where it does not fit; nothing has changed then.
        [[nodiscard]] bool grow(std::size_t more);
        void shrink(std::size_t less);

      private:
        OutboxMemory* all_;
        std::size_t bytes_ = 0;
    };

    /// For one answer, until it has been sent; null where it does not fit.
    std::shared_ptr<void> hold(std::size_t bytes);

    /// Of all together.
    std::size_t bytes() const { return bytes_; }

  private:
    bool fits(std::size_t own, std::size_t more) const;
    void changed();

    std::size_t most_;
    std::size_t bytes_ = 0;
    core::MemoryAccount::Share counted_; ///< follows bytes_ in steps
};

} // namespace wakesurf::server
