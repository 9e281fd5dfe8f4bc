#include "core/surface/moving/split_criteria.hpp"

#include "core/surface/moving/cell_shape.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Seven opposite pairs: the axes and the diagonals of a cube.
constexpr double diagonal = 0.57735026918962576;
constexpr Vec3 directions[] = {{1, 0, 0},
                               {0, 1, 0},
                               {0, 0, 1},
                               {diagonal, diagonal, diagonal},
                               {diagonal, diagonal, -diagonal},
                               {diagonal, -diagonal, diagonal},
                               {-diagonal, diagonal, diagonal}};

/// Of a part of the separation.
double squared(const RefinementRules& rules, double part) {
    return part * part * rules.separation * rules.separation;
}

bool side_crosses_obstacle(const MovingMesh& mesh,
                           const Cell& cell,
                           std::size_t side,
                           const RefinementRules& rules,
                           const Flow& flow) {
    for (const SubEdge& edge : outline(cell))
        if (edge.side == side &&
            crosses_obstacle(mesh, edge.from, edge.to, mesh.edge_length(edge.from, edge.to), rules,
                             flow))
            return true;
    return false;
}

/// Parameter extents of a cell.
double s_extent(const MovingMesh& mesh, const Cell& cell) {
    return std::abs(
        mesh.lattice.s_between(mesh.vertices.s[cell.corner[0]], mesh.vertices.s[cell.corner[1]]));
}

double t_extent(const MovingMesh& mesh, const Cell& cell) {
    const auto& t = mesh.vertices.t;
    return std::max(std::abs(t[cell.corner[3]] - t[cell.corner[0]]),
                    std::abs(t[cell.corner[2]] - t[cell.corner[1]]));
}

bool beside_obstacle(const MovingMesh& mesh,
                     const Cell& cell,
                     const RefinementRules& rules,
                     const Flow& flow) {
    if (!rules.obstacle)
        return false;
    const auto& p = mesh.vertices.position;
    const Vec3 centre =
        0.25 * (p[cell.corner[0]] + p[cell.corner[1]] + p[cell.corner[2]] + p[cell.corner[3]]);
    const double reach = 0.25 * rules.separation;
    if (!flow.may_have_wall({centre - reach, centre + reach}))
        return false;
    for (const Vec3& direction : directions)
        if (flow.status(centre + reach * direction) == PointStatus::InObstacle ||
            flow.status(centre - reach * direction) == PointStatus::InObstacle)
            return true;
    return false;
}

/// The cut across an axis, or a tear where the parameters or the sides of the cell are too close for the surface to be continuous.
Cut cut_or_tear(const MovingMesh& mesh,
                const Cell& cell,
                Axis axis,
                const SquaredLengths& lengths,
                const RefinementRules& rules,
                const Flow& flow) {
    // A fan, with one such side, has the sheet on both sides of it, unless something ends there.
    const auto& sides = lengths.longest;
    const double narrow = has_dead_vertex(mesh, cell) ? *std::ranges::min_element(sides)
                                                      : std::min(std::max(sides[0], sides[2]),
                                                                 std::max(sides[1], sides[3]));
    if (!(narrow > squared(rules, rules.crumb)))
        return Cut::Tear;
    const bool s = axis == Axis::S;
    const double extent = 0.5 * (s ? s_extent(mesh, cell) : t_extent(mesh, cell));
    const bool torn = !(extent > (s ? rules.least_s : rules.least_t)) ||
                      (extent <= (s ? rules.least_s_at_wall : rules.least_t_at_wall) &&
                       beside_obstacle(mesh, cell, rules, flow));
    return torn ? Cut::Tear : s ? Cut::AcrossS : Cut::AcrossT;
}

/// Cubic bulge of a whole side, which a straight edge would miss.
bool bulges(const MovingMesh& mesh,
            const Cell& cell,
            std::size_t side,
            double squared_length,
            const RefinementRules& rules) {
    constexpr double part_of_separation = 0.1;
    if (cell.mid[side] != no_vertex ||
        squared_length <= 4.0 * rules.finest * rules.finest * rules.separation * rules.separation)
        return false;
    const VertexId a = cell.corner[side];
    const VertexId b = cell.corner[(side + 1) % 4];
    const Vec3 turn = edge_turn(mesh, a, b);
    const double allowed = 8.0 * part_of_separation * rules.separation;
    return glm::dot(turn, turn) > allowed * allowed;
}

/// True when a point inside an obstacle is within `depth` of the fluid, and on one side of it only: a chord that dips into a
/// convex wall, not one that goes through a thin plate.
bool barely_inside(const Flow& flow, const Vec3& point, double depth) {
    bool shallow = false;
    for (const Vec3& direction : directions) {
        const bool ahead = flow.status(point + depth * direction) != PointStatus::InObstacle;
        const bool behind = flow.status(point - depth * direction) != PointStatus::InObstacle;
        if (ahead && behind)
            return false;
        shallow = shallow || ahead || behind;
    }
    return shallow;
}

} // namespace

bool has_dead_vertex(const MovingMesh& mesh, const Cell& cell) {
    bool dead = false;
    for_each_vertex(cell, [&](VertexId v) { dead = dead || mesh.vertices.dead(v); });
    return dead;
}

bool crosses_obstacle(const MovingMesh& mesh,
                      VertexId a,
                      VertexId b,
                      double length,
                      const RefinementRules& rules,
                      const Flow& flow) {
    if (!rules.obstacle || length <= 0.25 * rules.separation)
        return false;
    const Vec3& from = mesh.vertices.position[a];
    const Vec3& to = mesh.vertices.position[b];
    if (!flow.may_have_wall({glm::min(from, to), glm::max(from, to)}))
        return false;
    const Vec3 middle = 0.5 * (from + to);
    return flow.status(middle) == PointStatus::InObstacle &&
           !barely_inside(flow, middle, 0.15 * rules.separation);
}

Cut needed_cut(const MovingMesh& mesh,
               CellIndex index,
               const RefinementRules& rules,
               const Flow& flow,
               std::span<const Vec3f> normals) {
    const LinkedCell& here = mesh.quads[index];
    const Cell& cell = here.cell;
    const SquaredLengths lengths = squared_lengths(mesh, cell);
    const double across_s = std::max(lengths.longest[0], lengths.longest[2]);
    const double across_t = std::max(lengths.longest[1], lengths.longest[3]);
    const double longest = std::max(across_s, across_t);
    const Axis longer = across_s >= across_t ? Axis::S : Axis::T;
    // Particles that gather at one point are on one place of the surface in all but name.
    if (!(lengths.shortest > squared(rules, 1e-9)) || !(longest > squared(rules, rules.crumb)))
        return Cut::Tear;
    if (has_dead_vertex(mesh, cell)) {
        if (!(longest > squared(rules, rules.tear_size)))
            return Cut::Tear;
        return cut_or_tear(mesh, cell, longer, lengths, rules, flow);
    }
    if (!(longest <= squared(rules, 1.0 + 1e-9))) // not a number must not pass
        return cut_or_tear(mesh, cell, longer, lengths, rules, flow);
    if (rules.obstacle)
        for (std::size_t side = 0; side < 4; ++side)
            if (side_crosses_obstacle(mesh, cell, side, rules, flow))
                return cut_or_tear(mesh, cell, side % 2 == 0 ? Axis::S : Axis::T, lengths, rules,
                                   flow);
    if (rules.cosine <= -1.0)
        return Cut::None;
    // A cut halves two sides, the shorter of which must be worth it too: cutting a fan at its narrow end would cut everything
    // small beside it (a time surface of the bundled flow went from 8,000 to 257,000 quads that way).
    const double floor = squared(rules, 2.0 * rules.finest);
    const std::array<double, 2> narrow{std::min(lengths.longest[0], lengths.longest[2]),
                                       std::min(lengths.longest[1], lengths.longest[3])};
    if (rules.tangents)
        for (std::size_t side = 0; side < 4; ++side)
            // Each inner edge belongs to two cells: one of them looks.
            if ((side < 2 || here.across[side][0] == no_cell) && narrow[side % 2] > floor &&
                bulges(mesh, cell, side, lengths.longest[side], rules))
                return cut_or_tear(mesh, cell, side % 2 == 0 ? Axis::S : Axis::T, lengths, rules,
                                   flow);
    for (std::size_t side = 0; side < 4; ++side) {
        const bool s_neighbour = side % 2 == 1;
        if (narrow[s_neighbour ? 0 : 1] <= floor)
            continue;
        for (std::size_t half = 0; half < (cell.mid[side] == no_vertex ? 1u : 2u); ++half) {
            const CellIndex neighbour = here.across[side][half];
            if (neighbour != no_cell && glm::dot(normals[index], normals[neighbour]) < rules.cosine)
                return cut_or_tear(mesh, cell, s_neighbour ? Axis::S : Axis::T, lengths, rules,
                                   flow);
        }
    }
    return Cut::None;
}

} // namespace wakesurf::core
