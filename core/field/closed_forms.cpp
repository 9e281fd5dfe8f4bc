#include "core/field/closed_forms.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace wakesurf::core {

namespace {

/// A corner of the outline that is rotated about the z axis.
struct Turned {
    double radius;
    double z;
};

// Corners are 3.75 degrees apart: the chord lies 0.05 % of the radius inside the body, half a pixel of a
// sphere that fills the screen.
constexpr std::uint32_t around = 96;
constexpr int pieces_along = 48;

/// @param outline  upwards; its first and last corner are on the axis
WallGeometry turned(const std::vector<Turned>& outline, const Box& box) {
    WallGeometry wall;
    const auto add = [&](const Vec3& p) {
        wall.points.emplace_back(glm::clamp(p, box.lo, box.hi));
    };
    add({0.0, 0.0, outline.front().z});
    for (std::size_t ring = 1; ring + 1 < outline.size(); ++ring)
        for (std::uint32_t k = 0; k < around; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / around;
            const auto [radius, z] = outline[ring];
            add({radius * std::cos(angle), radius * std::sin(angle), z});
        }
    add({0.0, 0.0, outline.back().z});

    const auto rings = static_cast<std::uint32_t>(outline.size()) - 2;
    const auto top = static_cast<std::uint32_t>(wall.points.size()) - 1;
    const auto at = [](std::uint32_t ring, std::uint32_t k) {
        return 1 + ring * around + k % around;
    };
    for (std::uint32_t k = 0; k < around; ++k) {
        wall.triangles.push_back({0, at(0, k + 1), at(0, k)});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            wall.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
            wall.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
        }
        wall.triangles.push_back({at(rings - 1, k), at(rings - 1, k + 1), top});
    }
    return wall;
}

} // namespace

WallGeometry sphere_wall(double radius, const Box& box) {
    const double r = std::abs(radius);
    if (r == 0.0)
        return {};
    std::vector<Turned> outline{{0.0, -r}};
    for (int i = 1; i < pieces_along; ++i) {
        const double angle = std::numbers::pi * i / pieces_along;
        outline.push_back({r * std::sin(angle), -r * std::cos(angle)});
    }
    outline.push_back({0.0, r});
    return turned(outline, box);
}

WallGeometry cylinder_wall(double radius, const Box& box) {
    const double r = std::abs(radius);
    if (r == 0.0)
        return {};
    return turned({{0.0, box.lo.z}, {r, box.lo.z}, {r, box.hi.z}, {0.0, box.hi.z}}, box);
}

} // namespace wakesurf::core
