// The account of this process's memory: how large it is, what the process is seen to hold beside its shares,
// and who gives memory back first: the allocator.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <memory>

namespace wakesurf::server {

/// Returns the default of `--memory`: 60 % of what the machine, or the control group, has; the rest is for
/// the page cache and others.
std::size_t default_memory();

class ProcessAccount {
  public:
    /// @param budget  `--memory`, in bytes; 0: default_memory().
    explicit ProcessAccount(std::size_t budget);

    const core::MemoryAccount& account() const { return account_; }

    /// Looks at what the process holds; true where that is more than it may, and others should be asked to
    /// give back.
    bool too_much() const;

  private:
    core::MemoryAccount account_;
    std::shared_ptr<void> spare_heap_; ///< asked for through this
};

} // namespace wakesurf::server
