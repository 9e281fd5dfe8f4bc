#include "core/surface/surface.hpp"

namespace wakesurf::core {

std::vector<double> vertex_times(const Surface& surface, const SurfaceParameters& parameters) {
    const auto& p = parameters;
    const bool moving = p.kind != SurfaceKind::Stream && p.kind != SurfaceKind::Path;
    std::vector<double> times(surface.mesh.vertices(),
                              moving ? surface.ended.value_or(p.to) : p.from);
    if (p.kind == SurfaceKind::Path)
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] += surface.mesh.t[i];
    return times;
}

} // namespace wakesurf::core
