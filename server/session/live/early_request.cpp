#include "server/session/live/early_request.hpp"

#include "core/surface/playback/surface_age.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

EarlyRequest early_request(const SurfaceJob& job, const SurfacePass& pass) {
    EarlyRequest out{job.rake, job.parameters};
    core::SurfaceParameters& p = out.parameters;
    out.rake.seeds = std::min(
        out.rake.seeds, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(pass.quads))));
    p.max_quads = std::min(p.max_quads, pass.quads);
    p.accuracy = core::Accuracy::Fast;
    if (pass.phase == Phase::Coarse)
        p.separation *= 2.0;
    if (p.separation > 0.0 || pass.separation > job.flow->finest_spacing())
        p.separation = std::max(p.separation, pass.separation);
    const double age = core::age_at(p, pass.time);
    const bool moving = p.kind == core::SurfaceKind::Streak || p.kind == core::SurfaceKind::Time;
    if (moving && pass.time && age > 0.0) {
        if (p.release_until && std::abs(*p.release_until - p.from) > age)
            p.release_until.reset();
        p.to = p.from + std::copysign(age, p.to - p.from);
    }
    return out;
}

} // namespace wakesurf::server
