// The memory of this process on the heap through new, and the most of it that an account of memory did not
// count. Replaces operator new in every program that links it.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>

namespace wakesurf::tests {

/// Returns the bytes allocated now.
std::size_t held_on_heap();

/// Counts from its construction to its end; one at a time.
class CountedHeap {
  public:
    /// @param account  whose shares are compared with the heap whenever a large piece is taken
    explicit CountedHeap(const core::MemoryAccount& account);
    ~CountedHeap();
    CountedHeap(const CountedHeap&) = delete;
    CountedHeap& operator=(const CountedHeap&) = delete;

    /// Returns the most that was allocated at a time, beyond that at the start.
    std::size_t most() const;

    /// Returns the most that was allocated beyond the account's shares at a time.
    std::size_t most_untold() const;

    /// Returns the most that the account counted at a time.
    std::size_t most_told() const;
};

} // namespace wakesurf::tests
