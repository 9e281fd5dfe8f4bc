// Anonymous memory in huge pages for one time-step, and a pool of it: 35-75 % faster advection than 4 KiB
// pages on 300 MB steps (docs/measurements.md, Pages), and read() into it never faults the way a mapped
// file can.
#pragma once

#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Move-only owner of zeroed memory, aligned to 2 MiB where it is that large, followed by at least 64
/// readable bytes (wide loads of the last node). Throws std::bad_alloc.
class Slab {
  public:
    Slab() = default;
    /// Allocates zeroed memory. Throws std::bad_alloc.
    explicit Slab(std::size_t bytes);
    ~Slab();
    Slab(Slab&& other) noexcept;
    Slab& operator=(Slab&& other) noexcept;
    Slab(const Slab&) = delete;
    Slab& operator=(const Slab&) = delete;

    /// Returns as many bytes as were asked for.
    std::span<std::byte> bytes() { return {data_, size_}; }

    /// Returns as many bytes as were asked for.
    std::span<const std::byte> bytes() const { return {data_, size_}; }

    /// Returns the bytes that the operating system gave, page rounding included: the figure the cache
    /// accounts.
    std::size_t reserved() const { return reserved_; }

    /// Returns what a slab of `bytes` will reserve, in bytes.
    static std::size_t reservation(std::size_t bytes);

  private:
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t reserved_ = 0;
};

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
    void put_back(Slab slab) noexcept {
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
