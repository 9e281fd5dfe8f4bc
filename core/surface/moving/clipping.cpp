#include "core/surface/moving/clipping.hpp"

#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr double thin = 0.2; ///< quality
/// The limits are in separations.
constexpr double tear_rim = 0.15;
constexpr double filament = 0.04;

/// A triangle that spans so much of the rake belongs to a sheet that was released as narrow as it is.
constexpr double whole_sheet = 0.2;

constexpr double sharp = 0.87; ///< cosine: 30 degrees

constexpr std::size_t speck = 24;      ///< triangles
constexpr std::size_t much_larger = 4; ///< times

/// Returns whether a triangle has two sides on the boundary that meet at a sharp angle: what tears leave is
/// not to be ragged.
bool is_tooth(const MovingMesh& mesh, TriangleId t) {
    const Triangle& here = mesh.triangles[t];
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned before = (k + 2) % 3;
        if (here.across[k] == no_triangle && here.across[before] == no_triangle &&
            cosine_between(mesh.edge(here.begin(k), here.end(k)),
                           mesh.edge(here.begin(k), here.begin(before)), -1.0) > sharp)
            return true;
    }
    return false;
}

bool may_erode(const RefinementContext& context, TriangleId t, std::vector<TriangleId>& ring) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    unsigned open = 0;
    bool rim = false;
    for (unsigned k = 0; k < 3; ++k)
        if (here.across[k] == no_triangle) {
            ++open;
            rim = rim || on_rectangle_border(mesh, here.begin(k), here.end(k));
        }
    if (open == 0 || has_attached_vertex(mesh, t))
        return false;
    // The surface's boundary goes round by the vertex opposite.
    const auto& [a, b, c] = here.vertex;
    if (is_web(mesh, a, b, c))
        return true;
    const double span =
        std::max({std::abs(mesh.parameter_step(a, b).s), std::abs(mesh.parameter_step(b, c).s),
                  std::abs(mesh.parameter_step(c, a).s)});
    if (span > whole_sheet)
        return false;
    if (open > 1 && !rim && is_tooth(mesh, t))
        return true;
    if (!(quality(mesh, t) < thin))
        return false;
    const unsigned k = longest_edge_of(mesh, t);
    const double length = mesh.edge_length(here.begin(k), here.end(k));
    const double width = rim ? filament : tear_rim;
    if (!(glm::length(area_vector(mesh, t)) <= length * width * context.rules.separation))
        return false;
    if (open > 1)
        return true;
    // With its foot on the boundary it is a needle that a join takes away; with its tip there two parts would
    // hang together at that.
    return here.across[k] == no_triangle && !mesh.triangles.fan(here.opposite(k), ring);
}

} // namespace

std::vector<EdgeCrossing> edges_to_the_dead(const RefinementContext& context,
                                            std::span<const TriangleId> candidates) {
    const MovingMesh& mesh = context.mesh;
    const auto& ids = mesh.vertices.id;
    std::vector<EdgeCrossing> edges;
    for (const TriangleId t : candidates) {
        if (!mesh.triangles[t].live)
            continue;
        for (unsigned k = 0; k < 3; ++k) {
            const VertexId a = mesh.triangles[t].begin(k), b = mesh.triangles[t].end(k);
            if (mesh.vertices.dead(a) != mesh.vertices.dead(b))
                edges.push_back(mesh.vertices.dead(a) ? EdgeCrossing{b, a} : EdgeCrossing{a, b});
        }
    }
    const auto key = [&](const EdgeCrossing& e) { return std::pair(ids[e.living], ids[e.dead]); };
    std::sort(edges.begin(), edges.end(),
              [&](const EdgeCrossing& p, const EdgeCrossing& q) { return key(p) < key(q); });
    edges.erase(
        std::unique(edges.begin(), edges.end(),
                    [&](const EdgeCrossing& p, const EdgeCrossing& q) { return key(p) == key(q); }),
        edges.end());
    return edges;
}

void clip(const RefinementContext& context,
          std::span<const TriangleId> candidates,
          std::span<const EdgeCrossing> crossings,
          const std::function<VertexId(const EdgeCrossing& crossing)>& insert) {
    MovingMesh& mesh = context.mesh;
    MaterialTriangles& triangles = mesh.triangles;
    std::vector<VertexId> dead;
    for (const TriangleId t : candidates)
        if (triangles[t].live)
            for (const VertexId v : triangles[t].vertex)
                if (mesh.vertices.dead(v))
                    dead.push_back(v);
    for (const EdgeCrossing& crossing : crossings) {
        if (!crossing.found)
            continue;
        auto there = triangles.find(crossing.living, crossing.dead);
        if (there.triangle == no_triangle)
            there = triangles.find(crossing.dead, crossing.living);
        if (there.triangle != no_triangle)
            triangles.split(there.triangle, there.k, insert(crossing));
    }
    const auto& ids = mesh.vertices.id;
    std::sort(dead.begin(), dead.end(), [&](VertexId a, VertexId b) { return ids[a] < ids[b]; });
    dead.erase(std::unique(dead.begin(), dead.end()), dead.end());
    std::vector<TriangleId> round;
    for (const VertexId v : dead)
        if (!triangles.unused(v)) {
            triangles.fan(v, round);
            for (const TriangleId t : round)
                if (triangles[t].live)
                    triangles.tear(t);
        }
}

void erode(const RefinementContext& context, std::span<const TriangleId> candidates) {
    MaterialTriangles& triangles = context.mesh.triangles;
    if (triangles.live() <= speck) // the whole surface is as small as that
        return;
    std::vector<TriangleId> queue(candidates.begin(), candidates.end()), ring;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const TriangleId t = queue[i];
        if (!triangles[t].live || !may_erode(context, t, ring))
            continue;
        for (const TriangleId next : triangles[t].across)
            if (next != no_triangle)
                queue.push_back(next);
        triangles.tear(t);
    }
}

void drop_specks(const RefinementContext& context, std::span<const TriangleId> candidates) {
    MaterialTriangles& triangles = context.mesh.triangles;
    std::vector<TriangleId> part;
    for (const TriangleId first : candidates) {
        const auto& across = triangles[first].across; // what has come off has a border
        if (!triangles[first].live ||
            std::find(across.begin(), across.end(), no_triangle) == across.end())
            continue;
        part.assign(1, first);
        bool held = false;
        for (std::size_t i = 0; i < part.size() && part.size() < speck && !held; ++i) {
            held = has_attached_vertex(context.mesh, part[i]);
            for (const TriangleId next : triangles[part[i]].across)
                if (next != no_triangle && std::find(part.begin(), part.end(), next) == part.end())
                    part.push_back(next);
        }
        if (held || part.size() >= speck || part.size() * much_larger > triangles.live())
            continue;
        for (const TriangleId t : part)
            if (triangles[t].live)
                triangles.tear(t);
    }
}

} // namespace wakesurf::core
