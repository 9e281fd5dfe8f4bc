// Axes along which a flow repeats: what leaves the box of its grid on one side goes on, from the other.
#pragma once

#include "core/base/box.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace wakesurf::core {

/// Says of x, y and z whether the flow repeats along it; the box of its grid is one period then.
using PeriodicAxes = std::array<bool, 3>;

/// The periods that particles are followed through beyond either side of the box. With the box these are 15,
/// which four more bits of a lattice hold at the same resolution.
inline constexpr int periods_beyond = 7;

inline bool any(const PeriodicAxes& axes) {
    return axes[0] || axes[1] || axes[2];
}

/// Returns their names: "x and z".
inline std::string axes_text(const PeriodicAxes& axes) {
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (axes[axis])
            text += (text.empty() ? "" : " and ") + std::string(1, "xyz"[axis]);
    return text;
}

/// Returns everything where particles may come to: a box and its repetitions.
inline Box repeated(const Box& box, const PeriodicAxes& axes) {
    Vec3 beyond(0.0);
    for (int axis = 0; axis < 3; ++axis)
        if (axes[static_cast<std::size_t>(axis)])
            beyond[axis] = periods_beyond * box.extent()[axis];
    return {box.lo - beyond, box.hi + beyond};
}

} // namespace wakesurf::core
