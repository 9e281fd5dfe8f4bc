// Reads bricks and waits for them.
#pragma once

#include "core/dataset/brick_source.hpp"

#include <latch>
#include <stop_token>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Returns the outcomes of the reads, in their order.
inline std::vector<core::Result<void>> outcomes_of(const core::BrickSource& source,
                                                   const std::vector<core::BrickRead>& reads,
                                                   std::stop_token stop = {}) {
    std::vector<core::Result<void>> outcomes(reads.size());
    std::latch all(static_cast<std::ptrdiff_t>(reads.size()));
    source.read(reads, std::move(stop), [&](std::size_t index, core::Result<void> outcome) {
        outcomes[index] = std::move(outcome);
        all.count_down();
    });
    all.wait();
    return outcomes;
}

} // namespace wakesurf::tests
