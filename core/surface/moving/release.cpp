#include "core/surface/moving/release.hpp"

#include <algorithm>
#include <tuple>

namespace wakesurf::core {

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
