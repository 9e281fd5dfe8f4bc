#include "core/surface/moving/release.hpp"

#include "core/surface/moving/moving_plan.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wakesurf::core {

namespace {

constexpr double growth_a_step =
    0.5; // of an edge's length: Hermite interpolation wants edges cut before they double
constexpr double least_of_row =
    1.0 / 16.0; // of the time between rows: one violent cell must not stop the others

/// Returns the larger of `most` and the fastest relative growth of a triangle's edges, of those longer than
/// `shortest`. Roots are taken only of what may exceed `most`.
double fastest_growth(const MovingMesh& mesh, const Triangle& t, double shortest, double most) {
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId a = t.begin(k), b = t.end(k);
        const Vec3 edge = mesh.edge(a, b);
        const Vec3 apart(mesh.vertices.velocity[b] - mesh.vertices.velocity[a]);
        const double length2 = glm::dot(edge, edge);
        const double apart2 = glm::dot(apart, apart);
        if (apart2 < most * most * length2 * (1.0 - 1e-9))
            continue;
        if (const double length = std::sqrt(length2); length > shortest)
            most = std::max(most, std::sqrt(apart2) / length);
    }
    return most;
}

} // namespace

double
step_length(const MovingMesh& mesh, double to, double separation, bool releasing, bool refines) {
    const MaterialVertices& v = mesh.vertices;
    double rake_speed = 0.0;
    double speed = 0.0;
    for (VertexId i = 0; i < v.slots(); ++i) {
        if (v.role[i] == VertexRole::Unused || v.dead(i))
            continue;
        const double here = glm::length(v.velocity[i]);
        speed = std::max(speed, here);
        if (v.role[i] == VertexRole::Attached)
            rake_speed = std::max(rake_speed, here);
    }
    const double left = std::abs(to - mesh.time);
    const double driving = releasing && rake_speed > 0.0 ? rake_speed : speed;
    if (!(driving > 0.0))
        return left;
    const double row = row_spacing * separation / driving;
    if (!refines) // nothing is interpolated between what has moved
        return std::min(left, row);
    const auto slots = mesh.triangles.slots();
    const double shortest = 0.1 * separation;
    const double growth = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, slots.size(), 4096), 0.0,
        [&](const auto& range, double most) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                if (slots[i].live)
                    most = fastest_growth(mesh, slots[i], shortest, most);
            return most;
        },
        [](double a, double b) { return std::max(a, b); });
    const double safe = growth > 0.0 ? growth_a_step / growth : row;
    return std::min(left, std::clamp(safe, least_of_row * row, row));
}

std::vector<VertexId> release_row(MovingMesh& mesh) {
    MaterialVertices& v = mesh.vertices;
    std::vector<VertexId> row;
    for (VertexId i = 0; i < v.slots(); ++i) {
        if (v.role[i] != VertexRole::Attached)
            continue;
        if (v.dead(i)) { // inside an obstacle: never to be released, seeded again with the next row
            v.remove(i);
            continue;
        }
        v.role[i] = VertexRole::Free;
        v.end[i] = CurveEnd::Running;
        row.push_back(i);
    }
    std::sort(row.begin(), row.end(),
              [&](VertexId a, VertexId b) { return v.place[a].column < v.place[b].column; });
    return row;
}

std::vector<double> places_behind(const MovingMesh& mesh,
                                  std::span<const VertexId> released,
                                  std::span<const double> usual) {
    std::vector<double> places;
    for (const VertexId v : released)
        places.push_back(mesh.vertices.place[v].column);
    std::vector<double> all = places;
    for (const double place : usual) {
        const auto after = std::lower_bound(places.begin(), places.end(), place);
        const bool near_before = after != places.begin() && place - *(after - 1) < 1.0;
        const bool near_after = after != places.end() && *after - place < 1.0;
        if (!near_before && !near_after)
            all.push_back(place);
    }
    std::sort(all.begin(), all.end());
    return all;
}

void move_attached(MovingMesh& mesh) {
    MaterialVertices& v = mesh.vertices;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (v.role[i] == VertexRole::Attached)
            v.t[i] = v.time[i] = mesh.time;
}

std::uint64_t running(const MovingMesh& mesh) {
    const MaterialVertices& v = mesh.vertices;
    std::uint64_t count = 0;
    for (VertexId i = 0; i < v.slots(); ++i)
        count += v.role[i] == VertexRole::Free && v.end[i] == CurveEnd::Running;
    return count;
}

void count_the_dead(const MovingMesh& mesh,
                    std::uint32_t fresh,
                    SurfaceStatistics::Terminated& terminated) {
    const MaterialVertices& v = mesh.vertices;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (v.role[i] == VertexRole::Free && v.end[i] != CurveEnd::Running && v.id[i] < fresh) {
            terminated.add(v.end[i]);
        }
}

void sort_memory(MovingMesh& mesh, double share) {
    MaterialVertices& v = mesh.vertices;
    const auto before = [&](VertexId a, VertexId b) {
        const LatticePlace p = v.place[a];
        const LatticePlace q = v.place[b];
        return p.row != q.row         ? p.row < q.row
               : p.column != q.column ? p.column < q.column
                                      : v.id[a] < v.id[b];
    };
    std::vector<VertexId> order;
    std::size_t misplaced = 0;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (v.role[i] != VertexRole::Unused) {
            misplaced += !order.empty() && !before(order.back(), i);
            order.push_back(i);
        }
    const auto slots = mesh.triangles.slots();
    const std::size_t holes = slots.size() - mesh.triangles.live() + v.slots() - order.size();
    if (static_cast<double>(misplaced + holes) <= share * static_cast<double>(order.size()))
        return;
    std::sort(order.begin(), order.end(), before);
    std::vector<VertexId> slot_of(v.slots(), no_vertex);
    for (std::size_t i = 0; i < order.size(); ++i)
        slot_of[order[i]] = static_cast<VertexId>(i);

    struct Sorted {
        VertexId first; ///< of its vertices
        std::uint32_t quad;
        TriangleId triangle;
    };

    std::vector<Sorted> triangles;
    for (TriangleId t = 0; t < slots.size(); ++t)
        if (slots[t].live) {
            const auto& [a, b, c] = slots[t].vertex;
            triangles.push_back({std::min({slot_of[a], slot_of[b], slot_of[c]}), slots[t].quad, t});
        }
    std::sort(triangles.begin(), triangles.end(), [](const Sorted& a, const Sorted& b) {
        return std::tie(a.first, a.quad, a.triangle) < std::tie(b.first, b.quad, b.triangle);
    });
    std::vector<TriangleId> triangle_order;
    for (const Sorted& each : triangles)
        triangle_order.push_back(each.triangle);
    mesh.triangles.renumber(triangle_order, slot_of);
    v.renumber(order);
}

} // namespace wakesurf::core
