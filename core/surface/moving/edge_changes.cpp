#include "core/surface/moving/edge_changes.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/edit_round.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace wakesurf::core {

namespace {

/// Cosine of the angle at which two new triangles may meet, unless the old ones met at a larger one.
constexpr double least_flat = 0.766; // 40 degrees
constexpr double sliver = 0.1;       ///< quality

/// Returns the cotangent of an angle by squared lengths: of the two sides at it, and of the third.
double cotangent(double p, double q, double across) {
    const double twice_dot = p + q - across;
    return twice_dot /
           std::sqrt(std::max(4.0 * p * q - twice_dot * twice_dot, 1e-12 * p * q + 1e-300));
}

} // namespace

bool should_flip(const RefinementContext& context, TriangleId t, unsigned k) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    const TriangleId u = here.across[k];
    if (u == no_triangle)
        return false;
    const VertexId a = here.begin(k), b = here.end(k), c = here.opposite(k);
    const VertexId d = mesh.triangles.opposite_beyond(t, k);
    if (c == d)
        return false;
    const double ab = squared_length(mesh, a, b);
    const double ac = squared_length(mesh, a, c), bc = squared_length(mesh, b, c);
    const double ad = squared_length(mesh, a, d), bd = squared_length(mesh, b, d);
    const double cd = squared_length(mesh, c, d);
    const bool delaunay = !(cotangent(ac, bc, ab) + cotangent(ad, bd, ab) < -1e-3);
    const int bridging_before = is_bridging(mesh, a, b, c) + is_bridging(mesh, b, a, d);
    if (delaunay && bridging_before == 0)
        return false;
    const int bridging_after = is_bridging(mesh, a, d, c) + is_bridging(mesh, d, b, c);
    if (bridging_after > bridging_before)
        return false;
    const Vec3 old_t = area_vector(mesh, a, b, c), old_u = area_vector(mesh, b, a, d);
    const Vec3 new_t = area_vector(mesh, a, d, c), new_u = area_vector(mesh, d, b, c);
    const double before = std::min(quality_of(squared(old_t), ab + bc + ac),
                                   quality_of(squared(old_u), ab + ad + bd));
    const double after = std::min(quality_of(squared(new_t), ad + cd + ac),
                                  quality_of(squared(new_u), bd + bc + cd));
    if (bridging_after == bridging_before) {
        if (delaunay || !(after > before)) // on an uneven surface it might go on for ever
            return false;
        if (cd > context.squared_separation() && cd > ab * (1.0 - 1e-9))
            return false;
    }
    if (!(material_area(mesh, a, d, c) > least_material) ||
        !(material_area(mesh, d, b, c) > least_material))
        return false;
    const double flat_before = cosine_between(old_t, old_u, 0.0);
    const double flat_after = cosine_between(new_t, new_u, -1.0);
    if (bridging_after == bridging_before && flat_after < std::min(least_flat, flat_before) &&
        !(before < sliver && flat_after > 0.0))
        return false;
    if (mesh.rectangle.closed && std::abs(mesh.parameter_step(c, d).s) > 0.3)
        return false; // the short way round would not be the surface's
    // It would be cut again, and joined again, in every step.
    if (bridging_after == bridging_before && bulges(context, c, d, 0.8) &&
        squared(edge_bend(mesh, c, d)) > squared(edge_bend(mesh, a, b)))
        return false;
    return !crosses_obstacle(context, c, d, cd) &&
           mesh.triangles.find(c, d).triangle == no_triangle &&
           mesh.triangles.find(d, c).triangle == no_triangle;
}

void flip_all(const RefinementContext& context, std::vector<TriangleId>& queue) {
    struct Flip {
        TriangleId t, u;
        unsigned k;
    };

    MaterialTriangles& triangles = context.mesh.triangles;
    triangles.claims().make_room(context.mesh.vertices.slots());
    const auto ask = [&](std::size_t i, std::vector<VertexId>& claimed) -> std::optional<Flip> {
        const TriangleId t = queue[i];
        for (unsigned k = 0; k < 3 && triangles[t].live; ++k)
            if (should_flip(context, t, k)) {
                const auto& [a, b, c] = triangles[t].vertex;
                claimed.insert(claimed.end(), {a, b, c, triangles.opposite_beyond(t, k)});
                return Flip{t, triangles[t].across[k], k};
            }
        return std::nullopt;
    };
    // Where an edge is turned, those beside it may be worth it next.
    std::size_t left = queue.size() * 20 + 1000;
    for (int round = 0; !queue.empty() && left > 0 && !context.stop.stop_requested(); ++round) {
        const auto flips =
            edit_round<Flip>(round, queue.size(), triangles, ask, numbers_nothing, prepares_nothing,
                             [&](const Flip& flip, std::size_t, TriangleChanges& changes) {
                                 triangles.flip(flip.t, flip.k, changes);
                             });
        left -= std::min(flips.made.size(), left);
        std::vector<TriangleId> next = flips.again(queue);
        for (const Flip& flip : flips.made)
            next.insert(next.end(), {flip.t, flip.u});
        queue = distinct(std::move(next));
    }
    queue.clear();
}

namespace {

/// Edges shorter than this part of the separation are not cut for what lies beside them.
constexpr double bend_floor = 0.7;

/// Such a floor for cuts across a fold: a sheet that rolls up more narrowly than the separation was cut from
/// 250 to 1,200 quads in two steps with an eighth or a quarter.
constexpr double fold_floor = 0.5;

bool bends(const RefinementContext& context, TriangleId t, TriangleId u) {
    const Vec3 p = area_vector(context.mesh, t);
    const Vec3 q = area_vector(context.mesh, u);
    return glm::dot(p, q) < context.rules.cosine * std::sqrt(squared(p) * squared(q));
}

/// Adds the edge by which the two triangles at a bend are made finer: the longest of their other edges, if
/// any is long enough.
void add_bend(const RefinementContext& context,
              TriangleId t,
              TriangleId u,
              std::vector<WantedCut>& wanted) {
    const MovingMesh& mesh = context.mesh;
    const auto& ids = mesh.vertices.id;
    WantedCut best{context.squared_separation(bend_floor), 0, 0, 0, 0, false};
    bool found = false;
    for (const TriangleId x : {t, u})
        for (unsigned k = 0; k < 3; ++k) {
            const Triangle& here = mesh.triangles[x];
            if (here.across[k] == (x == t ? u : t))
                continue;
            const VertexId a = here.begin(k), b = here.end(k);
            if (const double length = squared_length(mesh, a, b); length > best.length) {
                best = {length, a, b, ids[a], ids[b], false};
                found = true;
            }
        }
    if (found)
        wanted.push_back(best);
}

/// Returns the edge of a bridging triangle that crosses the fold: in (s, t), where its vertices are nearly
/// on one line, the longest.
unsigned shortcut_of(const MovingMesh& mesh, TriangleId t) {
    const Triangle& here = mesh.triangles[t];
    std::array<ParameterStep, 3> step;
    double most_s = 0.0, most_t = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
        step[k] = mesh.parameter_step(here.begin(k), here.end(k));
        most_s = std::max(most_s, std::abs(step[k].s));
        most_t = std::max(most_t, std::abs(step[k].t));
    }
    unsigned longest = 0;
    double most = -1.0;
    for (unsigned k = 0; k < 3; ++k) {
        const double s = most_s > 0.0 ? step[k].s / most_s : 0.0;
        const double t_part = most_t > 0.0 ? step[k].t / most_t : 0.0;
        if (s * s + t_part * t_part > most) {
            most = s * s + t_part * t_part;
            longest = k;
        }
    }
    return longest;
}

/// The shortcut of a bridging triangle, if it is long enough to be cut.
std::optional<unsigned> shortcut_to_cut(const RefinementContext& context, TriangleId t) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    if (!is_bridging(mesh, here.vertex[0], here.vertex[1], here.vertex[2]))
        return std::nullopt;
    const unsigned k = shortcut_of(mesh, t);
    return squared_length(mesh, here.begin(k), here.end(k)) > context.squared_separation(fold_floor)
               ? std::optional(k)
               : std::nullopt;
}

} // namespace

bool needs_cut(const RefinementContext& context, TriangleId t) {
    const Triangle& here = context.mesh.triangles[t];
    if (shortcut_to_cut(context, t))
        return true;
    for (unsigned k = 0; k < 3; ++k) {
        if (here.across[k] != no_triangle && here.across[k] < t)
            continue; // that one tests this edge
        const Fault fault = fault_of(context, here.begin(k), here.end(k));
        if (fault != Fault::None && !(fault == Fault::Long && is_diagonal(context, t, k, false)))
            return true;
        if (const TriangleId u = here.across[k];
            context.rules.cosine > -1.0 && u != no_triangle && bends(context, t, u))
            return true;
    }
    return false;
}

std::vector<WantedCut>
wanted_cuts(const RefinementContext& context, std::span<const TriangleId> candidates, bool shape) {
    const MovingMesh& mesh = context.mesh;
    const auto& ids = mesh.vertices.id;
    const auto add = [&](std::size_t i, std::vector<WantedCut>& wanted) {
        const TriangleId t = candidates[i];
        const Triangle& here = mesh.triangles[t];
        if (!here.live || context.stop.stop_requested())
            return;
        if (const auto k = shape ? shortcut_to_cut(context, t) : std::nullopt) {
            const VertexId a = here.begin(*k), b = here.end(*k);
            wanted.push_back({squared_length(mesh, a, b), a, b, ids[a], ids[b], false});
        }
        for (unsigned k = 0; k < 3; ++k) {
            const TriangleId beyond = here.across[k];
            if (beyond != no_triangle && beyond < t &&
                std::binary_search(candidates.begin(), candidates.end(), beyond))
                continue; // that one has tested this edge
            const VertexId a = here.begin(k), b = here.end(k);
            const Fault fault = fault_of(context, a, b);
            if (fault != Fault::None && (shape || fault != Fault::Bulge) &&
                !(fault == Fault::Long && is_diagonal(context, t, k, shape)))
                wanted.push_back({squared_length(mesh, a, b), a, b, ids[a], ids[b], true});
            if (const TriangleId u = here.across[k];
                shape && context.rules.cosine > -1.0 && u != no_triangle && bends(context, t, u))
                add_bend(context, t, u, wanted);
        }
    };
    std::vector<WantedCut> wanted = gather<WantedCut>(candidates.size(), add, few_triangles);
    for (WantedCut& edge : wanted) {
        edge.length = rounded_length(edge.length / context.squared_separation());
        if (edge.id_a > edge.id_b) {
            std::swap(edge.a, edge.b);
            std::swap(edge.id_a, edge.id_b);
        }
    }
    // An edge that must be cut comes before the same edge for the shape of what lies beside it.
    const auto key = [](const WantedCut& edge) {
        return std::tuple(-edge.length, edge.id_a, edge.id_b, !edge.must);
    };
    sort_all(wanted, [&](const WantedCut& x, const WantedCut& y) { return key(x) < key(y); });
    const auto same = [](const WantedCut& x, const WantedCut& y) {
        return x.id_a == y.id_a && x.id_b == y.id_b;
    };
    wanted.erase(std::unique(wanted.begin(), wanted.end(), same), wanted.end());
    return wanted;
}

} // namespace wakesurf::core
