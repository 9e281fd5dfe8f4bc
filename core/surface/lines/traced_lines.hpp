// Lines through the flow as they are handed on: points one after the other, with what there is along them, and why they end.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::core {

/// Why ends of lines are where they are; with both directions a line has two.
struct LineEnds {
    std::uint32_t limit = 0;  ///< `duration` or `length`
    std::uint32_t domain = 0; ///< the border of the domain, or of the wall along which it goes
    std::uint32_t wall = 0;
    std::uint32_t rest = 0; ///< the flow does not move there
    std::uint32_t cut = 0;  ///< it had as many points, or steps, as a line may have
};

struct StreamLines {
    std::vector<Vec3> points;  ///< of all lines, one after the other, downstream
    std::vector<float> times;  ///< of flight at each point, from the seed; negative upstream
    std::vector<float> values; ///< of the field there; NaN where it has none
    std::vector<std::uint32_t> offsets; ///< line i has the points from offsets[i] to offsets[i + 1]
    std::vector<std::uint32_t> seed;    ///< the number of its seed, a line
    std::uint32_t seeds = 0;            ///< all of them
    std::uint32_t outside = 0; ///< of them in bodies or outside of the domain: they have no line
    LineEnds ends;
    std::optional<std::array<float, 2>> range; ///< of the values; nothing where there is none

    std::size_t lines() const { return seed.size(); }
};

} // namespace wakesurf::core
