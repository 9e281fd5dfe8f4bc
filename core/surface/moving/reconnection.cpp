#include "core/surface/moving/reconnection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace wakesurf::core {

namespace {

constexpr double glide_gain = 0.12; // of skew, for moving one edge
constexpr double pair_gain = 0.25;  // of skew, for making two hanging nodes
constexpr double pair_skew = 0.6;
constexpr double trusted_sagitta = 0.05; // of an edge whose middle will be interpolated

/// |cos| of the angle between a cross edge and the columns: 0 is square.
double skew(const MovingMesh& mesh, VertexId left, VertexId right, const Vec3& along) {
    const Vec3 edge = mesh.vertices.position[right] - mesh.vertices.position[left];
    const double product = glm::length(edge) * glm::length(along);
    return product > 0.0 ? std::abs(glm::dot(edge, along)) / product : 0.0;
}

/// True when an edge is neither less skew than `skew` nor shorter than `length`, or longer than `longest`, by more than
/// rounding: said of most edges without a root.
bool clearly_worse(
    const Vec3& edge, const Vec3& along, double skew, double length, double longest) {
    constexpr double more = 1.0 + 1e-9;
    const double squared = glm::dot(edge, edge);
    const double lean = glm::dot(edge, along);
    const double allowed = std::max(skew, 0.0) * std::max(skew, 0.0) * glm::dot(along, along);
    return squared > more * longest * longest ||
           (squared > more * length * length && lean * lean > more * allowed * squared);
}

} // namespace

std::optional<Reconnection> worthwhile_reconnection(const MovingMesh& mesh,
                                                    const LocalOperations& operations,
                                                    CellIndex index,
                                                    const RefinementRules& rules) {
    const LinkedCell& here = mesh.quads[index];
    const CellIndex old = here.across[2][0];
    if (old == no_cell || here.cell.mid[2] != no_vertex)
        return std::nullopt;
    const auto& p = mesh.vertices.position;
    const Cell& a = here.cell;
    const Cell& b = mesh.quads[old].cell;
    const Vec3 along = (p[b.corner[3]] - p[a.corner[0]]) + (p[b.corner[2]] - p[a.corner[1]]);
    const Vec3 edge = p[a.corner[2]] - p[a.corner[3]];
    const double lean = glm::dot(edge, along);
    // Without a hanging node beside the edge there are only pairs, which want more skew.
    const bool hanging = a.mid[1] != no_vertex || a.mid[3] != no_vertex || b.mid[1] != no_vertex ||
                         b.mid[3] != no_vertex;
    const double least = hanging ? glide_gain : pair_skew * (1.0 - 1e-9);
    if (!(lean * lean > least * least * glm::dot(edge, edge) * glm::dot(along, along)))
        return std::nullopt; // square enough: most cells end here
    const double now = skew(mesh, a.corner[3], a.corner[2], along);
    const double length = mesh.edge_length(a.corner[3], a.corner[2]);
    std::optional<Reconnection> best;
    double best_length = 0.0;
    constexpr std::array moves = {Reconnection::LeftYoung, Reconnection::RightYoung,
                                  Reconnection::LeftOld,   Reconnection::RightOld,
                                  Reconnection::PairRight, Reconnection::PairLeft};
    for (const auto how : std::span(moves).subspan(hanging ? 0 : 4, hanging ? 4 : 2)) {
        const bool pair = !hanging;
        if (pair && (now < pair_skew || best))
            continue;
        const auto [left, right] = operations.shifted(index, how);
        if (left == no_vertex || mesh.vertices.dead(left) || mesh.vertices.dead(right) ||
            clearly_worse(p[right] - p[left], along, now - (pair ? pair_gain : glide_gain),
                          (pair ? 0.6 : 0.75) * length, rules.separation) ||
            operations.reconnected(index, how).left == no_vertex)
            continue;
        const double shifted = mesh.edge_length(left, right);
        const double gain = now - skew(mesh, left, right, along);
        // In a strip much thinner than its cells are long every edge is oblique: there the shorter one wins.
        const bool straighter = gain > (pair ? pair_gain : glide_gain);
        const bool shorter = gain > 0.0 && shifted < (pair ? 0.6 : 0.75) * length;
        if (!(straighter || shorter) || shifted > rules.separation ||
            (best && shifted >= best_length))
            continue;
        // Longer parameter gaps cost interpolation accuracy.
        if (rules.policy == InsertionPolicy::Hermite && !rules.retrace &&
            !(relative_sagitta(mesh, left, right) < trusted_sagitta))
            continue;
        best = how;
        best_length = shifted;
    }
    return best;
}

} // namespace wakesurf::core
