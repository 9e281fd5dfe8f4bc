#include "core/surface/moving/moving_builder.hpp"

#include "core/surface/moving/moving_parts.hpp"
#include "core/surface/moving/moving_surface.hpp"

#include <algorithm>
#include <chrono>

namespace wakesurf::core {

namespace {

constexpr std::size_t shown_bytes = 250; ///< a vertex, while the mesh to show is made

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// @param mirrored  upstream surfaces are, so that both directions face the same way
void append(QuadComplex& mesh, const QuadComplex& part, bool mirrored) {
    const auto first = static_cast<VertexId>(mesh.vertices());
    append(mesh.position, part.position);
    append(mesh.s, part.s);
    append(mesh.t, part.t);
    append(mesh.velocity, part.velocity);
    append(mesh.deformation, part.deformation);
    append(mesh.approximated, part.approximated);
    for (Cell cell : part.cells) {
        for (auto* ids : {&cell.corner, &cell.mid})
            for (VertexId& v : *ids)
                if (v != no_vertex)
                    v += first;
        if (mirrored) {
            std::swap(cell.corner[0], cell.corner[1]);
            std::swap(cell.corner[2], cell.corner[3]);
            std::swap(cell.mid[1], cell.mid[3]);
        }
        mesh.cells.push_back(cell);
    }
}

void add(SurfaceStatistics& sum, const SurfaceStatistics& part) {
    sum.kind = part.kind;
    sum.steps = std::max(sum.steps, part.steps);
    sum.vertex_steps += part.vertex_steps;
    sum.terminated.domain += part.terminated.domain;
    sum.terminated.obstacle += part.terminated.obstacle;
    sum.terminated.stagnation += part.terminated.stagnation;
    sum.terminated.budget += part.terminated.budget;
    sum.separation = std::max(sum.separation, part.separation);
    sum.seconds.load += part.seconds.load;
    sum.seconds.advect += part.seconds.advect;
    sum.seconds.refine += part.seconds.refine;
    sum.peak_bytes += part.peak_bytes;
}

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
    s.quads = surface.mesh.cells.size();
    s.vertices = surface.mesh.vertices();
    s.approximated = static_cast<std::uint64_t>(
        std::count(surface.mesh.approximated.begin(), surface.mesh.approximated.end(), 1));
    s.max_edge = longest_edge(surface.mesh);
    s.terminated.time = s.vertices;
    s.seconds.total = std::chrono::duration<double>(clock.now() - began).count();
    s.seconds.other =
        std::max(0.0, s.seconds.total - s.seconds.load - s.seconds.advect - s.seconds.refine);
    return surface;
}

} // namespace wakesurf::core
