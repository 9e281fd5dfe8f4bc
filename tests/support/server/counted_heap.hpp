// What this process holds on the heap through new, and how far that went beyond what an account of memory was told. Takes the place of
// operator new in every program that links it.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>

namespace wakesurf::tests {

/// Bytes that are held now.
std::size_t held_on_heap();

/// From the start to the end; one at a time.
class CountedHeap {
  public:
    /// @param account  whose shares are compared with the heap whenever a large piece is taken
    explicit CountedHeap(const core::MemoryAccount& account);
    ~CountedHeap();
    CountedHeap(const CountedHeap&) = delete;
    CountedHeap& operator=(const CountedHeap&) = delete;

    /// The most that was held at a time, beyond what was held at the start.
    std::size_t most() const;

    /// The most that was held beyond the account's shares at a time.
    std::size_t most_untold() const;

    /// The most the account was told at a time.
    std::size_t most_told() const;
};

} // namespace wakesurf::tests
