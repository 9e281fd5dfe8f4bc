#include "server/live/early_plan.hpp"

#include "core/surface/playback/surface_age.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

core::SurfacePlan early_plan(core::SurfacePlan plan, const SurfacePass& pass) {
    core::SurfaceParameters& p = plan.parameters;
    plan.rake.seeds = std::min(
        plan.rake.seeds, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(pass.quads))));
    p.max_quads = std::min(p.max_quads, pass.quads);
    p.accuracy = core::Accuracy::Fast;
    if (pass.phase == Phase::Coarse)
        p.separation *= 2.0;
    p.separation = std::max(p.separation, pass.separation);
    const double age = core::age_at(p, pass.time);
    const bool moving = p.kind == core::SurfaceKind::Streak || p.kind == core::SurfaceKind::Time;
    if (moving && pass.time && age > 0.0) {
        if (p.release_until && std::abs(*p.release_until - p.from) > age)
            p.release_until.reset();
        p.to = p.from + std::copysign(age, p.to - p.from);
    }
    return plan;
}

} // namespace wakesurf::server
