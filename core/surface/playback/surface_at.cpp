#include "core/surface/playback/surface_at.hpp"

#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/time_direction.hpp"

#include <utility>

namespace wakesurf::core {

Result<SurfaceAt> surface_at(const SurfacePlan& plan,
                             std::optional<double> time,
                             const Clock& clock,
                             const std::stop_token& stop,
                             const WorkPart& work) {
    const SurfaceParameters& p = plan.parameters;
    if (p.kind == SurfaceKind::Level || (time && moves(p))) {
        auto evolution = Evolution::start(plan, clock, stop, work);
        if (!evolution)
            return tl::unexpected(evolution.error());
        const double shown = p.from + time_sign(p) * age_at(p, time);
        return evolution->at(shown, stop, work).map([&](Evolution::State&& state) {
            return SurfaceAt{std::move(state.mesh.mesh), std::move(state.statistics),
                             std::move(state.times), shown};
        });
    }
    auto surface = build_surface(plan, stop, clock, work);
    if (!surface)
        return tl::unexpected(surface.error());
    auto times = vertex_times(*surface, p);
    return SurfaceAt{std::move(surface->mesh), std::move(surface->statistics), std::move(times),
                     surface->ended};
}

} // namespace wakesurf::core
