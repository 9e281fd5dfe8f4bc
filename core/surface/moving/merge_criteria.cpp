#include "core/surface/moving/merge_criteria.hpp"

#include "core/surface/moving/cell_shape.hpp"
#include "core/surface/moving/split_criteria.hpp"

#include <bit>
#include <cmath>

namespace wakesurf::core {

namespace {

/// How fine a place on the lattice is: the exponent of its lowest set bit, negated; 0 is the coarsest.
int level(double place) {
    if (place == 0.0)
        return -1024;
    int exponent = 0;
    const double mantissa = std::frexp(place, &exponent); // place = mantissa * 2^exponent
    const auto bits = static_cast<std::uint64_t>(std::ldexp(std::abs(mantissa), 53));
    return 53 - exponent - std::countr_zero(bits);
}

bool odd(double before, double between, double after) {
    const int here = level(between);
    return here > level(before) && here > level(after);
}

bool flat(const LinkedCell& here,
          CellIndex index,
          CellIndex partner,
          const RefinementRules& rules,
          std::span<const Vec3f> normals) {
    if (rules.cosine <= -1.0)
        return true;
    // Half the angle at which cells are cut: what is joined is not cut again.
    const double cosine = std::sqrt(0.5 * (1.0 + rules.cosine));
    if (glm::dot(normals[index], normals[partner]) < cosine)
        return false;
    for (const auto& side : here.across)
        for (const CellIndex neighbour : side)
            if (neighbour != no_cell && glm::dot(normals[index], normals[neighbour]) < cosine)
                return false;
    return true;
}

/// True on the border of the parameter rectangle. The edge of a tear is not: two of its sides could come to lie on each other.
bool on_border(const MovingMesh& mesh, VertexId a, VertexId b, VertexId c) {
    const MaterialVertices& v = mesh.vertices;
    const auto all = [&](auto holds) { return holds(a) && holds(b) && holds(c); };
    const auto column = [&](double wanted) {
        return all([&](VertexId k) { return v.place[k].column == wanted; });
    };
    const auto row = [&](double wanted) {
        return all([&](VertexId k) { return v.place[k].row == wanted; });
    };
    const bool on_rake = all([&](VertexId k) { return v.role[k] == VertexRole::Attached; });
    if (on_rake) // the columns the rake began with stay
        return v.place[b].column != std::floor(v.place[b].column);
    return row(0.0) || (mesh.lattice.last_row > 0.0 && row(mesh.lattice.last_row)) ||
           (!mesh.lattice.closed && (column(0.0) || column(mesh.lattice.columns)));
}

} // namespace

bool droppable(const MovingMesh& mesh,
               VertexId before,
               VertexId mid,
               VertexId after,
               const RefinementRules& rules) {
    if (!on_border(mesh, before, mid, after))
        return false;
    const auto& p = mesh.vertices.position;
    const Vec3 chord = p[after] - p[before];
    const double length = glm::length(chord);
    if (length == 0.0 || length > rules.joined())
        return false;
    const Vec3 off = p[mid] - p[before];
    return glm::length(off - chord * (glm::dot(off, chord) / (length * length))) < 0.02 * length;
}

bool should_merge(const MovingMesh& mesh,
                  const LocalOperations& operations,
                  CellIndex index,
                  Axis axis,
                  const RefinementRules& rules,
                  const Flow& flow,
                  std::span<const Vec3f> normals) {
    const LinkedCell& here = mesh.quads[index];
    const Cell& a = here.cell;
    const double small = rules.merge * rules.separation;
    const auto side = static_cast<std::size_t>(axis);
    const auto end = [](std::size_t k) { return (k + 1) % 4; };
    // First what is cheap: most cells are not small. A root is taken only where rounding could matter.
    const double clearly_not = small * small * (1.0 + 1e-9);
    for (const std::size_t k : {side, side + 2}) {
        const Vec3 edge =
            mesh.vertices.position[a.corner[end(k)]] - mesh.vertices.position[a.corner[k]];
        if (glm::dot(edge, edge) > clearly_not)
            return false;
    }
    for (const std::size_t k : {side, side + 2})
        if (a.mid[k] != no_vertex || mesh.edge_length(a.corner[k], a.corner[end(k)]) >= small)
            return false;
    const CellIndex partner = operations.partner(index, axis);
    if (partner == no_cell)
        return false;
    const Cell& b = mesh.quads[partner].cell;
    for (const std::size_t k : {side, side + 2})
        if (mesh.edge_length(b.corner[k], b.corner[end(k)]) >= small)
            return false;

    struct Joint {
        VertexId before, between, after;
    };

    const std::array<Joint, 2> joints =
        axis == Axis::S ? std::array{Joint{a.corner[0], a.corner[1], b.corner[1]},
                                     Joint{a.corner[3], a.corner[2], b.corner[2]}}
                        : std::array{Joint{a.corner[0], a.corner[3], b.corner[3]},
                                     Joint{a.corner[1], a.corner[2], b.corner[2]}};
    // Rows that are joined out of step with each other block each other later; cells this small are worth it.
    bool tiny = mesh.edge_length(a.corner[side], a.corner[end(side)]) < 0.5 * small;
    bool odd_places = true;
    for (const Joint& joint : joints) {
        const auto place = [&](VertexId v) {
            const LatticePlace at = mesh.vertices.place[v];
            return axis == Axis::S ? at.column : at.row;
        };
        odd_places =
            odd_places && odd(place(joint.before), place(joint.between), place(joint.after));
        const double length = mesh.edge_length(joint.before, joint.after);
        if (length > rules.joined() ||
            crosses_obstacle(mesh, joint.before, joint.after, length, rules, flow))
            return false;
        if (mesh.vertices.dead(joint.between))
            return false;
    }
    return (tiny || odd_places) && flat(here, index, partner, rules, normals) &&
           flat(mesh.quads[partner], partner, index, rules, normals);
}

} // namespace wakesurf::core
