// Which nodes of a uniform grid lie inside an obstacle. The wall is where the trilinear fluid fraction
// falls below one half: midway between a fluid and a solid node.
#pragma once

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// One byte a node, x fastest: 1 fluid, 0 solid. Empty: no obstacle.
struct SolidMask {
    std::vector<std::uint8_t> fluid; ///< one a node: 1 fluid, 0 solid

    /// Nothing is solid.
    bool empty() const { return fluid.empty(); }
};

} // namespace wakesurf::core
