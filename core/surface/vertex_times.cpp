#include "core/surface/vertex_times.hpp"

#include <cmath>

namespace wakesurf::core {

std::vector<double> vertex_times(const Surface& surface, const SurfaceParameters& parameters) {
    const auto& p = parameters;
    const double duration = std::abs(surface.ended.value_or(p.to) - p.from);
    std::vector<double> times(surface.mesh.vertices(), p.from);
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (p.kind == SurfaceKind::Path)
            times[i] += surface.mesh.t[i];
        else if (p.kind != SurfaceKind::Stream)
            times[i] += i < surface.first_backward ? duration : -duration;
    }
    return times;
}

} // namespace wakesurf::core
