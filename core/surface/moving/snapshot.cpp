#include "core/surface/moving/snapshot.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// log2 of the area now over the area at release.
float deformation_of(const MaterialVertices& v, VertexId i) {
    const double now = glm::length(glm::cross(v.along_s[i], v.along_t[i]));
    return now > 0.0 && v.birth_area[i] > 0.0f
               ? static_cast<float>(std::log2(now / double(v.birth_area[i])))
               : 0.0f;
}

/// The first two corners are those released last, as those of a cell that the rake has just released.
void turn_to_youngest(const MovingMesh& mesh, Cell& cell) {
    const MaterialVertices& v = mesh.vertices;
    const auto younger = [&](VertexId a, VertexId b) {
        const double t = (v.t[a] - v.t[b]) * -mesh.lattice.facing;
        const double s = mesh.lattice.s_between(v.s[a], v.s[b]);
        return t != 0.0 ? t > 0.0 : s != 0.0 ? s > 0.0 : v.id[a] < v.id[b];
    };
    std::size_t first = 0;
    for (std::size_t k = 1; k < 4; ++k)
        if (younger(cell.corner[k], cell.corner[first]))
            first = k;
    std::rotate(cell.corner.begin(), cell.corner.begin() + static_cast<std::ptrdiff_t>(first),
                cell.corner.end());
    std::rotate(cell.mid.begin(), cell.mid.begin() + static_cast<std::ptrdiff_t>(first),
                cell.mid.end());
}

/// The vertex in the middle of edge k that an odd triangle beyond it is handed out with.
VertexId hanging_beyond(const MaterialTriangles& triangles, TriangleId t, unsigned k) {
    const TriangleId u = triangles[t].across[k];
    return u != no_triangle && triangles[u].odd() && triangles[u].across[triangles[u].mate] == t
               ? triangles[u].hanging
               : no_vertex;
}

/// What a triangle and its other half are handed out as; vertices are slots.
Cell cell_of(const MovingMesh& mesh, TriangleId t) {
    const MaterialTriangles& triangles = mesh.triangles;
    const Triangle& here = triangles[t];
    const unsigned k = here.mate;
    Cell cell;
    if (here.odd()) {
        cell.corner = {here.opposite(k), here.begin(k), here.hanging, here.end(k)};
        cell.mid[0] = hanging_beyond(triangles, t, (k + 2) % 3);
        cell.mid[3] = hanging_beyond(triangles, t, (k + 1) % 3);
    } else {
        const TriangleId u = here.across[k];
        const unsigned j = triangles.facing(t, k);
        cell.corner = {here.begin(k), triangles[u].opposite(j), here.end(k), here.opposite(k)};
        cell.mid = {
            hanging_beyond(triangles, u, (j + 1) % 3), hanging_beyond(triangles, u, (j + 2) % 3),
            hanging_beyond(triangles, t, (k + 1) % 3), hanging_beyond(triangles, t, (k + 2) % 3)};
    }
    turn_to_youngest(mesh, cell);
    return cell;
}

} // namespace

KeyedMesh snapshot(const MovingMesh& mesh, bool deformation, std::span<const float> error) {
    const MaterialVertices& v = mesh.vertices;
    const auto slots = mesh.triangles.slots();
    std::vector<std::uint8_t> used(v.slots(), 0);

    /// What is called so is in that slot: of two halves of a quad the first.
    struct Named {
        std::uint32_t name, slot;
    };

    std::vector<Named> vertices, cells;
    cells.reserve(slots.size() / 2);
    for (TriangleId t = 0; t < slots.size(); ++t)
        if (slots[t].live) {
            for (const VertexId k : slots[t].vertex)
                used[k] = 1;
            if (slots[t].odd())
                used[slots[t].hanging] = 1;
            if (slots[t].odd() || t < slots[t].across[slots[t].mate])
                cells.push_back({slots[t].quad, t});
        }
    for (VertexId i = 0; i < v.slots(); ++i)
        if (used[i] != 0)
            vertices.push_back({v.id[i], i});
    for (auto* things : {&vertices, &cells})
        radix_sort(*things, [](const Named& thing) { return thing.name; });

    KeyedMesh out;
    out.time = mesh.time;
    std::vector<VertexId> place(v.slots(), no_vertex);
    const std::size_t count = vertices.size();
    out.vertex_id.resize(count);
    out.mesh.position.resize(count);
    out.mesh.s.resize(count);
    out.mesh.t.resize(count);
    out.mesh.velocity.resize(count);
    out.mesh.approximated.resize(count);
    out.mesh.deformation.resize(deformation ? count : 0);
    out.mesh.error.resize(error.empty() ? 0 : count);
    for_each_index(count, [&](std::size_t k) {
        const auto [name, i] = vertices[k];
        place[i] = static_cast<VertexId>(k);
        out.vertex_id[k] = name;
        out.mesh.position[k] = v.position[i];
        out.mesh.s[k] = v.s[i];
        out.mesh.t[k] = v.t[i];
        out.mesh.velocity[k] = v.velocity[i];
        if (deformation)
            out.mesh.deformation[k] = deformation_of(v, i);
        out.mesh.approximated[k] = v.approximated[i];
        if (!error.empty())
            out.mesh.error[k] = error[i];
    });
    out.cell_id.resize(cells.size());
    out.mesh.cells.resize(cells.size());
    for_each_index(cells.size(), [&](std::size_t k) {
        Cell cell = cell_of(mesh, cells[k].slot);
        for (auto* ids : {&cell.corner, &cell.mid})
            for (VertexId& id : *ids)
                if (id != no_vertex)
                    id = place[id];
        out.cell_id[k] = cells[k].name;
        out.mesh.cells[k] = cell;
    });
    label_components(out.mesh);
    return out;
}

std::string violation(const MovingMesh& mesh) {
    if (std::string found = mesh.triangles.violation(); !found.empty())
        return found;
    const auto slots = mesh.triangles.slots();
    const auto at = [](TriangleId t, const char* what) {
        return "triangle " + std::to_string(t) + " " + what;
    };
    for (TriangleId t = 0; t < slots.size(); ++t) {
        if (!slots[t].live)
            continue;
        const auto& [a, b, c] = slots[t].vertex;
        for (const VertexId v : slots[t].vertex)
            if (v >= mesh.vertices.slots() || mesh.vertices.role[v] == VertexRole::Unused)
                return at(t, "names a vertex that does not exist");
        if (slots[t].mate == Triangle::alone)
            return at(t, "is not handed out");
        if (has_dead_vertex(mesh, t))
            return at(t, "has a dead vertex");
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
            if (!(mesh.edge_length(p, q) > 0.0))
                return at(t, "has an edge of no length");
        if (!(material_area(mesh, a, b, c) >= 0.0)) // zero: within rounding
            return at(t, "is turned over in (s, t)");
    }
    return snapshot(mesh, false).mesh.validate();
}

} // namespace wakesurf::core
