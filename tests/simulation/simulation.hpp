// One whole session in a world: a server that crashes and comes back, eight clients that edit at random over
// bad lines; at the end all must see the same. The same seed is the same story.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace wakesurf::simulation {

/// Counts events, so that an idle world does not pass for a good one.
struct Story {
    std::string trouble; ///< empty: all is well
    std::uint64_t digest = 0;
    std::size_t edits = 0, durable = 0, losses = 0, resumed = 0, crashes = 0, deltas = 0;
    std::size_t surfaces = 0, records = 0; ///< compared at the end
};

/// Runs a story. Callable from any thread; some ten milliseconds.
Story simulate(std::uint64_t seed);

} // namespace wakesurf::simulation
