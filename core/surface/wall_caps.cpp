#include "core/surface/wall_caps.hpp"

#include "core/surface/same_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr std::size_t most_points = 2000;
/// How often each point of a loop may be tried as an ear: some 3 times are usual.
constexpr std::size_t most_tries = 50;
/// How far from a side its points may be, in extents of the domain: walls are stored in 32 bits.
constexpr double in_side = 1e-6;

using Loop = std::vector<std::uint32_t>;

struct Point2 {
    double x, y;
};

double twice_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

using Edge = std::array<std::uint32_t, 2>;

/// Returns the edges that one triangle has alone, in order. It takes 24 bytes a triangle.
std::vector<Edge> border_of(const WallGeometry& walls) {
    const std::vector<std::uint32_t> place = same_places(walls.points);
    std::vector<Edge> edges;
    edges.reserve(3 * walls.triangles.size());
    for (const auto& triangle : walls.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(place[triangle[i]], place[triangle[(i + 1) % 3]]);
            if (a != b)
                edges.push_back({a, b});
        }
    std::ranges::sort(edges);
    std::vector<Edge> border;
    for (std::size_t k = 0; k < edges.size(); ++k)
        if ((k == 0 || edges[k - 1] != edges[k]) &&
            (k + 1 == edges.size() || edges[k + 1] != edges[k]))
            border.push_back(edges[k]);
    return border;
}

/// Returns the closed loops without branches that edges make.
std::vector<Loop> loops_of(const std::vector<Edge>& edges) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
    for (const auto& [a, b] : edges) {
        beside[a].push_back(b);
        beside[b].push_back(a);
    }
    std::vector<Loop> loops;
    std::map<std::uint32_t, bool> seen;
    for (const auto& [start, unused] : beside) {
        Loop loop;
        bool closed = true;
        for (std::uint32_t at = start; !seen[at];) {
            seen[at] = true;
            loop.push_back(at);
            const auto& next = beside[at];
            closed = closed && next.size() == 2;
            for (const std::uint32_t other : next)
                if (!seen[other]) {
                    at = other;
                    break;
                }
        }
        const auto& last = beside[loop.empty() ? start : loop.back()];
        closed = closed && loop.size() >= 3 && loop.size() <= most_points &&
                 std::find(last.begin(), last.end(), start) != last.end();
        if (closed)
            loops.push_back(std::move(loop));
    }
    return loops;
}

bool contains(const std::vector<Point2>& polygon, const Point2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2& a = polygon[i];
        const Point2& b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

/// Cuts ears off a simple polygon. Empty where none is left to cut, as it crosses itself, or it takes too long.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<Point2>& polygon) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += twice_area(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()]);
    std::vector<std::uint32_t> left(polygon.size());
    for (std::uint32_t i = 0; i < left.size(); ++i)
        left[i] = area > 0.0 ? i : static_cast<std::uint32_t>(left.size() - 1) - i;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto is_ear = [&](std::size_t k) {
        const std::uint32_t a = left[(k + left.size() - 1) % left.size()], b = left[k],
                            c = left[(k + 1) % left.size()];
        if (twice_area(polygon[a], polygon[b], polygon[c]) < 0.0)
            return false;
        return std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
            return p != a && p != b && p != c &&
                   twice_area(polygon[a], polygon[b], polygon[p]) > 0.0 &&
                   twice_area(polygon[b], polygon[c], polygon[p]) > 0.0 &&
                   twice_area(polygon[c], polygon[a], polygon[p]) > 0.0;
        });
    };
    std::size_t tries = 0;
    for (std::size_t k = 0, tried = 0; left.size() > 3; ++tried) {
        if (tried == left.size() || ++tries > most_tries * polygon.size())
            return {};
        k %= left.size();
        if (!is_ear(k)) {
            ++k;
            continue;
        }
        triangles.push_back(
            {left[(k + left.size() - 1) % left.size()], left[k], left[(k + 1) % left.size()]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
        ++k; // the next ear elsewhere: fans have slivers
        tried = 0;
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

/// Says whether the fluid is behind the largest of the triangles: they close an opening then.
bool is_open(const Flow& flow,
             int axis,
             bool low,
             const WallGeometry& walls,
             const Loop& loop,
             const std::vector<Point2>& polygon,
             std::vector<std::array<std::uint32_t, 3>> triangles) {
    constexpr std::size_t asked = 3;
    std::partial_sort(triangles.begin(),
                      triangles.begin() +
                          static_cast<std::ptrdiff_t>(std::min(asked, triangles.size())),
                      triangles.end(), [&](const auto& a, const auto& b) {
                          return twice_area(polygon[a[0]], polygon[a[1]], polygon[a[2]]) >
                                 twice_area(polygon[b[0]], polygon[b[1]], polygon[b[2]]);
                      });
    for (std::size_t i = 0; i < std::min(asked, triangles.size()); ++i) {
        Vec3 middle(0.0);
        for (const std::uint32_t corner : triangles[i])
            middle += Vec3(walls.points[loop[corner]]) / 3.0;
        const Box domain = flow.domain();
        middle[axis] = low ? domain.lo[axis] + 0.01 * flow.finest_spacing()
                           : domain.hi[axis] - 0.01 * flow.finest_spacing();
        if (flow.status(middle) == PointStatus::Inside)
            return true;
    }
    return false;
}

void close_side(
    WallGeometry& walls, const Flow& flow, const std::vector<Edge>& border, int axis, bool low) {
    const Box domain = flow.domain();
    const double side = low ? domain.lo[axis] : domain.hi[axis];
    const double near = in_side * glm::length(domain.extent());
    const auto in = [&](std::uint32_t point) {
        return std::abs(double{walls.points[point][axis]} - side) <= near;
    };
    std::vector<Edge> edges;
    for (const auto& edge : border)
        if (in(edge[0]) && in(edge[1]))
            edges.push_back(edge);
    const std::vector<Loop> loops = loops_of(edges);
    std::vector<std::vector<Point2>> polygons;
    for (const Loop& loop : loops) {
        std::vector<Point2> polygon;
        for (const std::uint32_t point : loop)
            polygon.push_back(
                {walls.points[point][(axis + 1) % 3], walls.points[point][(axis + 2) % 3]});
        polygons.push_back(std::move(polygon));
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const bool round_another = [&] {
            for (std::size_t j = 0; j < loops.size(); ++j)
                if (j != i && contains(polygons[i], polygons[j].front()))
                    return true;
            return false;
        }();
        if (round_another)
            continue;
        const auto triangles = triangles_of(polygons[i]);
        if (triangles.empty() || is_open(flow, axis, low, walls, loops[i], polygons[i], triangles))
            continue;
        const auto first = static_cast<std::uint32_t>(walls.points.size());
        for (const std::uint32_t point : loops[i]) {
            const Vec3f place = walls.points[point];
            walls.points.push_back(place);
        }
        for (const auto& [a, b, c] : triangles)
            walls.triangles.push_back({first + a, first + b, first + c});
    }
}

} // namespace

void close_at_sides(WallGeometry& walls, const Flow& flow) {
    const auto border = border_of(walls);
    if (border.empty())
        return;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool low : {true, false})
            close_side(walls, flow, border, axis, low);
}

} // namespace wakesurf::core
