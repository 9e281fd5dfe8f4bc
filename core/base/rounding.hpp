// The end of a range of coordinates or times, with rounding. Solvers write 0.1 in 32 bits, which is
// 0.100000001: a person who types 0.1 means that plane, and that time.
#pragma once

#include "core/base/box.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

/// Returns how far beyond an end of lo..hi a number still means that end: four roundings of a 32-bit number
/// of their size. Far from the origin these become long beside the range, so the result is at most 1e-5 of
/// the range. Where the range is one number, only its size counts.
inline double rounding(double lo, double hi) {
    const double roundings = 0x1p-22 * std::max(std::abs(lo), std::abs(hi));
    return hi > lo ? std::min(roundings, 1e-5 * (hi - lo)) : roundings;
}

/// Returns false for NaN.
inline bool within_rounding(double x, double lo, double hi) {
    const double slack = rounding(lo, hi);
    return x >= lo - slack && x <= hi + slack;
}

/// Returns how far a point may be off along each axis, in units of length. A thin domain counts as long as
/// its longest side.
inline Vec3 rounding(const Box& box) {
    return {rounding(box.lo.x, box.hi.x), rounding(box.lo.y, box.hi.y),
            rounding(box.lo.z, box.hi.z)};
}

/// A point that is beyond a face by rounding, on that face; any other as it is.
inline Vec3 onto_faces(const Vec3& p, const Box& box) {
    Vec3 on = p;
    for (int axis = 0; axis < 3; ++axis)
        if (within_rounding(p[axis], box.lo[axis], box.hi[axis]))
            on[axis] = std::clamp(p[axis], box.lo[axis], box.hi[axis]);
    return on;
}

} // namespace wakesurf::core
