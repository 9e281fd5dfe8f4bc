// The error of a finished surface that comes from interpolating between stored times. Its particles are traced
// again through every second and every fourth stored time. Interpolating between stored times h apart is off by
// e h^2, so these are 3 e h^2 and 15 e h^2 from the surface (Richardson's extrapolation): both tell e, and
// where they agree the series resolves the flow.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

struct IntervalErrors {
    /// Nothing where no vertex is resolved.
    std::optional<StatedIntervalError> stated{};
    double interval = 0.0; ///< the longest between the stored times that the surface uses
    /// As of SurfaceStatistics; nothing where there is no error, or less than half of the vertices are resolved.
    std::optional<double> advised_interval{};
    std::vector<float>
        error{}; ///< a length, one a vertex; NaN: not resolved, or not traced from the rake
};

/// Returns why there can be none of a surface of this plan, in words for people; empty if there can.
std::string no_interval_errors(const SurfacePlan& plan);

/// Estimates the errors. REQUIRES: no_interval_errors() is empty; the surface is of this plan. The same bytes for
/// any number of threads. Error: Cancelled, OverLimit, what loading a time-step reports. Cost: each vertex of a
/// streak or time surface is traced twice from the rake, each line of a path surface twice.
Result<IntervalErrors> interval_errors(const SurfacePlan& plan,
                                       const Surface& surface,
                                       std::stop_token stop,
                                       const WorkPart& work = {});

/// Estimates the errors and puts what they come to into the surface's statistics, or why there are none.
/// Returns the errors of the vertices; empty without. Error: as interval_errors.
Result<std::vector<float>> state_interval_errors(const SurfacePlan& plan,
                                                 Surface& surface,
                                                 std::stop_token stop,
                                                 const WorkPart& work = {});

} // namespace wakesurf::core
