// From what was asked to what is built: checks a request and works out the sheets it takes, one a direction.
#pragma once

#include "core/surface/columns/sheet.hpp"
#include "core/surface/surface_parameters.hpp"

#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Error: InvalidArgument.
Result<void> check_request(const SurfaceParameters& parameters);

/// Whether cells of that edge can show anything of the flow: from a millionth of its domain's diagonal to a thousand of them.
/// Error: InvalidArgument.
Result<void> check_separation(const Flow& flow, double separation);

/// Whether the flow has a field of that interpolation. Error: InvalidArgument.
Result<void> check_interpolation(const Flow& flow, Interpolation wanted);

/// Largest speed on 7^3 points of the domain and 17 of the rake: what "standing still" is measured by.
Result<double> largest_speed(const Flow& flow, const Rake& rake, double time, std::stop_token stop);

/// Error: OutOfTime where `from`, or the `to` of all but stream surfaces, lies outside the times of the data.
Result<void> check_times(const Flow& flow, const SurfaceParameters& parameters);

/// Error the integrator may make per unit length.
double trace_tolerance(Accuracy accuracy);

/// One entry a direction. Error: InvalidArgument where the flow has no such interpolation, else as check_times.
Result<std::vector<SheetOptions>> sheet_options(const Flow& flow,
                                                const Rake& rake,
                                                const SurfaceParameters& parameters,
                                                double separation,
                                                double largest_speed);

} // namespace wakesurf::core
