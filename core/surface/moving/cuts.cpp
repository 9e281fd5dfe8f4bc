#include "core/surface/moving/cuts.hpp"

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

/// Edges shorter than this part of the separation are not cut for what lies beside them.
constexpr double bend_floor = 0.7;

/// Such a floor for cuts across a fold: a sheet that rolls up more narrowly than the separation was cut from
/// 250 to 1,200 quads in two steps with an eighth or a quarter.
constexpr double web_floor = 0.5;

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

/// Returns the edge of a web that crosses the fold: in (s, t), where its vertices are nearly on one line, the
/// longest.
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

/// A web whose shortcut is long enough to be cut; nothing if there is none.
std::optional<unsigned> web_to_cut(const RefinementContext& context, TriangleId t) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    if (!is_web(mesh, here.vertex[0], here.vertex[1], here.vertex[2]))
        return std::nullopt;
    const unsigned k = shortcut_of(mesh, t);
    return squared_length(mesh, here.begin(k), here.end(k)) > context.squared_separation(web_floor)
               ? std::optional(k)
               : std::nullopt;
}

} // namespace

bool needs_cut(const RefinementContext& context, TriangleId t) {
    const Triangle& here = context.mesh.triangles[t];
    if (web_to_cut(context, t))
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
    std::vector<WantedCut> wanted;
    for (const TriangleId t : candidates) {
        const Triangle& here = mesh.triangles[t];
        if (!here.live || context.stop.stop_requested())
            continue;
        if (const auto k = shape ? web_to_cut(context, t) : std::nullopt) {
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
    }
    for (WantedCut& edge : wanted) {
        edge.length = std::round(1e6 * edge.length / context.squared_separation());
        if (!(edge.length >= 0.0)) // no number has no place in an order
            edge.length = std::numeric_limits<double>::infinity();
        if (edge.id_a > edge.id_b) {
            std::swap(edge.a, edge.b);
            std::swap(edge.id_a, edge.id_b);
        }
    }
    // An edge that must be cut comes before the same edge for the shape of what lies beside it.
    std::sort(wanted.begin(), wanted.end(), [](const WantedCut& x, const WantedCut& y) {
        return std::tuple(-x.length, x.id_a, x.id_b, !x.must) <
               std::tuple(-y.length, y.id_a, y.id_b, !y.must);
    });
    const auto same = [](const WantedCut& x, const WantedCut& y) {
        return x.id_a == y.id_a && x.id_b == y.id_b;
    };
    wanted.erase(std::unique(wanted.begin(), wanted.end(), same), wanted.end());
    return wanted;
}

} // namespace wakesurf::core
