#include "core/surface/moving/moving_builder.hpp"

#include "core/surface/moving/joined_parts.hpp"
#include "core/surface/moving/moving_parts.hpp"
#include "core/surface/moving/moving_surface.hpp"

#include <algorithm>
#include <chrono>

namespace wakesurf::core {

namespace {

constexpr std::size_t shown_bytes = 250; ///< a vertex, while the mesh to show is made

} // namespace

Result<Surface> build_moving_surface(const Flow& flow,
                                     const Rake& rake,
                                     const SurfaceParameters& parameters,
                                     std::stop_token stop,
                                     const Clock& clock,
                                     const WorkPart& work) {
    const auto began = clock.now();
    const auto parts = moving_parts(flow, parameters);
    if (!parts)
        return tl::unexpected(parts.error());
    Surface surface;
    for (std::size_t i = 0; i < parts->size(); ++i) {
        const MovingPart& part = (*parts)[i];
        const WorkPart here = work.part(i, parts->size()).above(memory_of(surface.mesh));
        auto moving = MovingSurface::start(flow, rake, part.parameters, stop, clock, here);
        if (!moving)
            return tl::unexpected(moving.error());
        if (auto moved = moving->advance_to(moving->end_time(), stop, here); !moved)
            return tl::unexpected(moved.error());
        if (!here.holds(memory_while_moving(moving->state().mesh) +
                        shown_bytes * moving->state().mesh.vertices.slots()))
            return fail(Error::Code::Cancelled, "there is not enough memory for the surface");
        if (part.backward())
            surface.first_backward = static_cast<VertexId>(surface.mesh.vertices());
        append(surface.mesh, moving->mesh().mesh, part.backward());
        add(surface.statistics, moving->statistics());
    }
    if (!parameters.deformation)
        surface.mesh.deformation.clear();
    label_components(surface.mesh);
    SurfaceStatistics& s = surface.statistics;
    count(s, surface.mesh);
    s.seconds.total = std::chrono::duration<double>(clock.now() - began).count();
    s.seconds.other =
        std::max(0.0, s.seconds.total - s.seconds.load - s.seconds.advect - s.seconds.refine);
    return surface;
}

} // namespace wakesurf::core
