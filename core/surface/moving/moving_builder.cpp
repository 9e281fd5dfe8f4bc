#include "core/surface/moving/moving_builder.hpp"

#include "core/surface/moving/moving_surface.hpp"
#include "core/surface/surface_request.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace wakesurf::core {

namespace {

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
    SurfaceParameters p = parameters;
    p.separation = p.separation > 0.0 ? p.separation : flow.finest_spacing();
    Surface surface;
    for (const Direction direction : {Direction::Forward, Direction::Backward}) {
        if (parameters.direction != Direction::Both && parameters.direction != direction)
            continue;
        p.direction = direction;
        if (parameters.direction == Direction::Both)
            p.max_quads = std::max<std::uint64_t>(parameters.max_quads / 2, 1);
        if (auto in_time = check_times(
                flow, p, (direction == Direction::Backward ? -1.0 : 1.0) * std::abs(p.to - p.from));
            !in_time)
            return tl::unexpected(in_time.error());
        auto moving = MovingSurface::start(flow, rake, p, stop, clock);
        if (!moving)
            return tl::unexpected(moving.error());
        const WorkPart part = parameters.direction == Direction::Both
                                  ? work.part(direction == Direction::Backward ? 1 : 0, 2)
                                  : work;
        if (auto moved = moving->advance_to(moving->end_time(), stop, part); !moved)
            return tl::unexpected(moved.error());
        if (direction == Direction::Backward)
            surface.first_backward = static_cast<VertexId>(surface.mesh.vertices());
        append(surface.mesh, moving->mesh().mesh, direction == Direction::Backward);
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
