#include "core/surface/playback/surface_age.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

bool moves(const SurfaceParameters& p) {
    return p.kind != SurfaceKind::Stream;
}

double time_sign(const SurfaceParameters& p) {
    return p.direction == Direction::Backward ? -1.0 : 1.0;
}

double time_span(const SurfaceParameters& p) {
    return std::abs(p.to - p.from);
}

double end_time(const SurfaceParameters& p) {
    return p.from + time_sign(p) * time_span(p);
}

double age_at(const SurfaceParameters& p, std::optional<double> time) {
    const double most = time_span(p);
    return time ? std::clamp(time_sign(p) * (*time - p.from), 0.0, most) : most;
}

} // namespace wakesurf::core
