// The reason why a surface shows nothing: found afterwards, from the rake, the field there and the fate of
// the particles.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_statistics.hpp"

#include <optional>
#include <stop_token>

namespace wakesurf::core {

/// Returns why a surface is empty; nothing if there is something to see, quads with an area. Cost: one quad;
/// where there is nothing to see, all quads and a few hundred samples. Error: what sampling reports.
Result<std::optional<Emptiness>> why_empty(const SurfacePlan& plan,
                                           const QuadComplex& mesh,
                                           const SurfaceStatistics& statistics,
                                           std::stop_token stop);

} // namespace wakesurf::core
