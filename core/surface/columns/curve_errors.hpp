// Computes how far the vertices of a stream or path surface may be from the true surface, across it: the
// integrator's error of each step, carried along the curve as the flow deforms what is near it.
#pragma once

#include "core/surface/columns/strip.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Estimates along the curves of a sheet. Tangents of the surface carry an error (carried_error.hpp):
/// velocity along a curve, and across it the way to the next curve at the same time.
///
/// Errors add up as if they all were across the surface, on one side. The integrator's own estimate is of its
/// lower order, so that the sum is usually too large. Cost: one comparison with either neighbour every fourth
/// step.
class CurveErrors {
  public:
    /// @param curves  of the sheet's columns, in any order, repeated or not; must outlive this
    /// @param stop    leaves curves without estimates, so that at() must not be asked
    explicit CurveErrors(std::vector<const SeededCurve*> curves, const std::stop_token& stop = {});

    /// Returns the error at a place of the curve, a length.
    float at(const SeededCurve* curve, double arc) const;

  private:
    struct Knot {
        double arc, error;
    };

    static std::vector<Knot>
    along(const SeededCurve& curve, const SeededCurve* left, const SeededCurve* right);

    std::vector<const SeededCurve*> curves_; ///< by seed parameter
    std::vector<std::vector<Knot>> knots_;
};

} // namespace wakesurf::core
