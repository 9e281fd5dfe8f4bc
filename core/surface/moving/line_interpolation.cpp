#include "core/surface/moving/line_interpolation.hpp"

#include "core/surface/moving/cell_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wakesurf::core {

namespace {

/// Ratios of neighbouring pieces of a line, in the parameter and in length, up to which they are one smooth line.
constexpr double most_uneven = 4.0;
constexpr double largest_line_bulge = 0.25; ///< over the chord's length
/// Of a chord's middle, over its length: somewhat more than that of an arc of 20 degrees, which is as much as neighbours bend.
constexpr double largest_unknown = 0.08;

struct LinePoint {
    Vec3 position;
    double parameter; ///< from the end of the side, in its extent
};

/// Through the ends of a side and a point beyond one of them.
struct Parabola {
    double apart; ///< of that point from the end, in the side's extent
    Vec3 bulge;   ///< in the middle of the side
};

double extent(const MovingMesh& mesh, VertexId from, VertexId to, bool cross) {
    const MaterialVertices& v = mesh.vertices;
    return cross ? mesh.lattice.s_between(v.s[from], v.s[to]) : v.t[to] - v.t[from];
}

/// The next point of the line through `end`, in the cell across the side that meets it there. @param facing  side of `cell` with that
/// neighbour
std::optional<LinePoint>
beyond(const MovingMesh& mesh, CellIndex cell, std::size_t facing, VertexId end, bool cross) {
    const LinkedCell& here = mesh.quads[cell];
    const bool first = here.cell.corner[facing] == end;
    const CellIndex index = here.across[facing][!first && here.cell.mid[facing] != no_vertex];
    if (index == no_cell)
        return std::nullopt;
    const Cell& there = mesh.quads[index].cell;
    const MaterialVertices& v = mesh.vertices;
    const auto point = [&](VertexId next) -> std::optional<LinePoint> {
        if (v.dead(next) || v.dead(end))
            return std::nullopt;
        return LinePoint{v.position[next], extent(mesh, end, next, cross)};
    };
    for (std::size_t k = 0; k < 4; ++k) {
        // Its own line goes on along the side that the two cells do not share.
        if (there.corner[k] == end) {
            const std::size_t side = first ? k : (k + 3) % 4;
            if (there.mid[side] != no_vertex)
                return point(there.mid[side]);
            return point(there.corner[first ? (k + 1) % 4 : (k + 3) % 4]);
        }
        if (there.mid[k] == end) { // half-way between the two lines of a wider cell
            const std::size_t side = (k + 2) % 4;
            if (there.mid[side] != no_vertex)
                return point(there.mid[side]);
            const auto a = point(there.corner[side]);
            const auto b = point(there.corner[(side + 1) % 4]);
            if (!a || !b)
                return std::nullopt;
            return LinePoint{0.5 * (a->position + b->position),
                             0.5 * (a->parameter + b->parameter)};
        }
    }
    return std::nullopt;
}

/// Error of the middle of a chord, over its length, of which the line itself does not tell: as the cell and its neighbours bend.
double unknown(const MovingMesh& mesh, CellIndex cell) {
    const LinkedCell& here = mesh.quads[cell];
    const Vec3f own = normal(mesh, here.cell);
    double bend = -1.0;
    for (const auto& side : here.across)
        for (const CellIndex next : side)
            if (next != no_cell)
                bend =
                    std::max(bend, double(glm::length(normal(mesh, mesh.quads[next].cell) - own)));
    return bend < 0.0 ? largest_unknown : std::min(0.4 * bend, largest_unknown);
}

} // namespace

LineBulge bulge_of_line(const MovingMesh& mesh, CellIndex cell, std::size_t side) {
    const MaterialVertices& v = mesh.vertices;
    const Cell& here = mesh.quads[cell].cell;
    const VertexId a = here.corner[side];
    const VertexId b = here.corner[(side + 1) % 4];
    const bool cross = side % 2 == 0;
    const double whole = extent(mesh, a, b, cross);
    const Vec3 chord = v.position[b] - v.position[a];
    const double length = glm::length(chord);
    if (whole == 0.0 || !(length > 0.0))
        return {Vec3(0.0), 1.0, Vec3(0.0), length};
    for (const VertexId corner : here.corner)
        if (v.dead(corner)) // the cell is on its way out
            return {Vec3(0.0), 0.0, Vec3(0.0), unknown(mesh, cell) * length};
    const auto even = [&](double ratio) {
        return ratio > 1.0 / most_uneven && ratio < most_uneven;
    };
    const auto parabola = [&](std::optional<LinePoint> next, VertexId end,
                              double sign) -> std::optional<Parabola> {
        if (!next)
            return std::nullopt;
        const double apart = sign * next->parameter / whole; // in the side's extent
        const Vec3 piece = next->position - v.position[end];
        if (!even(apart) || !even(glm::length(piece) / length))
            return std::nullopt;
        return Parabola{apart, -0.25 * (piece / apart - sign * chord) / (1.0 + apart)};
    };
    const auto at_a = parabola(beyond(mesh, cell, (side + 3) % 4, a, cross), a, -1.0);
    const auto at_b = parabola(beyond(mesh, cell, (side + 1) % 4, b, cross), b, 1.0);
    if (!at_a && !at_b)
        return {Vec3(0.0), 0.0, Vec3(0.0), unknown(mesh, cell) * length};
    Vec3 bulge = (at_a ? at_a : at_b)->bulge;
    Vec3 doubt = 5.0 * bulge;
    if (at_a && at_b) { // the cubic: each parabola by how near its point is
        const double of_a = at_b->apart + 0.5;
        const double of_b = at_a->apart + 0.5;
        bulge = (of_a * at_a->bulge + of_b * at_b->bulge) / (of_a + of_b);
        doubt = 5.0 * (at_a->bulge - at_b->bulge);
    }
    const double share = glm::length(bulge) / length;
    if (!(share <= largest_line_bulge))
        return {Vec3(0.0), std::isfinite(share) ? share : 1.0, 3.0 * bulge, 0.0};
    return {bulge, share, doubt, 0.0};
}

} // namespace wakesurf::core
