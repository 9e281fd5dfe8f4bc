#include "core/surface/moving/surface_tangents.hpp"

namespace wakesurf::core {

SurfaceTangents tangents_in(const MovingMesh& mesh, const Cell& cell, std::size_t corner) {
    const MaterialVertices& v = mesh.vertices;
    const VertexId here = cell.corner[corner];
    const VertexId across = cell.corner[corner ^ 1u];
    const VertexId along = cell.corner[3 - corner];
    const double s_across = mesh.lattice.s_between(v.s[here], v.s[across]);
    const double s_along = mesh.lattice.s_between(v.s[here], v.s[along]);
    const double t_across = v.t[across] - v.t[here];
    const double t_along = v.t[along] - v.t[here];
    const double det = s_across * t_along - s_along * t_across;
    if (det == 0.0)
        return {Vec3(0.0), Vec3(0.0)};
    const Vec3 edge_across = v.position[across] - v.position[here];
    const Vec3 edge_along = v.position[along] - v.position[here];
    return {(t_along * edge_across - t_across * edge_along) / det,
            (s_across * edge_along - s_along * edge_across) / det};
}

MeshTangents::MeshTangents(const MovingMesh& mesh, bool carried) : mesh_(mesh), carried_(carried) {
    if (carried_)
        return;
    cell_of_.assign(mesh.vertices.slots(), no_cell);
    const auto slots = mesh.quads.slots();
    for (CellIndex i = 0; i < slots.size(); ++i)
        if (slots[i].live)
            for (const VertexId v : slots[i].cell.corner)
                cell_of_[v] = i;
    for (CellIndex i = 0; i < slots.size();
         ++i) // what hangs on the surface's boundary is nobody's corner
        if (slots[i].live)
            for (const VertexId v : slots[i].cell.mid)
                if (v != no_vertex && cell_of_[v] == no_cell)
                    cell_of_[v] = i;
}

SurfaceTangents MeshTangents::at(VertexId v) const {
    if (carried_)
        return {mesh_.vertices.along_s[v], mesh_.vertices.along_t[v]};
    if (cell_of_[v] == no_cell)
        return {Vec3(0.0), Vec3(0.0)};
    const Cell& cell = mesh_.quads[cell_of_[v]].cell;
    for (std::size_t k = 0; k < 4; ++k)
        if (cell.corner[k] == v)
            return tangents_in(mesh_, cell, k);
    std::size_t side = 0;
    while (cell.mid[side] != v)
        ++side;
    const SurfaceTangents p = tangents_in(mesh_, cell, side);
    const SurfaceTangents q = tangents_in(mesh_, cell, (side + 1) % 4);
    return {0.5 * (p.s + q.s), 0.5 * (p.t + q.t)};
}

} // namespace wakesurf::core
