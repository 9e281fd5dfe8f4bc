#include "core/surface/playback/surface_at.hpp"

#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/playback/growing_mesh.hpp"
#include "core/surface/playback/played_surface.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::core {

bool moves(const SurfaceParameters& p) {
    return p.kind != SurfaceKind::Stream && p.from != p.to;
}

double age_at(const SurfaceParameters& p, std::optional<double> time) {
    const double most = time_span(p);
    return time ? std::clamp(time_sign(p) * (*time - p.from), 0.0, most) : most;
}

namespace {

Result<SurfaceAt> played(const SurfacePlan& plan,
                         double age,
                         const Clock& clock,
                         const std::stop_token& stop,
                         const WorkPart& work) {
    auto surface = PlayedSurface::start(plan, 0, clock, stop, work); // nothing to step back to
    if (!surface)
        return tl::unexpected(surface.error());
    auto shown = surface->at(age, stop, work);
    if (!shown)
        return tl::unexpected(shown.error());
    std::vector<double> times(shown->mesh.mesh.vertices(), shown->time);
    return SurfaceAt{std::move(shown->mesh.mesh), std::move(shown->statistics), std::move(times),
                     shown->time};
}

Result<SurfaceAt> level_at(const SurfacePlan& plan,
                           double time,
                           const Clock& clock,
                           const std::stop_token& stop,
                           const WorkPart& work) {
    return build_level_surface(plan, time, stop, clock, work).map([&](Surface&& level) {
        std::vector<double> times(level.mesh.vertices(), time);
        return SurfaceAt{std::move(level.mesh), std::move(level.statistics), std::move(times)};
    });
}

} // namespace

Result<SurfaceAt> surface_at(const SurfacePlan& plan,
                             std::optional<double> time,
                             const Clock& clock,
                             const std::stop_token& stop,
                             const WorkPart& work) {
    const SurfaceParameters& p = plan.parameters;
    const bool timed = time && moves(p);
    const double age = age_at(p, time);
    if (p.kind == SurfaceKind::Level)
        return level_at(plan, p.from + time_sign(p) * age, clock, stop, work);
    if (timed && p.kind != SurfaceKind::Path)
        return played(plan, age, clock, stop, work);
    auto surface = build_surface(plan, stop, clock, work);
    if (!surface)
        return tl::unexpected(surface.error());
    if (timed) {
        if (auto room = work.takes(2 * memory_of(surface->mesh)); !room)
            return tl::unexpected(room.error());
        const GrowingMesh growing(surface->mesh, time_span(p));
        surface->mesh = growing.at(age).mesh;
        surface->statistics.quads = surface->mesh.cells.size();
        surface->statistics.vertices = surface->mesh.vertices();
        surface->statistics.error = stated_error(surface->mesh, surface->statistics.separation);
        surface->ended = p.from + time_sign(p) * age;
    }
    auto times = vertex_times(*surface, p);
    return SurfaceAt{std::move(surface->mesh), std::move(surface->statistics), std::move(times),
                     surface->ended};
}

} // namespace wakesurf::core
