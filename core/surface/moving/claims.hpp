// Who comes first to what is edited: see edit_round().
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace wakesurf::core {

/// Elements, by number, that nobody claims until somebody does. A copy has no claims.
class Claims {
  public:
    Claims() = default;

    Claims(const Claims&) {}

    Claims(Claims&&) = default;

    Claims& operator=(const Claims&) {
        std::fill(first_.begin(), first_.end(), nobody);
        return *this;
    }

    Claims& operator=(Claims&&) = default;
    ~Claims() = default;

    void make_room(std::size_t elements) {
        if (first_.capacity() < elements)
            first_.reserve(elements + elements / 8);
        if (first_.size() < elements)
            first_.resize(elements, nobody);
    }

    /// From several threads at the same time: the lowest rank has it in the end.
    void claim(std::uint32_t element, std::uint32_t rank) {
        const std::atomic_ref first(first_[element]);
        std::uint32_t before = first.load(std::memory_order_relaxed);
        while (rank < before &&
               !first.compare_exchange_weak(before, rank, std::memory_order_relaxed)) {
        }
    }

    /// When nobody claims any more.
    bool has(std::uint32_t element, std::uint32_t rank) const { return first_[element] == rank; }

    /// From several threads at the same time, when nobody asks any more.
    void release(std::uint32_t element) {
        std::atomic_ref(first_[element]).store(nobody, std::memory_order_relaxed);
    }

    std::size_t bytes() const { return first_.capacity() * sizeof(std::uint32_t); }

  private:
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> first_;
};

} // namespace wakesurf::core
