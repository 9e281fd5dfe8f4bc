#include "core/surface/moving/snapshot.hpp"

#include "core/surface/moving/cell_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wakesurf::core {

namespace {

/// log2 of the area now over the area at release.
float deformation_of(const MaterialVertices& v, VertexId i) {
    const double now = glm::length(glm::cross(v.along_s[i], v.along_t[i]));
    return now > 0.0 && v.birth_area[i] > 0.0f
               ? static_cast<float>(std::log2(now / double(v.birth_area[i])))
               : 0.0f;
}

bool answered(const LinkedQuads& quads, CellIndex cell, const SubEdge& edge) {
    const CellIndex neighbour = quads[cell].across[edge.side][edge.half];
    if (neighbour == no_cell)
        return true;
    if (neighbour >= quads.slots().size() || !quads[neighbour].live)
        return false;
    for (const SubEdge& facing : outline(quads[neighbour].cell))
        if (facing.from == edge.to && facing.to == edge.from)
            return quads[neighbour].across[facing.side][facing.half] == cell;
    return false;
}

} // namespace

KeyedMesh snapshot(const MovingMesh& mesh, bool deformation, std::span<const float> error) {
    const MaterialVertices& v = mesh.vertices;
    const auto slots = mesh.quads.slots();
    std::vector<std::uint8_t> used(v.slots(), 0);
    std::vector<CellIndex> cells;
    for (CellIndex i = 0; i < slots.size(); ++i)
        if (slots[i].live) {
            cells.push_back(i);
            for_each_vertex(slots[i].cell, [&](VertexId k) { used[k] = 1; });
        }
    std::vector<VertexId> vertices;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (used[i] != 0)
            vertices.push_back(i);
    std::sort(vertices.begin(), vertices.end(),
              [&](VertexId a, VertexId b) { return v.id[a] < v.id[b]; });
    std::sort(cells.begin(), cells.end(),
              [&](CellIndex a, CellIndex b) { return slots[a].id < slots[b].id; });

    KeyedMesh out;
    out.time = mesh.time;
    std::vector<VertexId> place(v.slots(), no_vertex);
    for (const VertexId i : vertices) {
        place[i] = static_cast<VertexId>(out.vertex_id.size());
        out.vertex_id.push_back(v.id[i]);
        out.mesh.position.push_back(v.position[i]);
        out.mesh.s.push_back(v.s[i]);
        out.mesh.t.push_back(v.t[i]);
        out.mesh.velocity.push_back(v.velocity[i]);
        if (deformation)
            out.mesh.deformation.push_back(deformation_of(v, i));
        out.mesh.approximated.push_back(v.approximated[i]);
        if (!error.empty())
            out.mesh.error.push_back(error[i]);
    }
    for (const CellIndex i : cells) {
        Cell cell = slots[i].cell;
        for (auto* ids : {&cell.corner, &cell.mid})
            for (VertexId& k : *ids)
                if (k != no_vertex)
                    k = place[k];
        out.cell_id.push_back(slots[i].id);
        out.mesh.cells.push_back(cell);
    }
    label_components(out.mesh);
    return out;
}

std::string violation(const MovingMesh& mesh) {
    const auto slots = mesh.quads.slots();
    const auto at = [](CellIndex i, const char* what) {
        return "cell slot " + std::to_string(i) + " " + what;
    };
    for (CellIndex i = 0; i < slots.size(); ++i) {
        if (!slots[i].live)
            continue;
        for (const SubEdge& edge : outline(slots[i].cell)) {
            if (edge.from >= mesh.vertices.slots() ||
                mesh.vertices.role[edge.from] == VertexRole::Unused)
                return at(i, "names a vertex that does not exist");
            if (mesh.vertices.dead(edge.from))
                return at(i, "has a dead vertex");
            if (!(mesh.edge_length(edge.from, edge.to) > 0.0))
                return at(i, "has an edge of no length");
            if (!answered(mesh.quads, i, edge))
                return at(i, "is not known to a neighbour it knows");
        }
    }
    return snapshot(mesh, false).mesh.validate();
}

} // namespace wakesurf::core
