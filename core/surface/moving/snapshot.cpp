#include "core/surface/moving/snapshot.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Returns log2 of the area now over the area at release.
float deformation_of(const MaterialVertices& v, VertexId i) {
    const double now = glm::length(glm::cross(v.along_s[i], v.along_t[i]));
    return now > 0.0 && v.birth_area[i] > 0.0f
               ? static_cast<float>(std::log2(now / double(v.birth_area[i])))
               : 0.0f;
}

using CellCorners = std::array<VertexId, 4>;

/// The place of the element with an id.
struct Named {
    std::uint32_t name, place;
};

void sort_by_name(std::vector<Named>& things) {
    radix_sort(things, [](const Named& thing) { return thing.name; });
}

/// The quads of the triangles, in the order of their slots.
struct Quads {
    std::vector<CellCorners> corners; ///< slots
    std::vector<Named> names;
    std::vector<TriangleId> odd;
};

/// Visits each triangle once, in the order they have in memory: visiting from each quad's first half its
/// second, and the vertices that hang on its sides, took more than twice as long.
Quads quads_of(const MaterialTriangles& triangles) {
    const auto slots = triangles.slots();
    Quads quads;
    quads.corners.reserve(triangles.quads());
    quads.names.reserve(triangles.quads());
    std::vector<std::uint32_t> quad(slots.size()); // of first halves
    for (TriangleId t = 0; t < slots.size(); ++t) {
        const Triangle& here = slots[t];
        if (!here.live)
            continue;
        const unsigned k = here.mate;
        if (!here.odd() && here.across[k] < t) {
            quads.corners[quad[here.across[k]]][1] = here.opposite(k);
            continue;
        }
        quad[t] = static_cast<std::uint32_t>(quads.corners.size());
        quads.names.push_back({here.quad, quad[t]});
        if (here.odd()) {
            quads.odd.push_back(t);
            quads.corners.push_back(
                {here.opposite(k), here.begin(k), triangles.hanging(t), here.end(k)});
        } else {
            quads.corners.push_back({here.begin(k), no_vertex, here.end(k), here.opposite(k)});
        }
    }
    return quads;
}

/// The slots of vertices that are handed out, in the order of ids.
std::vector<Named> vertices_of(const MovingMesh& mesh, std::span<const TriangleId> odd) {
    const MaterialVertices& v = mesh.vertices;
    std::vector<std::uint8_t> hanging(v.slots(), 0);
    for (const TriangleId t : odd)
        hanging[mesh.triangles.hanging(t)] = 1;
    std::vector<Named> vertices;
    vertices.reserve(v.slots());
    for (VertexId i = 0; i < v.slots(); ++i)
        if (hanging[i] != 0 || !mesh.triangles.unused(i))
            vertices.push_back({v.id[i], i});
    sort_by_name(vertices);
    return vertices;
}

/// Returns the corner of a quad that was released last. No two have the same s and t.
std::size_t youngest(const MovingMesh& mesh, const CellCorners& corner) {
    const MaterialVertices& v = mesh.vertices;
    const auto younger = [&](std::size_t i, std::size_t k) {
        const VertexId a = corner[i], b = corner[k];
        const double t = (v.t[b] - v.t[a]) * -mesh.rectangle.facing;
        const double s = mesh.rectangle.s_between(v.s[b], v.s[a]);
        // This has no branches: they would be unpredictable.
        return i + (k - i) * static_cast<std::size_t>((t > 0.0) | (!(t < 0.0) & (s > 0.0)));
    };
    return younger(younger(0, 1), younger(2, 3));
}

/// Hangs the vertex in the middle of an odd triangle's edge on the cell beyond, where there is one.
void hang(const MovingMesh& mesh, TriangleId t, std::span<const VertexId> place, KeyedMesh& out) {
    const Triangle& odd = mesh.triangles[t];
    const TriangleId beyond = odd.across[odd.mate];
    if (beyond == no_triangle)
        return;
    const auto id =
        std::lower_bound(out.cell_id.begin(), out.cell_id.end(), mesh.triangles[beyond].quad);
    Cell& cell = out.mesh.cells[static_cast<std::size_t>(id - out.cell_id.begin())];
    for (std::size_t k = 0; k < 4; ++k)
        if (cell.corner[k] == place[odd.end(odd.mate)] &&
            cell.corner[(k + 1) % 4] == place[odd.begin(odd.mate)])
            cell.mid[k] = place[mesh.triangles.hanging(t)];
}

} // namespace

KeyedMesh snapshot(const MovingMesh& mesh,
                   const ShownArrays& arrays,
                   const StepErrors* errors,
                   double errors_until) {
    Quads quads = quads_of(mesh.triangles);
    const MaterialVertices& v = mesh.vertices;
    std::vector<VertexId> place(v.slots(), no_vertex);
    std::size_t count = 0;
    for (const Named& vertex : vertices_of(mesh, quads.odd))
        place[vertex.place] = static_cast<VertexId>(count++);

    KeyedMesh out;
    out.time = mesh.time;
    out.vertex_id.resize(count);
    out.mesh.position.resize(count);
    out.mesh.s.resize(count);
    out.mesh.t.resize(count);
    out.mesh.velocity.resize(count);
    out.mesh.approximated.resize(count);
    out.mesh.deformation.resize(arrays.deformation ? count : 0);
    out.mesh.tangents.resize(arrays.tangents ? count : 0);
    out.mesh.error.resize(errors != nullptr ? count : 0);
    for_each_index(v.slots(), [&](std::size_t slot) {
        const auto i = static_cast<VertexId>(slot);
        const VertexId k = place[i];
        if (k == no_vertex)
            return;
        out.vertex_id[k] = v.id[i];
        out.mesh.position[k] = v.position[i];
        out.mesh.s[k] = v.s[i];
        out.mesh.t[k] = v.t[i];
        out.mesh.velocity[k] = v.velocity[i];
        out.mesh.approximated[k] = v.approximated[i];
        if (arrays.deformation)
            out.mesh.deformation[k] = deformation_of(v, i);
        if (arrays.tangents)
            out.mesh.tangents[k] = v.tangents(i);
        if (errors != nullptr)
            out.mesh.error[k] = stated_error(mesh, i, *errors, errors_until);
    });

    // The first two corners are those released last, as those of a cell that the rake has just released.
    for_each_index(quads.corners.size(), [&](std::size_t k) {
        const CellCorners slots = quads.corners[k];
        const std::size_t first = youngest(mesh, slots);
        for (std::size_t i = 0; i < 4; ++i)
            quads.corners[k][i] = place[slots[(first + i) % 4]];
    });
    sort_by_name(quads.names);
    out.cell_id.resize(quads.names.size());
    out.mesh.cells.resize(quads.names.size());
    for_each_index(quads.names.size(), [&](std::size_t k) {
        out.cell_id[k] = quads.names[k].name;
        out.mesh.cells[k].corner = quads.corners[quads.names[k].place];
    });
    for (const TriangleId t : quads.odd)
        hang(mesh, t, place, out);
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
    return snapshot(mesh, {}).mesh.validate();
}

} // namespace wakesurf::core
