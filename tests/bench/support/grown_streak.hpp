// A streak surface of about 100,000 vertices, in any flow: for what its updates cost.
#pragma once

#include "core/surface/moving/moving_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wakesurf::bench {

constexpr double wanted_vertices = 100'000;

inline void step(core::MovingSurface& surface) {
    if (const auto stepped = surface.step(surface.end_time(), {}); !stepped)
        throw std::runtime_error(stepped.error().message);
}

inline double vertices_of(const core::MovingSurface& surface) {
    return static_cast<double>(surface.state().mesh.vertices.used());
}

/// Returns a surface that has as many vertices before nine tenths of the time are over: the separation shrinks until it does.
inline core::MovingSurface
grown_streak(const core::Flow& flow, const core::Rake& rake, double from, double to) {
    static const core::SteadyClock clock;
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.from = from;
    p.to = to;
    p.separation = 2.0 * flow.finest_spacing();
    p.accuracy = core::Accuracy::Fast;
    while (true) {
        auto surface =
            core::MovingSurface::start(core::plan_surface(flow, rake, p).value(), {}, clock);
        if (!surface)
            throw std::runtime_error(surface.error().message);
        while (surface->time() < from + 0.9 * (to - from) &&
               vertices_of(*surface) < wanted_vertices)
            step(*surface);
        const double vertices = vertices_of(*surface);
        if (vertices >= 0.9 * wanted_vertices)
            return std::move(*surface);
        p.separation *= std::max(0.3, 0.95 * std::sqrt(vertices / wanted_vertices));
    }
}

} // namespace wakesurf::bench
