// The bricks of a time-step that are in memory, their addresses, and the slots that wait for their last
// reader: filled by the brick cache, read by samplers. See step_nodes.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <set>
#include <vector>

namespace wakesurf::core {

/// Keeps slots until no reading can see them. It is not thread safe.
class RetiredSlots {
  public:
    using Epoch = std::uint64_t;

    /// Returns what ends it.
    Epoch begin_reading() { return *readings_.insert(epoch_); }

    void end_reading(Epoch began) { readings_.erase(readings_.find(began)); }

    bool being_read() const { return !readings_.empty(); }

    /// Begins an epoch: what is retired from now on is not seen by readings that begin later.
    void next_epoch() { ++epoch_; }

    void retire(std::size_t slot) { retired_.push_back({epoch_, slot}); }

    /// Appends the slots that no reading can see any more.
    void reclaim(std::vector<std::size_t>& free) {
        const Epoch oldest =
            readings_.empty() ? std::numeric_limits<Epoch>::max() : *readings_.begin();
        std::erase_if(retired_, [&](const Retired& each) {
            if (each.epoch > oldest)
                return false;
            free.push_back(each.slot);
            return true;
        });
    }

  private:
    struct Retired {
        Epoch epoch;
        std::size_t slot;
    };

    Epoch epoch_ = 0;
    std::multiset<Epoch> readings_;
    std::vector<Retired> retired_;
};

/// The bricks of a field at one time-step: a pointer each, null while it is not in memory, and the time of
/// its last use. It costs 10 bytes a brick, of which only the touched pages are resident. Thread safety: the
/// cache may add and remove bricks during reads; bricks that a reader has seen stay while it owns a
/// BrickCache::Reading.
class BrickTable {
  public:
    /// Counts on whenever bricks are asked for, and wraps round.
    using Age = std::uint16_t;

    /// Makes the table of a time-step, all of whose bricks are missing. Throws std::bad_alloc.
    /// @param field  as in BrickRead
    BrickTable(std::size_t step, std::size_t bricks, std::size_t field = 0)
        : step_(step), field_(field), at_(zeros<const float*>(bricks)), used_(zeros<Age>(bricks)) {}

    /// Returns the index of its time-step.
    std::size_t step() const { return step_; }

    /// Returns 0 for velocity, 1 + its index for a scalar.
    std::size_t field() const { return field_; }

    /// Null where the brick is missing.
    const float* at(std::size_t brick) const {
        return __atomic_load_n(at_.get() + brick, __ATOMIC_ACQUIRE);
    }

    /// Sets the values of a brick; null removes it.
    void put(std::size_t brick, const float* values) {
        __atomic_store_n(at_.get() + brick, values, __ATOMIC_RELEASE);
    }

    /// Returns the time of a brick's last use.
    Age used(std::size_t brick) const {
        return __atomic_load_n(used_.get() + brick, __ATOMIC_RELAXED);
    }

    /// Writes only what changes, as many threads use one brick.
    void use(std::size_t brick, Age now) const {
        if (used(brick) != now)
            __atomic_store_n(used_.get() + brick, now, __ATOMIC_RELAXED);
    }

    /// Returns the pointers by brick, as the batch kernel takes them.
    const float* const* pointers() const { return at_.get(); }

    /// Returns the values of used() by brick.
    Age* ages() const { return used_.get(); }

    /// Returns the bytes that the table of so many bricks can take.
    static std::size_t bytes(std::size_t bricks) {
        return bricks * (sizeof(const float*) + sizeof(Age));
    }

  private:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };

    template <class T>
    static std::unique_ptr<T[], Free> zeros(std::size_t count) {
        auto* memory = static_cast<T*>(std::calloc(count, sizeof(T)));
        if (memory == nullptr)
            throw std::bad_alloc();
        return std::unique_ptr<T[], Free>(memory);
    }

    std::size_t step_;
    std::size_t field_;
    std::unique_ptr<const float*[], Free> at_;
    std::unique_ptr<Age[], Free> used_;
};

} // namespace wakesurf::core
