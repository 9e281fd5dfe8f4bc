// A stored scalar field at points of the flow it was computed with: what surfaces are coloured and exported
// with.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/field/flow.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Returns one value a point, each at its own time: interpolated as the velocity is, linear in time; NaN
/// outside the domain, in obstacles and where the field has no finite value. Times are clamped to the series.
/// Every time-step needed is read once, if it is not among the source's last ones.
/// @param flow  over the grid of `source`
/// Error: Cancelled, or what reading reports. Thread safety: concurrent calls are fine.
Result<std::vector<float>> sample_scalar(const Flow& flow,
                                         const ScalarSource& source,
                                         std::size_t scalar,
                                         std::span<const Vec3> positions,
                                         std::span<const double> times,
                                         const std::stop_token& stop);

} // namespace wakesurf::core
