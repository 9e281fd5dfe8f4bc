#include "core/surface/moving/moving_builder.hpp"

#include "core/surface/moving/moving_surface.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <chrono>

namespace wakesurf::core {

void mirror_cells(QuadComplex& mesh) {
    for (Cell& cell : mesh.cells)
        cell = mirror(cell);
}

void count(SurfaceStatistics& statistics, const QuadComplex& mesh) {
    statistics.quads = mesh.cells.size();
    statistics.vertices = mesh.vertices();
    statistics.approximated = static_cast<std::uint64_t>(
        std::count(mesh.approximated.begin(), mesh.approximated.end(), 1));
    statistics.max_edge = longest_edge(mesh);
    statistics.error = stated_error(mesh, statistics.separation);
}

Result<Surface> build_moving_surface(const SurfacePlan& plan,
                                     std::stop_token stop,
                                     const Clock& clock,
                                     const WorkPart& work) {
    const auto began = clock.now();
    auto moving = MovingSurface::start(plan, stop, clock, work);
    if (!moving)
        return tl::unexpected(moving.error());
    if (auto moved = moving->advance_to(moving->end_time(), stop, work); !moved)
        return tl::unexpected(moved.error());
    if (auto room = work.holds(memory_while_moving(moving->state().mesh) +
                               shown_bytes * moving->state().mesh.vertices.slots());
        !room)
        return tl::unexpected(room.error());
    Surface surface{moving->mesh().mesh, moving->statistics()};
    if (time_sign(plan.parameters) < 0.0)
        mirror_cells(surface.mesh);
    if (!plan.parameters.deformation)
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
