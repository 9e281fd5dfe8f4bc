// The volume per time that passes through a closed curve: through the cone from its centre, which in a flow without
// divergence is what passes through any surface that it bounds.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// The flux through a closed curve.
struct SectionFlux {
    double value = 0.0; ///< positive along the normal about which the curve turns counter-clockwise
    double quadrature = 0.0; ///< how much halving the distance between samples changes it
    /// How much each of the errors changes it to first order, all of them on one side; not_known where less than half of
    /// the curve has one.
    std::vector<double> errors;
    Vec3 area{0.0}; ///< that it encloses, as a vector
};

/// @param curve   its points, the first not repeated
/// @param errors  lists of one length a point: how far it may be from where it should be
/// @param spacing  of the samples on the way to the centre
/// Error: OutOfDomain where the cone leaves the data; what sampling reports. Inside an obstacle nothing passes.
Result<SectionFlux> section_flux(const SurfacePlan& plan,
                                 std::span<const Vec3> curve,
                                 std::span<const std::vector<double>> errors,
                                 double time,
                                 double spacing,
                                 const std::stop_token& stop);

} // namespace wakesurf::core
