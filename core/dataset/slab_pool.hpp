// Slabs of one size that are used again: giving 300 MB back to the operating system and getting them back,
// zeroed, costs as much as filling them.
#pragma once

#include "core/dataset/slab.hpp"

#include <cstddef>
#include <mutex>
#include <vector>

namespace wakesurf::core {

/// Keeps released slabs for reuse, so that no more slabs exist than were ever in use at once. Thread-safe.
class SlabPool {
  public:
    /// A pool of slabs of so many bytes, none of which is there yet.
    explicit SlabPool(std::size_t bytes) : bytes_(bytes) { idle_.reserve(most_idle); }

    /// Returns a slab with whatever its last user left in it. Throws std::bad_alloc.
    Slab take() {
        {
            const std::scoped_lock lock(mutex_);
            if (!idle_.empty()) {
                Slab slab = std::move(idle_.back());
                idle_.pop_back();
                return slab;
            }
        }
        return Slab(bytes_);
    }

    /// Returns a slab of take() to the pool.
    void give_back(Slab slab) noexcept {
        const std::scoped_lock lock(mutex_);
        if (idle_.size() < most_idle)
            idle_.push_back(std::move(slab));
    }

    /// Frees what lies idle.
    void clear() noexcept {
        const std::scoped_lock lock(mutex_);
        idle_.clear();
    }

  private:
    // A load that starts takes what the eviction before it gave: more lie idle only for an instant.
    static constexpr std::size_t most_idle = 2;

    std::size_t bytes_;
    std::mutex mutex_;
    std::vector<Slab> idle_;
};

} // namespace wakesurf::core
