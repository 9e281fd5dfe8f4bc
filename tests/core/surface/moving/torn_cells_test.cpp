// Where no cells can follow the particles, a moving surface is torn and says so, and does not grow without
// end.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/mesh_measures.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::core::torn_cells_test {

namespace {

using namespace tests;

/// A channel with a part of its inner nodes moved by up to one and a half cells: the cells round them are
/// folded, and a particle that goes from one into another meets another velocity.
std::unique_ptr<Flow> channel(double folded, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto part = [&] { return static_cast<double>(random()) / std::mt19937::max(); };
    CellMesh mesh = block(
        {24, 12, 12}, [](const Vec3& u) { return Vec3(4.0, 2.0, 2.0) * u - Vec3(0, 1, 1); }, false);
    for (Vec3& p : mesh.points) {
        const bool inside = p.x > 0.1 && p.x < 3.9 && std::abs(p.y) < 0.9 && std::abs(p.z) < 0.9;
        const double x = part(), y = part(), z = part();
        if (inside && part() < folded)
            p += 0.25 * (2.0 * Vec3(x, y, z) - 1.0);
    }
    return meshed_flow(
        std::move(mesh), {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, [](const Vec3& p, double t) {
            return Vec3(1.0 + 0.3 * std::sin(3.0 * p.y + t), 0.4 * std::sin(2.0 * p.x - t),
                        0.3 * std::cos(2.0 * p.x + p.y));
        });
}

SurfaceStatistics built(const Flow& flow, SurfaceKind kind, Accuracy accuracy) {
    SurfaceParameters p{.kind = kind, .to = 5.0, .separation = 0.2, .accuracy = accuracy};
    const Rake rake{Rake::Kind::Line, {{0.05, 0.3, -0.8}, {0.05, 0.3, 0.8}}, 12};
    const auto surface = build_surface(flow, rake, p);
    EXPECT_TRUE(surface) << surface.error().message;
    return surface ? surface->statistics : SurfaceStatistics{};
}

} // namespace

TEST(TornCells, InFoldedMeshesTheSurfaceDoesNotGrowWithoutEnd) {
    const auto straight = channel(0.0, 0);
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
        SCOPED_TRACE(static_cast<int>(accuracy));
        const SurfaceStatistics whole = built(*straight, SurfaceKind::Streak, accuracy);
        EXPECT_EQ(whole.torn, 0u);
        // What is too thin to be cut goes into its neighbours. When it was cut, balanced surfaces had 17
        // times the quads, exact ones 415 times.
        for (std::uint32_t seed = 1; seed < 3; ++seed)
            EXPECT_LE(built(*channel(0.03, seed), SurfaceKind::Streak, accuracy).quads,
                      2 * whole.quads);
    }
}

TEST(TornCells, AreCountedWhereABodyPartsASheet) {
    SurfaceParameters p{.kind = SurfaceKind::Streak, .to = 6.0, .separation = 0.1};
    const auto flow = make_analytic_flow("cylinder");
    const Rake rake{Rake::Kind::Line, {{-2, -0.6, -1}, {-2, 0.6, 1}}, 12};
    const auto surface = value_of(build_surface(**flow, rake, p));
    EXPECT_GT(surface.statistics.torn, 0u);
}

/// The slowest particles lag behind their neighbours by thousands of their own distances, but nothing is torn
/// there.
TEST(TornCells, TakeNothingFromASheetThatBeginsAtAWall) {
    CellMesh mesh = block(
        {24, 12, 12}, [](const Vec3& u) { return Vec3(4.0, 2.0, 2.0) * u - Vec3(0, 1, 1); }, false);
    const auto flow = meshed_flow(std::move(mesh), {0.0, 1.0, 2.0},
                                  [](const Vec3& p, double) { return Vec3(1.0 + p.z, 0.0, 0.0); });
    for (const double from_wall : {1e-3, 1e-4, 1e-5})
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            SCOPED_TRACE(std::to_string(from_wall) + " " +
                         std::to_string(static_cast<int>(accuracy)));
            SurfaceParameters p{
                .kind = SurfaceKind::Streak, .to = 2.0, .separation = 0.2, .accuracy = accuracy};
            const Rake rake{
                Rake::Kind::Line, {{0.05, 0.3, -1.0 + from_wall}, {0.05, 0.3, 0.0}}, 12};
            const auto surface = value_of(build_surface(*flow, rake, p));
            EXPECT_NEAR(area(surface.mesh), 1.0, 1e-3); // the way of each seed, summed
        }
}

TEST(TornCells, AreNotCountedForSurfacesThatDoNotMove) {
    const auto straight = channel(0.0, 0);
    EXPECT_EQ(built(*straight, SurfaceKind::Path, Accuracy::Balanced).torn, std::nullopt);
}

} // namespace wakesurf::core::torn_cells_test
