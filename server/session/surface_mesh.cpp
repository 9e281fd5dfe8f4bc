#include "server/session/surface_mesh.hpp"

#include "core/surface/surface_builder.hpp"
#include "core/surface/vertex_times.hpp"
#include "server/session/growing_mesh.hpp"
#include "server/session/played_surface.hpp"
#include "server/session/surface_build.hpp"

#include <cmath>
#include <utility>

namespace wakesurf::server {

namespace {

core::Result<SurfaceMesh> played(const SurfaceJob& job,
                                 double age,
                                 const core::Clock& clock,
                                 const std::stop_token& stop,
                                 const core::WorkPart& work) {
    auto surface = PlayedSurface::start(job, 0, clock, stop, work); // nothing to step back to
    if (!surface)
        return tl::unexpected(surface.error());
    auto shown = surface->at(age, stop, work);
    if (!shown)
        return tl::unexpected(shown.error());
    auto times = shown->times();
    return SurfaceMesh{std::move(shown->mesh.mesh), std::move(shown->statistics), std::move(times)};
}

} // namespace

core::Result<SurfaceMesh> surface_mesh(const SurfaceJob& job,
                                       std::optional<double> time,
                                       const core::Clock& clock,
                                       const std::stop_token& stop,
                                       const core::WorkPart& work) {
    const core::SurfaceParameters& p = job.parameters;
    const bool timed = time && moves(p);
    const double age = age_at(p, time);
    if (timed && p.kind != core::SurfaceKind::Path)
        return played(job, age, clock, stop, work);
    auto surface = core::build_surface(*job.flow, job.rake, p, stop, clock, work);
    if (!surface)
        return tl::unexpected(surface.error());
    if (timed) {
        if (!work.takes(2 * core::memory_of(surface->mesh)))
            return core::fail(core::Error::Code::Cancelled,
                              "there is not enough memory for the surface");
        const GrowingMesh growing(surface->mesh, std::abs(p.to - p.from));
        surface->mesh = growing.at(age).mesh;
        surface->statistics.quads = surface->mesh.cells.size();
        surface->statistics.vertices = surface->mesh.vertices();
    }
    auto times = core::vertex_times(*surface, p);
    return SurfaceMesh{std::move(surface->mesh), std::move(surface->statistics), std::move(times)};
}

} // namespace wakesurf::server
