// Surfaces of every kind through meshes of cells: the engine knows flows only.
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::cell_surface_test {

using namespace tests;

namespace {

constexpr SurfaceKind kinds[] = {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                                 SurfaceKind::Time};

SurfaceParameters parameters(SurfaceKind kind, double to, double separation) {
    SurfaceParameters p{.kind = kind, .to = to, .separation = separation};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 0.0, 0.2);
    return p;
}

Vec3 round_it(const Vec3& p) {
    const double r2 = std::max(0.25, p.x * p.x + p.y * p.y);
    const double part = 0.25 / (r2 * r2);
    return {1.0 - part * (p.x * p.x - p.y * p.y), -2.0 * part * p.x * p.y, 0.0};
}

} // namespace

TEST(CellSurface, VerticesOfEveryKindKeepTheirDistanceFromTheAxisOfARotation) {
    const auto flow = meshed_flow(
        TwoToOne(
            9,
            [](const Vec3& c) {
                return glm::length(c - 0.5) < 0.3 ? TwoToOne::Kind::Fine : TwoToOne::Kind::Coarse;
            },
            wavy)
            .take(),
        {0.0, 1.0, 2.0, 3.0},
        [](const Vec3& p, double) { return Vec3(0.5 - p.y, p.x - 0.5, 0.0); });
    const Rake rake{Rake::Kind::Line, {{0.6, 0.5, 0.4}, {0.9, 0.5, 0.4}}, 16};
    for (const SurfaceKind kind : kinds) {
        SurfaceParameters p = parameters(kind, 3.0, 0.04);
        p.accuracy = Accuracy::Exact;
        const auto surface = value_of(build_surface(*flow, rake, p));
        EXPECT_EQ(surface.mesh.validate(), "");
        EXPECT_GT(surface.mesh.cells.size(), 50u);
        for (std::size_t i = 0; i < surface.mesh.vertices(); ++i) {
            const Vec3 from_axis = surface.mesh.position[i] - Vec3(0.5, 0.5, 0.0);
            EXPECT_NEAR(std::hypot(from_axis.x, from_axis.y), 0.1 + 0.3 * surface.mesh.s[i], 2e-5);
            EXPECT_LT(
                glm::length(Vec3(surface.mesh.velocity[i]) - Vec3(-from_axis.y, from_axis.x, 0.0)),
                1e-6);
        }
    }
}

TEST(CellSurface, OfEveryKindIsWholeBesideACylinderAndNeverInIt) {
    CellMesh mesh = block({30, 60, 6}, round_cylinder, true);
    mark_walls(mesh, [](const Vec3& c) { return std::hypot(c.x, c.y) < 0.51; });
    const auto flow = meshed_flow(std::move(mesh), {0.0, 2.0, 4.0, 6.0},
                                  [](const Vec3& p, double) { return round_it(p); });
    EXPECT_TRUE(flow->obstacle());
    const Rake rake{Rake::Kind::Line, {{-2.5, -1.0, 2.0}, {-2.5, 1.0, 3.5}}, 16};
    for (const SurfaceKind kind : kinds) {
        const auto surface = value_of(build_surface(*flow, rake, parameters(kind, 6.0, 0.2)));
        EXPECT_EQ(surface.mesh.validate(), "");
        double farthest = -10.0;
        for (const Vec3& p : surface.mesh.position) {
            // Within the chords of 60 sides of the circle, which turn by 3 degrees from layer to layer.
            EXPECT_GT(std::hypot(p.x, p.y),
                      0.5 * std::cos(3.1416 / 60.0) * std::cos(3.1416 / 120.0) - 1e-6);
            farthest = std::max(farthest, p.x);
        }
        EXPECT_GT(farthest, 2.0);
    }
}

} // namespace wakesurf::core::cell_surface_test
