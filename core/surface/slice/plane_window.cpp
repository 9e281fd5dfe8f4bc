#include "core/surface/slice/plane_window.hpp"

#include "core/base/rounding.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

namespace wakesurf::core {

namespace {

constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

Vec3 corner_of(const Box& box, std::size_t k) {
    return {(k & 1) != 0 ? box.hi.x : box.lo.x, (k & 2) != 0 ? box.hi.y : box.lo.y,
            (k & 4) != 0 ? box.hi.z : box.lo.z};
}

struct Directions {
    Vec3 normal, across, up; ///< of length 1
};

/// Returns nothing of a plane without a place or a direction.
std::optional<Directions> directions_of(const Plane& plane) {
    const Vec3& given = plane.normal;
    const double largest = std::max({std::abs(given.x), std::abs(given.y), std::abs(given.z)});
    if (!finite(plane.point) || !finite(given) || largest == 0.0)
        return std::nullopt;
    // The square of a tiny or huge component would be 0 or infinite.
    const Vec3 normal = glm::normalize(given / largest);
    std::size_t main = 2; // the axis nearest to the normal; the last of equal ones
    for (const std::size_t k : {std::size_t{1}, std::size_t{0}})
        if (std::abs(normal[static_cast<int>(k)]) > std::abs(normal[static_cast<int>(main)]))
            main = k;
    const Vec3 right = axes[main == 0 ? 1 : 0];
    const Vec3 above = axes[main == 2 ? 1 : 2];
    const Vec3 across = glm::normalize(right - glm::dot(right, normal) * normal);
    const Vec3 up = glm::cross(normal, across);
    return Directions{normal, across, glm::dot(up, above) < 0.0 ? -up : up};
}

/// Returns the heights of the corners of a box, those within rounding of the plane on it.
std::array<double, 8> heights_of(const Plane& plane, const Vec3& normal, const Box& box) {
    const Vec3 slack = rounding(box);
    const double on =
        glm::dot(Vec3(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)), slack);
    std::array<double, 8> heights{};
    for (std::size_t k = 0; k < 8; ++k) {
        const double height = glm::dot(corner_of(box, k) - plane.point, normal);
        heights[k] = std::abs(height) <= on ? 0.0 : height;
    }
    return heights;
}

std::vector<Vec3> section(const Plane& plane, const Directions& way, const Box& box) {
    const auto heights = heights_of(plane, way.normal, box);
    std::vector<Vec3> corners;
    for (std::size_t a = 0; a < 8; ++a) {
        if (heights[a] == 0.0)
            corners.push_back(corner_of(box, a));
        for (const std::size_t bit : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
            const std::size_t b = a | bit;
            if (b == a || heights[a] * heights[b] >= 0.0)
                continue;
            const double part = heights[a] / (heights[a] - heights[b]);
            corners.push_back(corner_of(box, a) + part * (corner_of(box, b) - corner_of(box, a)));
        }
    }
    if (corners.size() < 3)
        return {};
    const Vec3 middle = std::accumulate(corners.begin(), corners.end(), Vec3(0.0)) /
                        static_cast<double>(corners.size());
    const auto angle = [&](const Vec3& p) {
        return std::atan2(glm::dot(p - middle, way.up), glm::dot(p - middle, way.across));
    };
    std::ranges::sort(corners, {}, angle);
    return corners;
}

/// Three digits: it is for a person.
std::string rounded(double number) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 3)
            .ptr;
    return {text.data(), end};
}

Error missed(const Plane& plane, const Vec3& normal, const Box& box) {
    const auto heights = heights_of(plane, normal, box);
    const auto [least, most] = std::ranges::minmax(heights);
    const double away = least > 0.0 ? least : -most;
    return {Error::Code::OutOfDomain, "the plane misses the domain by " + rounded(away),
            "choose an `origin` inside the domain"};
}

} // namespace

std::vector<Vec3> plane_section(const Plane& plane, const Box& box) {
    const auto way = directions_of(plane);
    return way ? section(plane, *way, box) : std::vector<Vec3>{};
}

Result<PlaneWindow> plane_window(const Plane& plane, const Box& box) {
    const auto way = directions_of(plane);
    if (!way)
        return fail(Error::Code::InvalidArgument, "the plane has no direction",
                    "choose a `normal` that is not zero, such as [1, 0, 0]");
    const auto corners = section(plane, *way, box);
    if (corners.empty())
        return tl::unexpected(missed(plane, way->normal, box));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 2> lo{infinity, infinity}, hi{-infinity, -infinity};
    const Vec3 from = corners.front();
    for (const Vec3& corner : corners) {
        const std::array<double, 2> place{glm::dot(corner - from, way->across),
                                          glm::dot(corner - from, way->up)};
        for (std::size_t k = 0; k < 2; ++k) {
            lo[k] = std::min(lo[k], place[k]);
            hi[k] = std::max(hi[k], place[k]);
        }
    }
    return PlaneWindow{from + lo[0] * way->across + lo[1] * way->up, (hi[0] - lo[0]) * way->across,
                       (hi[1] - lo[1]) * way->up};
}

} // namespace wakesurf::core
