#include "core/surface/lines/line_seeds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace wakesurf::core {

namespace {

/// Parts of the domain's diagonal: what is smaller has seeds that lie on each other.
constexpr double least_size = 1e-6;
constexpr double farthest = 1e6;

tl::unexpected<Error> unfit(const std::string& what, const std::string& hint) {
    return fail(Error::Code::InvalidArgument, what, hint);
}

std::string rounded(double number) {
    std::ostringstream text;
    text.precision(3);
    text << number;
    return text.str();
}

Result<void> check_distance(const LineSeeds& seeds, double diagonal) {
    const bool sphere = seeds.kind == LineSeeds::Kind::Sphere;
    if (seeds.distance >= least_size * diagonal && seeds.distance <= diagonal)
        return {};
    return unfit("`distance`: " + rounded(seeds.distance) +
                     (sphere ? " is no radius for a sphere in this domain"
                             : " is no distance from walls in this domain"),
                 "choose one from " + rounded(least_size * diagonal) + " to " + rounded(diagonal) +
                     ", the domain's diagonal");
}

/// The box round all seeds.
Box box_of(const LineSeeds& seeds) {
    std::vector<Vec3> corners = seeds.points;
    if (seeds.kind == LineSeeds::Kind::Plane)
        corners.push_back(seeds.points[1] + seeds.points[2] - seeds.points[0]);
    Box box{corners.front(), corners.front()};
    for (const Vec3& each : corners) {
        box.lo = glm::min(box.lo, each - seeds.distance);
        box.hi = glm::max(box.hi, each + seeds.distance);
    }
    return box;
}

Vec3 triangle_place(const std::array<Vec3, 3>& of, double u, double v) {
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return of[0] + u * (of[1] - of[0]) + v * (of[2] - of[0]);
}

double area_of(const std::array<Vec3, 3>& of) {
    const double area = 0.5 * glm::length(glm::cross(of[1] - of[0], of[2] - of[0]));
    return std::isfinite(area) ? area : 0.0;
}

/// Places evenly by area: where each lies in its triangle follows a sequence that leaves no gaps (Roberts' R2).
std::vector<WallPlace> scattered(const QuadComplex& wall, std::size_t count) {
    const auto triangles = wall_triangles(wall);
    const auto corners_of = [&](const std::array<VertexId, 3>& of) {
        return std::array{wall.position[of[0]], wall.position[of[1]], wall.position[of[2]]};
    };
    double area = 0.0;
    for (const auto& each : triangles)
        area += area_of(corners_of(each));
    if (!(area > 0.0))
        return {};
    std::vector<WallPlace> out;
    double passed = 0.0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::array<Vec3, 3> each = corners_of(triangles[t]);
        passed += area_of(each);
        const Vec3 across = glm::cross(each[1] - each[0], each[2] - each[0]);
        while (out.size() < count &&
               (static_cast<double>(out.size()) + 0.5) / static_cast<double>(count) * area <
                   passed) {
            const double i = static_cast<double>(out.size()) + 0.5;
            const auto part = [&](double step) { return i * step - std::floor(i * step); };
            out.push_back({triangle_place(each, part(0.7548776662466927), part(0.5698402909980532)),
                           glm::normalize(across), t});
        }
    }
    return out;
}

} // namespace

std::vector<std::array<VertexId, 3>> wall_triangles(const QuadComplex& wall) {
    std::vector<std::array<VertexId, 3>> out;
    for (const auto& [corner, mid] : wall.cells) {
        out.push_back({corner[0], corner[1], corner[2]});
        if (corner[3] != corner[2])
            out.push_back({corner[0], corner[2], corner[3]});
    }
    return out;
}

Result<void> check_line_seeds(const LineSeeds& seeds, const Box& domain) {
    using Kind = LineSeeds::Kind;
    constexpr std::array<std::size_t, 5> counts{2, 3, 1, 0, 0};
    constexpr std::array<const char*, 5> words{
        "a line has two points, its ends", "a plane has three points, a corner and those beside it",
        "a sphere has one point, its centre", "seeds off the walls have no points",
        "lines along the walls have no points"};
    const auto kind = static_cast<std::size_t>(seeds.kind);
    if (seeds.points.size() != counts[kind])
        return unfit(std::string("`points`: ") + words[kind],
                     "give " + std::to_string(counts[kind]));
    if (seeds.seeds == 0)
        return unfit("`seeds`: there is none", "choose 1 or more");
    for (const Vec3& each : seeds.points)
        if (!finite(each))
            return unfit("`points` are not finite numbers", "choose points in the domain");
    if (!of_walls(seeds.kind) && !seeds.patches.empty())
        return unfit("`patches` are of seeds at walls only", "leave them out");
    const double diagonal = domain.diagonal();
    // Lengths between points farther away are not finite, or have no digits left for the domain.
    for (const Vec3& each : seeds.points)
        if (!(glm::length(each - domain.lo) <= farthest * diagonal))
            return unfit("`points` are far outside of the domain", "choose points in it");
    if (seeds.kind == Kind::Sphere || seeds.kind == Kind::Walls) {
        if (auto sound = check_distance(seeds, diagonal); !sound)
            return sound;
    } else if (seeds.distance != 0.0)
        return unfit("`distance` is of spheres and walls only", "leave it out");
    if (of_walls(seeds.kind))
        return {};
    const auto side = [&](std::size_t i) { return seeds.points[i] - seeds.points[0]; };
    const double least = least_size * diagonal;
    if (seeds.kind == Kind::Line && seeds.seeds > 1 && !(glm::length(side(1)) >= least))
        return unfit("`points`: both ends of the line are the same place", "move one of them");
    if (seeds.kind == Kind::Plane) {
        const double a = glm::length(side(1));
        const double b = glm::length(side(2));
        if (!(a >= least && b >= least &&
              glm::length(glm::cross(side(1), side(2))) >= least_size * a * b))
            return unfit("`points`: the three corners of the plane lie on a line",
                         "move one of them");
    }
    const Box box = box_of(seeds);
    for (int axis = 0; axis < 3; ++axis)
        if (box.lo[axis] > domain.hi[axis] || box.hi[axis] < domain.lo[axis])
            return fail(Error::Code::OutOfDomain,
                        std::string("the seeds lie outside of the domain: in ") + "xyz"[axis] +
                            " it goes from " + rounded(domain.lo[axis]) + " to " +
                            rounded(domain.hi[axis]),
                        "move them inside it");
    return {};
}

std::vector<Vec3> line_seed_places(const LineSeeds& seeds) {
    const std::vector<Vec3>& points = seeds.points;
    const std::uint32_t count = seeds.seeds;
    std::vector<Vec3> out;
    switch (seeds.kind) {
    case LineSeeds::Kind::Line:
        for (std::uint32_t i = 0; i < count; ++i)
            out.push_back(glm::mix(points[0], points[1], count > 1 ? i / (count - 1.0) : 0.5));
        break;
    case LineSeeds::Kind::Plane: {
        const Vec3 across = points[1] - points[0];
        const Vec3 up = points[2] - points[0];
        const double ratio = glm::length(across) / glm::length(up);
        const double most = count;
        const double columns = std::clamp(std::round(std::sqrt(most * ratio)), 1.0, most);
        const double rows = std::max(1.0, std::floor(most / columns));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                out.push_back(points[0] + (column + 0.5) / columns * across +
                              (row + 0.5) / rows * up);
        break;
    }
    case LineSeeds::Kind::Sphere: // Swinbank and Purser, Fibonacci grids, QJRMS 2006
        for (std::uint32_t i = 0; i < count; ++i) {
            const double z = 1.0 - (2.0 * i + 1.0) / count;
            const double turn = 2.0 * std::numbers::pi * i / std::numbers::phi;
            const double r = std::sqrt(1.0 - z * z);
            out.push_back(points[0] +
                          seeds.distance * Vec3(r * std::cos(turn), r * std::sin(turn), z));
        }
        break;
    case LineSeeds::Kind::Walls:
    case LineSeeds::Kind::Along:
        break;
    }
    return out;
}

Result<std::vector<WallPlace>>
even_wall_places(const QuadComplex& wall, std::size_t count, const std::stop_token& stop) {
    constexpr std::size_t choice = 4; // places to choose each from
    std::vector<WallPlace> places = scattered(wall, choice * count);
    if (places.empty())
        return places;
    std::vector<double> apart(places.size(), std::numeric_limits<double>::infinity());
    std::vector<WallPlace> out;
    for (std::size_t next = 0; out.size() < count;) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the lines were cancelled");
        out.push_back(places[next]);
        double farthest = -1.0;
        const Vec3 here = out.back().place;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Vec3 way = places[i].place - here;
            apart[i] = std::min(apart[i], glm::dot(way, way));
            if (apart[i] > farthest) {
                farthest = apart[i];
                next = i;
            }
        }
    }
    return out;
}

} // namespace wakesurf::core
