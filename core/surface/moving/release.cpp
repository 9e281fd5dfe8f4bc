#include "core/surface/moving/release.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

bool from_seed(const MaterialVertices& v, VertexId i) {
    const LatticePlace at = v.place[i];
    return at.column == std::floor(at.column) && at.row == std::floor(at.row);
}

std::uint64_t running_seeds(const MovingMesh& mesh) {
    const MaterialVertices& v = mesh.vertices;
    std::uint64_t count = 0;
    for (VertexId i = 0; i < v.slots(); ++i)
        count += v.role[i] == VertexRole::Free && v.end[i] == CurveEnd::Running && from_seed(v, i);
    return count;
}

void carry_on_the_dead(MovingMesh& mesh, SurfaceStatistics::Terminated& terminated) {
    MaterialVertices& v = mesh.vertices;
    for (VertexId i = 0; i < v.slots(); ++i) {
        if (v.role[i] != VertexRole::Free || v.end[i] == CurveEnd::Running ||
            v.time[i] == mesh.time)
            continue;
        v.position[i] += Vec3(v.velocity[i]) * (mesh.time - v.time[i]);
        v.time[i] = mesh.time;
        if (!from_seed(v, i))
            continue;
        terminated.domain += v.end[i] == CurveEnd::Domain;
        terminated.obstacle += v.end[i] == CurveEnd::Obstacle;
        terminated.stagnation += v.end[i] == CurveEnd::Stagnation;
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
    const auto slots = mesh.quads.slots();
    const std::size_t holes = slots.size() - mesh.quads.live() + v.slots() - order.size();
    if (static_cast<double>(misplaced + holes) <= share * static_cast<double>(order.size()))
        return;
    std::sort(order.begin(), order.end(), before);
    std::vector<VertexId> slot_of(v.slots(), no_vertex);
    for (std::size_t i = 0; i < order.size(); ++i)
        slot_of[order[i]] = static_cast<VertexId>(i);
    std::vector<CellIndex> cells;
    for (CellIndex i = 0; i < slots.size(); ++i)
        if (slots[i].live)
            cells.push_back(i);
    std::sort(cells.begin(), cells.end(), [&](CellIndex a, CellIndex b) {
        const VertexId p = slot_of[slots[a].cell.corner[0]];
        const VertexId q = slot_of[slots[b].cell.corner[0]];
        return p != q ? p < q : slots[a].id < slots[b].id;
    });
    mesh.quads.renumber(cells, slot_of);
    v.renumber(order);
}

} // namespace wakesurf::core
