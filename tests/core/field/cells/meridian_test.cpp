// Flows that are the same all the way round an axis, known in a thin wedge: beside closed forms, and turned.
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/meshed_source.hpp"

#include <gtest/gtest.h>

#include <map>

namespace wakesurf::core::meridian_test {

using namespace tests;

namespace {

constexpr double half_angle = 0.03;

/// An axis that lies along no coordinate.
SymmetryAxis slanting() {
    const Vec3 direction = glm::normalize(Vec3(2.0, -1.0, 0.5));
    return {
        {0.3, 0.2, -0.1}, direction, glm::normalize(glm::cross(direction, Vec3(0.0, 0.0, 1.0)))};
}

/// Along the axis, from it, and the angle from the half plane of the mesh.
Vec3 place(const SymmetryAxis& axis, double along, double radius, double angle) {
    return axis.origin + along * axis.direction + radius * std::cos(angle) * axis.radial +
           radius * std::sin(angle) * glm::cross(axis.direction, axis.radial);
}

/// A tube from radius 0.2 to 1, two long; uneven cells.
CellMesh tube_wedge(std::uint32_t n) {
    CellMesh mesh = block({2 * n, n, 1}, [](const Vec3& u) {
        return place(slanting(), 2.0 * u.x, 0.2 + 0.8 * (u.y + 0.05 * std::sin(9.0 * u.y)),
                     half_angle * (2.0 * u.z - 1.0));
    });
    mesh.axis = slanting();
    return mesh;
}

/// Turns round the axis as a solid does, and moves along it; linear in space, so that meshes have it exactly.
Vec3 screw(const Vec3& p) {
    const SymmetryAxis axis = slanting();
    return 0.5 * axis.direction + 3.0 * glm::cross(axis.direction, p - axis.origin);
}

} // namespace

TEST(Meridian, GridsReachAllTheWayRound) {
    const SymmetryAxis axis = slanting();
    const Grid grid = tube_wedge(4);
    const Box box = bounds(grid);
    for (const double along : {0.0, 2.0})
        for (int k = 0; k < 3; ++k) {
            const double reach = std::sqrt(1.0 - axis.direction[k] * axis.direction[k]);
            const double middle = axis.origin[k] + along * axis.direction[k];
            EXPECT_GE(middle - reach, box.lo[k] - 1e-12);
            EXPECT_LE(middle + reach, box.hi[k] + 1e-12);
        }
    EXPECT_NEAR(finest_spacing(grid), 0.2, 0.1) << "of the half plane, however thin the wedge";
}

TEST(Meridian, TheFieldIsTheSameAtEveryAngleButForItsTurn) {
    const SymmetryAxis axis = slanting();
    const Vec3 around = glm::cross(axis.direction, axis.radial);
    const auto flow = meshed_flow(tube_wedge(6), {0.0}, [&](const Vec3& p, double) {
        const double along = glm::dot(p - axis.origin, axis.direction);
        const Vec3 out = p - axis.origin - along * axis.direction;
        return std::sin(3.0 * along) * axis.direction +
               std::cos(2.0 * along) * out * glm::length(out);
    });
    for (const double angle : {0.0, 0.7, 2.9, -1.3, 3.14159})
        for (const auto& [along, radius] : {std::pair{0.3, 0.5}, {1.1, 0.25}, {1.9, 0.97}}) {
            const std::vector<Vec3> at{place(axis, along, radius, 0.0),
                                       place(axis, along, radius, angle)};
            std::vector<Vec3> v(2);
            ASSERT_TRUE(flow->sample(at, std::vector<double>(2, 0.0), v, {}).has_value());
            const double x = glm::dot(v[0], axis.radial);
            const double y = glm::dot(v[0], around);
            const Vec3 turned = glm::dot(v[0], axis.direction) * axis.direction +
                                (x * std::cos(angle) - y * std::sin(angle)) * axis.radial +
                                (x * std::sin(angle) + y * std::cos(angle)) * around;
            EXPECT_LT(glm::length(v[1] - turned), 1e-12);
            EXPECT_EQ(flow->status(at[1]), PointStatus::Inside);
        }
    EXPECT_EQ(flow->status(place(axis, 1.0, 0.1, 2.0)), PointStatus::OutsideDomain);
    EXPECT_EQ(flow->status(place(axis, 1.0, 1.1, 2.0)), PointStatus::OutsideDomain);
}

TEST(Meridian, CurvesOfAScrewKeepTheirRadiusAndGoRoundAsTheClosedFormDoes) {
    const SymmetryAxis axis = slanting();
    const auto flow =
        meshed_flow(tube_wedge(5), {0.0, 4.0}, [](const Vec3& p, double) { return screw(p); });
    std::vector<Curve> curves(5);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        curves[i].seed =
            place(axis, 0.05, 0.3 + 0.15 * static_cast<double>(i), 1.3 * static_cast<double>(i));
        curves[i].duration = 3.5;
    }
    TraceOptions options;
    options.tolerance = 1e-9;
    options.longest_step = 0.1;
    ASSERT_TRUE(flow->trace(curves, options, {}).has_value());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Vec3 exact = place(axis, 0.05 + 0.5 * 3.5, 0.3 + 0.15 * static_cast<double>(i),
                                 1.3 * static_cast<double>(i) + 3.0 * 3.5);
        EXPECT_NEAR(curves[i].last.time, 3.5, 1e-9);
        EXPECT_LT(glm::length(curves[i].last.position - exact), 2e-6) << "of 32-bit velocities";
    }
}

TEST(Meridian, ARingOfAFlowWithoutSwirlStaysARing) {
    const SymmetryAxis axis = slanting();
    const auto flow = meshed_flow(tube_wedge(8), {0.0, 1.0, 2.0}, [&](const Vec3& p, double t) {
        const double along = glm::dot(p - axis.origin, axis.direction);
        const Vec3 out = p - axis.origin - along * axis.direction;
        return axis.direction + 0.2 * std::sin(4.0 * along + t) * out;
    });
    const Vec3 centre = axis.origin + 0.1 * axis.direction;
    const Rake ring{
        Rake::Kind::Circle, {centre, place(axis, 0.1, 0.6, 0.0), place(axis, 0.1, 0.6, 1.57)}, 32};
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        SurfaceParameters p;
        p.kind = kind;
        p.to = 1.5;
        p.separation = 0.2;
        const auto surface = build_surface(*flow, ring, p);
        ASSERT_TRUE(surface.has_value()) << surface.error().message;
        const auto& mesh = surface->mesh;
        ASSERT_GT(mesh.vertices(), 100u);
        // One radius for all vertices that are as far along the axis.
        std::map<long, std::pair<double, double>> radii;
        for (const Vec3& v : mesh.position) {
            const double along = glm::dot(v - axis.origin, axis.direction);
            const double radius = glm::length(v - axis.origin - along * axis.direction);
            auto& [least, most] =
                radii.try_emplace(std::lround(1e6 * along), radius, radius).first->second;
            least = std::min(least, radius);
            most = std::max(most, radius);
        }
        EXPECT_LT(radii.size(), mesh.vertices() / 4);
        for (const auto& [along, range] : radii)
            EXPECT_LT(range.second - range.first, 1e-5) << along;
    }
}

} // namespace wakesurf::core::meridian_test
