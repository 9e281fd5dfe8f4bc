#include "core/surface/moving/split_criteria.hpp"

#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

/// An edge may bulge by so many separations.
constexpr double largest_bulge = 0.1;
constexpr double shallow = 0.15; ///< depth of a chord in a convex wall
constexpr double at_wall = 0.25; ///< reach within which something is beside an obstacle

/// Relative area in (s, t) below which a bridging triangle is not cut any more.
constexpr double thin_bridging = 1e-5;

/// The directions are seven opposite pairs: the axes and the diagonals of a cube.
constexpr double third = 0.57735026918962576;
constexpr Vec3 directions[] = {{1, 0, 0},
                               {0, 1, 0},
                               {0, 0, 1},
                               {third, third, third},
                               {third, third, -third},
                               {third, -third, third},
                               {-third, third, third}};

bool in_obstacle(const Flow& flow, const Vec3& point) {
    return flow.status(point) == PointStatus::InObstacle;
}

/// Returns whether a place can be seen from a point inside an obstacle.
bool in_same_obstacle(const Flow& flow, const Vec3& inside, const Vec3& point) {
    return !flow.may_cross_wall(inside, point) || in_obstacle(flow, point);
}

/// True when a point inside an obstacle is within `depth` of the fluid, and on one side of it only: a chord
/// that dips into a convex wall, not one that goes through a thin plate.
bool barely_inside(const Flow& flow, const Vec3& point, double depth) {
    bool found = false;
    for (const Vec3& direction : directions) {
        const bool ahead = !in_same_obstacle(flow, point, point + depth * direction);
        const bool behind = !in_same_obstacle(flow, point, point - depth * direction);
        if (ahead && behind)
            return false;
        found = found || ahead || behind;
    }
    return found;
}

/// Says whether a place that is drawn for one of the surface is in a body, deeper than a convex wall makes it
/// dip.
bool is_deep(const RefinementContext& context, const Vec3& drawn, const Vec3& material) {
    const double depth = shallow * context.rules.separation;
    if (!in_obstacle(context.flow, drawn) || barely_inside(context.flow, drawn, depth))
        return false;
    // Beside a curved wall every direction along it leaves the body both ways, as from a plate.
    return in_obstacle(context.flow, material) || squared(material - drawn) > depth * depth;
}

/// The boundary of the surface at a triangle, or at the two beside an edge.
struct Boundary {
    bool any = false;
    bool tear = false; ///< not that of the parameter rectangle
};

Boundary boundary_of(const MovingMesh& mesh, TriangleId t) {
    Boundary found;
    const Triangle& here = mesh.triangles[t];
    for (unsigned k = 0; k < 3; ++k)
        if (here.across[k] == no_triangle) {
            found.any = true;
            found.tear = found.tear || !on_rectangle_border(mesh, here.begin(k), here.end(k));
        }
    return found;
}

bool touches_boundary(const MovingMesh& mesh, TriangleId t) {
    std::vector<TriangleId> round;
    for (const VertexId v : mesh.triangles[t].vertex)
        if (mesh.triangles.fan(v, round))
            return true;
    return false;
}

} // namespace

bool beside_obstacle(const RefinementContext& context, const Vec3& point) {
    const double reach = at_wall * context.rules.separation;
    if (!context.rules.obstacle || !context.flow.may_have_wall({point - reach, point + reach}))
        return false;
    for (const Vec3& direction : directions)
        if (in_obstacle(context.flow, point + reach * direction) ||
            in_obstacle(context.flow, point - reach * direction))
            return true;
    return false;
}

bool crosses_obstacle(const RefinementContext& context,
                      VertexId a,
                      VertexId b,
                      double squared_length) {
    if (!context.rules.obstacle || !(squared_length > context.squared_separation(0.25)))
        return false;
    const Vec3& from = context.mesh.vertices.position[a];
    const Vec3& to = context.mesh.vertices.position[b];
    const Vec3 middle = 0.5 * (from + to);
    if (!context.flow.may_cross_wall(from, middle)) // and it begins in the fluid
        return false;
    return is_deep(context, middle, edge_cubic(context.mesh, a, b).at(0.5).position);
}

bool covers_obstacle(const RefinementContext& context, VertexId a, VertexId b, VertexId c) {
    if (!context.rules.obstacle)
        return false;
    const MovingMesh& mesh = context.mesh;
    const auto& at = mesh.vertices.position;
    const Vec3 middle = (at[a] + at[b] + at[c]) / 3.0;
    const auto side = [&](VertexId x, VertexId y) {
        return edge_cubic(mesh, x, y).at(0.5).position;
    };
    // The middle of the quadric through corners and sides.
    const Vec3 curved = (4.0 * (side(a, b) + side(b, c) + side(c, a)) - 3.0 * middle) / 9.0;
    return is_deep(context, middle, curved);
}

double least_bend(const RefinementContext& context) {
    return 8.0 * largest_bulge * context.rules.separation;
}

bool bulges(const RefinementContext& context, VertexId a, VertexId b, double share) {
    const RefinementRules& rules = context.rules;
    if (rules.cosine <= -1.0 ||
        squared_length(context.mesh, a, b) <= context.squared_separation(2.0 * rules.finest))
        return false;
    const double bend = share * least_bend(context);
    return squared(edge_bend(context.mesh, a, b)) > bend * bend;
}

Fault fault_of(const RefinementContext& context, VertexId a, VertexId b) {
    const double length = squared_length(context.mesh, a, b);
    if (!(length <= context.longest_allowed())) // not a number must not pass
        return Fault::Long;
    if (crosses_obstacle(context, a, b, length))
        return Fault::Wall;
    if (bulges(context, a, b))
        return Fault::Bulge;
    return Fault::None;
}

bool is_diagonal(const RefinementContext& context, TriangleId t, unsigned k, bool waits) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    const TriangleId u = here.across[k];
    if (u == no_triangle)
        return false;
    const VertexId a = here.begin(k), b = here.end(k), c = here.opposite(k);
    const VertexId d = mesh.triangles.opposite_beyond(t, k);
    bool long_side = false;
    for (const auto& [x, y] : {std::pair{c, a}, {c, b}, {d, a}, {d, b}})
        long_side = long_side || !(squared_length(mesh, x, y) <= context.longest_allowed());
    // The limit is that of a square at most, with some more for what is not one.
    const bool too_long = !(squared_length(mesh, a, b) <= 2.1 * context.longest_allowed());
    if (waits ? !long_side && too_long : long_side || too_long)
        return false;
    constexpr double corner = 0.6; // cosine: 53 to 127 degrees
    const auto good = [&](VertexId at, VertexId x, VertexId y) {
        return std::abs(cosine_between(mesh.edge(at, x), mesh.edge(at, y), 1.0)) <= corner;
    };
    return good(c, a, b) && good(d, a, b) && good(a, c, d) && good(b, c, d) &&
           cosine_between(area_vector(mesh, t), area_vector(mesh, u), -1.0) > 0.9;
}

bool is_torn(const RefinementContext& context, TriangleId t, unsigned k) {
    const MovingMesh& mesh = context.mesh;
    const RefinementRules& rules = context.rules;
    const Triangle& here = mesh.triangles[t];
    const VertexId a = here.begin(k), b = here.end(k);
    const ParameterStep step = mesh.parameter_step(a, b);
    const double s = 0.5 * std::abs(step.s);
    const double t_part = 0.5 * std::abs(step.t);
    if (s <= rules.least_s && t_part <= rules.least_t)
        return true;
    if (!rules.obstacle || s > rules.least_s_at_wall || t_part > rules.least_t_at_wall)
        return false;
    // A tear begins at the boundary of the surface: elsewhere many would, each a hole.
    Boundary boundary;
    bool near_boundary = false;
    for (const TriangleId x : {t, here.across[k]})
        if (x != no_triangle) {
            const Boundary its = boundary_of(mesh, x);
            boundary.tear = boundary.tear || its.tear;
            near_boundary = near_boundary || its.any || touches_boundary(mesh, x);
        }
    return near_boundary &&
           (boundary.tear || beside_obstacle(context, 0.5 * (mesh.vertices.position[a] +
                                                             mesh.vertices.position[b])));
}

bool is_crumb(const RefinementContext& context, TriangleId t) {
    const MovingMesh& mesh = context.mesh;
    const auto& [a, b, c] = mesh.triangles[t].vertex;
    const double material = material_area(mesh, a, b, c);
    if (!(material > least_material) || (material < thin_bridging && is_bridging(mesh, a, b, c)))
        return true;
    const unsigned k = longest_edge_of(mesh, t);
    const Triangle& here = mesh.triangles[t];
    const double longest = squared_length(mesh, here.begin(k), here.end(k));
    return !(squared(area_vector(mesh, t)) >
             longest * context.squared_separation(context.rules.crumb));
}

} // namespace wakesurf::core
