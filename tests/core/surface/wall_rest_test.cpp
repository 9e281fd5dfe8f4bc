// Particles that slow down for ever before a wall that holds the fluid have reached it; those that slow down
// elsewhere came to rest in a frozen field, and wait in one that changes.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::wall_rest_test {

using namespace tests;

namespace {

/// Falls onto z = 0 ever slower and spreads over it, as fluid that the wall holds.
Vec3 onto_the_floor(const Vec3& p, double) {
    return p.z * Vec3(p.x - 0.5, p.y - 0.5, -1.0);
}

/// The same towards the middle of the box.
Vec3 onto_the_middle(const Vec3& p, double) {
    return Vec3(0.5) - p;
}

/// Stands still from time 1 on.
Vec3 stopping(const Vec3&, double t) {
    return Vec3(0.1 * std::max(0.0, 1.0 - t), 0.0, 0.0);
}

CellMesh with_floor(CellMesh mesh) {
    mark_walls(mesh, [](const Vec3& centre) { return std::abs(centre.z) < 1e-9; });
    return mesh;
}

CellMesh hexahedra() {
    return with_floor(block({8, 8, 8}, [](const Vec3& u) { return u; }));
}

/// Fine, with all shapes of cells, in a ball on the floor.
CellMesh all_shapes() {
    return with_floor(TwoToOne(
                          8,
                          [](const Vec3& c) {
                              return glm::length(c - Vec3(0.5, 0.5, 0.0)) < 0.4
                                         ? TwoToOne::Kind::Fine
                                         : TwoToOne::Kind::Coarse;
                          },
                          [](const Vec3& u) { return u; })
                          .take());
}

/// Nodes a layer deep below z = 0 are solid, those at z = 0 fluid at rest.
std::unique_ptr<Flow> on_grid(bool rectilinear, SampledSource::Velocity velocity) {
    constexpr std::uint32_t n = 10;
    SolidMask mask;
    for (std::uint32_t i = 0; i < n * n * n; ++i)
        mask.fluid.push_back(i < n * n ? 0 : 1);
    std::vector<double> across, up;
    for (std::uint32_t i = 0; i < n; ++i) {
        across.push_back(i / 9.0);
        up.push_back((double(i) - 1.0) / 8.0);
    }
    const Grid grid =
        rectilinear ? Grid(RectilinearGrid{{across, across, up}})
                    : Grid(UniformGrid{{0, 0, -1 / 8.0}, {1 / 9.0, 1 / 9.0, 1 / 8.0}, {n, n, n}});
    return make_stored_flow(std::make_shared<TimeStepCache>(
        std::make_shared<SampledSource>(grid, std::vector{0.0, 1.0, 40.0}, std::move(velocity),
                                        mask),
        TimeStepCache::Options{}));
}

const std::vector<SurfaceKind> kinds{SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                                     SurfaceKind::Time};

SurfaceStatistics::Terminated ended(const Flow& flow,
                                    SurfaceKind kind,
                                    SurfaceParameters p = {},
                                    const Vec3& from = Vec3(0.45, 0.52, 0.4)) {
    p.kind = kind;
    p.from = 0.0;
    p.to = 40.0;
    p.separation = 0.2;
    p.stagnation_speed = 1e-4;
    if (kind == SurfaceKind::Streak)
        p.release_until = 1.0;
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 0.1, 0.05);
    Rake rake{.points = {from, from + Vec3(0.12, 0.03, 0.05)}, .seeds = 5};
    const auto surface = build_surface(flow, rake, p);
    if (!surface) {
        ADD_FAILURE() << surface.error().message;
        return {};
    }
    return surface->statistics.terminated;
}

void expect_reached(const Flow& flow, const SurfaceParameters& p = {}) {
    for (const SurfaceKind kind : kinds) {
        const auto end = ended(flow, kind, p);
        EXPECT_GT(end.obstacle, 0U) << static_cast<int>(kind);
        EXPECT_EQ(end.stagnation, 0U) << static_cast<int>(kind);
    }
}

void expect_at_rest(const Flow& flow) {
    const auto end = ended(flow, SurfaceKind::Stream);
    EXPECT_GT(end.stagnation, 2U);
    EXPECT_EQ(end.obstacle, 0U);
}

/// Even beside a wall: what stands still there is the fluid.
void expect_waiting(const Flow& flow, SurfaceKind kind, Vec3 from = Vec3(0.45, 0.52, 0.4)) {
    const auto end = ended(flow, kind, {}, from);
    EXPECT_EQ(end.stagnation, 0U) << static_cast<int>(kind);
    EXPECT_EQ(end.obstacle, 0U) << static_cast<int>(kind);
}

} // namespace

TEST(WallRest, ParticlesThatTheWallOfAMeshHoldsHaveReachedIt) {
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
        SurfaceParameters p;
        p.accuracy = accuracy;
        expect_reached(*meshed_flow(hexahedra(), {0.0, 1.0, 40.0}, onto_the_floor), p);
        expect_reached(*meshed_flow(all_shapes(), {0.0, 1.0, 40.0}, onto_the_floor), p);
    }
}

TEST(WallRest, ParticlesThatTheNodesBesideSolidOnesHoldHaveReachedTheBody) {
    for (const Accuracy accuracy : {Accuracy::Balanced, Accuracy::Exact})
        for (const bool rectilinear : {false, true}) {
            SurfaceParameters p;
            p.accuracy = accuracy;
            expect_reached(*on_grid(rectilinear, onto_the_floor), p);
        }
    SurfaceParameters smooth;
    smooth.interpolation = Interpolation::Smooth;
    expect_reached(*on_grid(false, onto_the_floor), smooth);
}

TEST(WallRest, ParticlesThatStopAwayFromWallsCameToRestInAFrozenField) {
    expect_at_rest(*meshed_flow(hexahedra(), {0.0, 1.0, 40.0}, onto_the_middle));
    for (const bool rectilinear : {false, true})
        expect_at_rest(*on_grid(rectilinear, onto_the_middle));
}

TEST(WallRest, NoneEndsWhereTheFluidItselfStops) {
    const Vec3 beside_the_wall(0.45, 0.52, 0.001);
    for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Vec3& from : {Vec3(0.45, 0.52, 0.4), beside_the_wall}) {
            expect_waiting(*meshed_flow(hexahedra(), {0.0, 1.0, 40.0}, stopping), kind, from);
            for (const bool rectilinear : {false, true})
                expect_waiting(*on_grid(rectilinear, stopping), kind, from);
        }
}

TEST(WallRest, ParticlesOnTheStagnationLineOfABuiltInBodyReachIt) {
    const auto sphere = make_analytic_flow("sphere");
    Curve curve;
    curve.seed = {-2, 0, 0};
    curve.duration = 100.0;
    TraceOptions options{.frozen = true, .longest_step = 0.1, .stagnation_speed = 1e-4};
    ASSERT_TRUE((*sphere)->trace({&curve, 1}, options, {}));
    EXPECT_EQ(curve.end, CurveEnd::Obstacle);
}

} // namespace wakesurf::core::wall_rest_test
