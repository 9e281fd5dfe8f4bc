#include "core/surface/moving/release.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/moving_plan.hpp"

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
    const auto fastest = [&](auto counts) {
        return largest(v.slots(), 0.0, [&](std::size_t i, double) {
            return counts(v.role[i]) && !v.dead(static_cast<VertexId>(i))
                       ? double(glm::length(v.velocity[i]))
                       : 0.0;
        });
    };
    const double rake_speed =
        releasing ? fastest([](VertexRole role) { return role == VertexRole::Attached; }) : 0.0;
    const double left = std::abs(to - mesh.time);
    const double driving =
        rake_speed > 0.0 ? rake_speed
                         : fastest([](VertexRole role) { return role != VertexRole::Unused; });
    if (!(driving > 0.0))
        return left;
    const double row = row_spacing * separation / driving;
    if (!refines) // nothing is interpolated between what has moved
        return std::min(left, row);
    const auto slots = mesh.triangles.slots();
    const double shortest = 0.1 * separation;
    const double growth = largest(slots.size(), 0.0, [&](std::size_t i, double most) {
        return slots[i].live ? fastest_growth(mesh, slots[i], shortest, most) : most;
    });
    const double safe = growth > 0.0 ? growth_a_step / growth : row;
    return std::min(left, std::clamp(safe, least_of_row * row, row));
}

std::vector<VertexId> attached(const MovingMesh& mesh) {
    const auto& role = mesh.vertices.role;
    return gather<VertexId>(
        role.size(),
        [&](std::size_t i, std::vector<VertexId>& found) {
            if (role[i] == VertexRole::Attached)
                found.push_back(static_cast<VertexId>(i));
        },
        16384);
}

std::vector<VertexId> release_row(MovingMesh& mesh) {
    MaterialVertices& v = mesh.vertices;
    std::vector<VertexId> row;
    for (const VertexId i : attached(mesh)) {
        if (v.dead(i)) { // inside an obstacle: never to be released, seeded again with the next row
            v.remove(i);
            continue;
        }
        v.role[i] = VertexRole::Free;
        v.end[i] = CurveEnd::Running;
        row.push_back(i);
    }
    v.fresh().insert(v.fresh().end(), row.begin(), row.end());
    std::sort(row.begin(), row.end(), [&](VertexId a, VertexId b) { return v.s[a] < v.s[b]; });
    return row;
}

std::vector<double>
seeds_behind(const MovingMesh& mesh, std::span<const VertexId> released, const MovingPlan& plan) {
    std::vector<double> seeds, columns;
    for (const VertexId v : released) {
        seeds.push_back(mesh.vertices.s[v]);
        columns.push_back(plan.columns.column(seeds.back()));
    }
    std::vector<double> all = seeds;
    for (const double seed : plan.seeds) {
        const double column = plan.columns.column(seed);
        const auto after = std::lower_bound(columns.begin(), columns.end(), column);
        const bool near_before = after != columns.begin() && column - *(after - 1) < 1.0;
        const bool near_after = after != columns.end() && *after - column < 1.0;
        if (!near_before && !near_after)
            all.push_back(seed);
    }
    std::sort(all.begin(), all.end());
    return all;
}

void move_attached(MovingMesh& mesh) {
    MaterialVertices& v = mesh.vertices;
    for (const VertexId i : attached(mesh))
        v.t[i] = v.time[i] = mesh.time;
}

std::uint64_t running(const MovingMesh& mesh) {
    const MaterialVertices& v = mesh.vertices;
    std::uint64_t count = 0;
    for (VertexId i = 0; i < v.slots(); ++i)
        count += v.running(i);
    return count;
}

void count_the_dead(const MovingMesh& mesh,
                    std::uint32_t fresh,
                    SurfaceStatistics::Terminated& terminated) {
    const MaterialVertices& v = mesh.vertices;
    const auto ends = gather<CurveEnd>(v.slots(), [&](std::size_t i, std::vector<CurveEnd>& found) {
        if (v.role[i] == VertexRole::Free && v.end[i] != CurveEnd::Running && v.id[i] < fresh)
            found.push_back(v.end[i]);
    });
    for (const CurveEnd end : ends)
        terminated.add(end);
}

void sort_memory(MovingMesh& mesh, double share) {
    MaterialVertices& v = mesh.vertices;
    const bool ascending = mesh.rectangle.patch || mesh.rectangle.facing < 0.0;
    const auto before = [&](VertexId a, VertexId b) {
        return v.t[a] != v.t[b]   ? (v.t[a] < v.t[b]) == ascending
               : v.s[a] != v.s[b] ? v.s[a] < v.s[b]
                                  : v.id[a] < v.id[b];
    };
    using Vertices = std::vector<VertexId>;
    Vertices order = gather<VertexId>(v.slots(), [&](std::size_t i, Vertices& found) {
        if (v.role[i] != VertexRole::Unused)
            found.push_back(static_cast<VertexId>(i));
    });
    const auto jumps = gather<VertexId>(order.size(), [&](std::size_t i, Vertices& found) {
        if (i > 0 && !before(order[i - 1], order[i]))
            found.push_back(order[i]);
    });
    const std::size_t misplaced = jumps.size();
    const auto slots = mesh.triangles.slots();
    const std::size_t holes = slots.size() - mesh.triangles.live() + v.slots() - order.size();
    if (static_cast<double>(misplaced + holes) <= share * static_cast<double>(order.size()))
        return;
    sort_all(order, before);
    std::vector<VertexId> slot_of(v.slots(), no_vertex);
    for_each_index(order.size(),
                   [&](std::size_t i) { slot_of[order[i]] = static_cast<VertexId>(i); });

    struct Sorted {
        VertexId first; ///< of its vertices
        std::uint32_t quad;
        TriangleId triangle;
    };

    auto sorted = gather<Sorted>(slots.size(), [&](std::size_t t, std::vector<Sorted>& found) {
        const auto& [a, b, c] = slots[t].vertex;
        if (slots[t].live)
            found.push_back({std::min({slot_of[a], slot_of[b], slot_of[c]}), slots[t].quad,
                             static_cast<TriangleId>(t)});
    });
    sort_all(sorted, [](const Sorted& a, const Sorted& b) {
        return std::tie(a.first, a.quad, a.triangle) < std::tie(b.first, b.quad, b.triangle);
    });
    std::vector<TriangleId> triangle_order(sorted.size());
    for_each_index(sorted.size(), [&](std::size_t i) { triangle_order[i] = sorted[i].triangle; });
    mesh.triangles.renumber(triangle_order, slot_of);
    v.renumber(order);
}

} // namespace wakesurf::core
