// What the edits of a round take: see edit_round().
#pragma once

#include "core/base/with_spare.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Elements, by number, that can be taken once a round. A copy takes no part in the round of what it was copied from.
class Claims {
  public:
    Claims() = default;

    Claims(const Claims&) {}

    Claims(Claims&&) = default;

    Claims& operator=(const Claims&) { return *this; }

    Claims& operator=(Claims&&) = default;
    ~Claims() = default;

    void make_room(std::size_t elements) {
        if (taken_.capacity() < elements)
            taken_.reserve(with_spare(elements));
        if (taken_.size() < elements)
            taken_.resize(elements, 0);
    }

    /// Begins a round, in which nothing is taken yet.
    void begin() {
        if (++round_ == 0) {
            std::fill(taken_.begin(), taken_.end(), 0);
            round_ = 1;
        }
    }

    /// Takes all of them, unless one has been taken in this round.
    bool take(std::span<const std::uint32_t> elements) {
        for (const std::uint32_t element : elements)
            if (taken_[element] == round_)
                return false;
        for (const std::uint32_t element : elements)
            taken_[element] = round_;
        return true;
    }

    std::size_t bytes() const { return taken_.capacity() * sizeof(std::uint16_t); }

  private:
    std::vector<std::uint16_t> taken_; ///< in which round
    std::uint16_t round_ = 0;
};

} // namespace wakesurf::core
