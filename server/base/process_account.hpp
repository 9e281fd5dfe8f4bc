// The account of this process's memory: its size, the process's measured memory beside its shares, and the
// first to release memory: the allocator.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <memory>

namespace wakesurf::server {

/// Freed memory that the allocator keeps. The program's allocator is jemalloc: its threads seldom wait for
/// each other, as they do for the few arenas that keep the C library's small enough, and it returns freed
/// pages within a fraction of a second.
/// Returns it to the system in programs that are linked without jemalloc (tests, sanitizers); jemalloc does
/// so by itself. Does nothing if called again within 0.25 s: it costs some ms. Thread-safe.
void give_back_spare_heap();

/// Returns the default of `--memory` in bytes: 60 % of what the machine, or the control group, has; the rest
/// is for the page cache and others.
std::size_t default_memory();

class ProcessAccount {
  public:
    /// @param budget  `--memory`, in bytes; 0: default_memory()
    explicit ProcessAccount(std::size_t budget);

    const core::MemoryAccount& account() const { return account_; }

    /// Measures the process; returns true if it holds more than it may, and others should release memory.
    bool too_much() const;

  private:
    core::MemoryAccount account_;
    std::shared_ptr<void> spare_heap_; ///< the registration with the account
};

} // namespace wakesurf::server
