#include "core/surface/playback/surface_age.hpp"

#include "core/surface/time_direction.hpp"

#include <algorithm>

namespace wakesurf::core {

bool moves(const SurfaceParameters& p) {
    return p.kind != SurfaceKind::Stream && p.from != p.to;
}

double age_at(const SurfaceParameters& p, std::optional<double> time) {
    const double most = time_span(p);
    return time ? std::clamp(time_sign(p) * (*time - p.from), 0.0, most) : most;
}

} // namespace wakesurf::core
