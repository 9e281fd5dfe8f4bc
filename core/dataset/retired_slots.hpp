// The memory of removed bricks that may still be read: it is free once all readings that began before have
// ended (epoch-based reclamation, Fraser, Practical lock-freedom, 2004, 5.2.3; here with a lock).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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

} // namespace wakesurf::core
