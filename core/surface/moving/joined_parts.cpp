#include "core/surface/moving/joined_parts.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

template <class T>
void extend(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

} // namespace

void append(QuadComplex& to, const QuadComplex& part, bool mirrored) {
    const auto first = static_cast<VertexId>(to.vertices());
    extend(to.position, part.position);
    extend(to.s, part.s);
    extend(to.t, part.t);
    extend(to.velocity, part.velocity);
    extend(to.deformation, part.deformation);
    extend(to.component, part.component);
    extend(to.approximated, part.approximated);
    to.cells.reserve(to.cells.size() + part.cells.size());
    for (Cell cell : part.cells) {
        for (auto* ids : {&cell.corner, &cell.mid})
            for (VertexId& v : *ids)
                if (v != no_vertex)
                    v += first;
        to.cells.push_back(mirrored ? mirror(cell) : cell);
    }
}

void add(SurfaceStatistics& sum, const SurfaceStatistics& part) {
    sum.kind = part.kind;
    sum.steps = std::max(sum.steps, part.steps);
    sum.vertex_steps += part.vertex_steps;
    sum.terminated.domain += part.terminated.domain;
    sum.terminated.time += part.terminated.time;
    sum.terminated.obstacle += part.terminated.obstacle;
    sum.terminated.stagnation += part.terminated.stagnation;
    sum.terminated.budget += part.terminated.budget;
    sum.separation = std::max(sum.separation, part.separation);
    sum.requested_separation = part.requested_separation;
    sum.seconds.load += part.seconds.load;
    sum.seconds.advect += part.seconds.advect;
    sum.seconds.refine += part.seconds.refine;
}

void count(SurfaceStatistics& statistics, const QuadComplex& mesh) {
    statistics.quads = mesh.cells.size();
    statistics.vertices = mesh.vertices();
    statistics.approximated = static_cast<std::uint64_t>(
        std::count(mesh.approximated.begin(), mesh.approximated.end(), 1));
    statistics.max_edge = longest_edge(mesh);
}

} // namespace wakesurf::core
