// The error of a finished surface that comes from interpolating between stored times. Its particles are traced
// again through every second and every third stored time. Interpolating linearly between stored times h apart is off
// by e h^2, so these are 3 e h^2 and 8 e h^2 from the surface (Richardson's extrapolation): both tell e, and where
// they agree the series resolves the flow. Both are begun at the first and at the second stored time: they are off by
// the same on average, and where every second differ they do not resolve it either.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::core {

/// Fewer stored times tell nothing of the error between them: every third of them leaves two or three.
inline constexpr std::size_t least_stored_times = 5;

/// Returns why there can be none of a surface of this plan, in words for people; empty if there can.
/// @param ended  the time it is followed to, where that is not the plan's own
std::string no_interval_errors(const SurfacePlan& plan, std::optional<double> ended = {});

/// Estimates the errors, into the mesh's `interval_error`, and what they come to into the statistics; or there why
/// there are none. The same bytes for any number of threads. REQUIRES: the surface is of this plan. Error:
/// Cancelled, OverLimit, what loading a time-step reports. Cost: each vertex of a streak or time surface is traced
/// four times from the rake, each line of a path surface four times.
Result<void> state_interval_errors(const SurfacePlan& plan,
                                   Surface& surface,
                                   std::stop_token stop,
                                   const WorkPart& work = {});

} // namespace wakesurf::core
