// A number with the errors that come from a surface's two stated ones.
#pragma once

#include <cmath>
#include <limits>

namespace wakesurf::core {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// A number and how far it may be off; not_known where that cannot be said.
struct Measured {
    double value = not_known;
    double pieces = not_known; ///< how much taking the surface as smaller pieces changes it
    /// By the tracing error (QuadComplex::error), and `pieces`.
    double error = not_known;
    double interval_error = not_known; ///< by interpolating between stored times

    bool known() const { return std::isfinite(value); }
};

/// Returns the limit for pieces of no size of a number whose error falls with the square of their size, from its
/// value of whole pieces and of pieces half as large (Richardson's extrapolation); its error is what halving changes.
inline Measured extrapolated(double whole, double halved) {
    const double pieces = std::abs(halved - whole);
    return {halved + (halved - whole) / 3.0, pieces, pieces, not_known};
}

} // namespace wakesurf::core
