// A level set of a scalar field as a surface like any other: what it is coloured by, exported and sent with
// comes from the same mesh.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/level/level_source.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <memory>
#include <stop_token>

namespace wakesurf::core {

/// Completes a plan of a level surface once the data are open; does nothing to others. Error: Unsupported
/// without a source; NotFound, listing the fields.
Result<void> take_levels(SurfacePlan& plan, std::shared_ptr<const LevelSource> levels);

/// Builds the level set at a time. Its s and t are 0: nothing is released. Statistics say why it is empty,
/// and what the field ranges over. REQUIRES: a plan that take_levels() has completed. Error: OverLimit
/// (quads, or memory), what LevelSource::extract and sampling report.
Result<Surface> build_level_surface(const SurfacePlan& plan,
                                    double time,
                                    const std::stop_token& stop,
                                    const Clock& clock,
                                    const WorkPart& work);

} // namespace wakesurf::core
