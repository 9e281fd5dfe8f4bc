// Particles at faces that velocity points at from either side, as where cells of different sizes meet, and what bounds their steps.
#include "core/field/cells/cell_steps.hpp"
#include "core/field/field_in_series.hpp"
#include "tests/support/meshed_field.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace wakesurf::core::sliding_particles_test {

using namespace tests;

namespace {

/// Two layers of cells that share no nodes: at y = 1 the velocity jumps from (1, `lower`, 0) to (1, `upper`, 0).
MeshedField layers(float lower, float upper) {
    CellMesh mesh;
    add_block(mesh, {8, 2, 2}, [](const Vec3& u) { return u * Vec3(4.0, 1.0, 1.0); });
    const std::size_t below = mesh.points.size();
    add_block(mesh, {8, 2, 2},
              [](const Vec3& u) { return Vec3(0, 1, 0) + u * Vec3(4.0, 1.0, 1.0); });
    connect_cells(mesh);
    MeshedField field(std::move(mesh), [](const Vec3&) { return Vec3(1, 0, 0); });
    for (std::size_t i = 0; 3 * i < field.velocity0.size(); ++i)
        field.velocity0[3 * i + 1] = i < below ? lower : upper;
    return field;
}

Curve traced(const MeshedField& field, const Vec3& seed, double duration) {
    Curve curve;
    curve.seed = seed;
    curve.duration = duration;
    TraceOptions options{.frozen = true, .longest_step = 0.5};
    EXPECT_TRUE(
        advance_curve(field.sampler().series_steps(options, +1.0), curve, options, duration, {}));
    return curve;
}

} // namespace

TEST(SlidingParticles, FollowTheFaceThatVelocityPointsAtFromEitherSide) {
    const MeshedField field = layers(0.5f, -0.25f);
    for (const double y : {0.61, 0.93, 1.07, 1.4}) {
        const Curve curve = traced(field, {0.05, y, 0.4}, 3.5);
        EXPECT_EQ(curve.end, CurveEnd::Time) << y;
        // A hundredth of a cell, as far as steps grow.
        EXPECT_NEAR(curve.last.position.y, 1.0, 0.01) << y;
        EXPECT_NEAR(curve.last.position.x, 3.55, 1e-9) << y;
        EXPECT_LT(curve.attempts, 4'000u) << y;
    }
}

TEST(SlidingParticles, GoAlongSidesOfAnyDirectionToTheEndThoughPointsAndVelocitiesAreRounded) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    for (int turn = 0; turn < 12; ++turn) {
        const glm::dmat3 matrix(
            glm::rotate(glm::rotate(glm::dmat4(1.0), angle(random), Vec3(0, 0, 1)), angle(random),
                        Vec3(1, 0, 0)));
        const Vec3 origin = turn % 3 == 0 ? Vec3(0.0) : Vec3(angle(random), 40.0, angle(random));
        const auto placed = [&](const Vec3& u) { return origin + matrix * (2.0 * u); };
        const auto rounded = [&](const Vec3& u) { return Vec3(glm::vec3(placed(u))); };
        CellMesh mesh = turn % 2 == 0 ? block({9, 7, 5}, rounded)
                                      : TwoToOne(
                                            4,
                                            [](const Vec3& c) {
                                                return c.x < 0.5 ? TwoToOne::Kind::Fine
                                                                 : TwoToOne::Kind::Coarse;
                                            },
                                            rounded)
                                            .take();
        if (turn % 4 >= 2) // walls that the fluid slides along
            mark_walls(mesh, [&](const Vec3& centre) {
                const Vec3 u = 0.5 * (glm::transpose(matrix) * (centre - origin));
                return std::abs(u.y - 0.5) > 0.4999 || std::abs(u.z - 0.5) > 0.4999;
            });
        const MeshedField field(std::move(mesh),
                                [&](const Vec3&) { return matrix * Vec3(1.0, 0.0, 0.0); });
        for (const Vec3& u : {Vec3(0.1, 0.0, 0.3), Vec3(0.1, 0.7, 0.0), Vec3(0.1, 1.0, 0.4),
                              Vec3(0.1, 0.35, 1.0), Vec3(0.1, 0.0, 0.0), Vec3(0.1, 1.0, 1.0)}) {
            const Curve curve = traced(field, placed(u), 1.7);
            EXPECT_EQ(curve.end, CurveEnd::Time) << turn << ": " << curve.last.time;
            EXPECT_LT(glm::length(curve.last.position - placed(u + Vec3(0.85, 0.0, 0.0))), 4e-5);
            EXPECT_LT(curve.attempts, 400u);
        }
    }
}

TEST(SlidingParticles, LeaveWhereTheFlowDoesHoweverSlantedTheSide) {
    const glm::dmat3 matrix(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(Vec3(1, 2, 3))));
    const MeshedField field(block({9, 7, 5}, [&](const Vec3& u) { return matrix * (2.0 * u); }),
                            [&](const Vec3&) { return matrix * Vec3(1.0, -1e-3, 0.0); });
    for (const double height : {0.0, 2e-4, 1e-3}) {
        const Curve curve = traced(field, matrix * Vec3(0.1, height, 0.6), 1.7);
        EXPECT_EQ(curve.end, CurveEnd::Domain);
        EXPECT_NEAR(curve.last.time, 1e3 * height, 1e-3);
    }
}

TEST(SlidingParticles, PassAFaceThatVelocityOnlyTurnsAt) {
    const MeshedField field = layers(0.5f, 0.25f);
    const Curve curve = traced(field, {0.05, 0.61, 0.4}, 3.0);
    EXPECT_NEAR(curve.last.position.y, 1.0 + 0.25 * (3.0 - 0.39 / 0.5), 1e-6);
    EXPECT_LT(curve.attempts, 30u);
}

TEST(SlidingParticles, ThatTakeTooManyStepsEndAndSaySo) {
    const MeshedField field = layers(0.5f, -0.25f);
    AdvanceOptions options{
        .method = AdvanceOptions::Method::Dopri5, .longest_step = 0.5, .most_steps = 50};
    ParticleState slides{{{0.05, 0.93, 0.4}, Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.0, CurveEnd::Running};
    EXPECT_TRUE(advance_in_series(field.sampler().cursor(), slides, 3.5, options, true));
    EXPECT_EQ(slides.end, CurveEnd::Budget);
    EXPECT_LT(slides.time, 3.5);
    ParticleState passes{{{0.05, 0.2, 0.4}, Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.0, CurveEnd::Running};
    EXPECT_TRUE(advance_in_series(field.sampler().cursor(), passes, 1.0, options, true));
    EXPECT_EQ(passes.end, CurveEnd::Running);
    EXPECT_EQ(passes.time, 1.0);
}

TEST(SlidingParticles, StopOnTheirWay) {
    const MeshedField field = layers(0.5f, -0.25f);
    std::stop_source stop;
    stop.request_stop();
    AdvanceOptions options{.method = AdvanceOptions::Method::Dopri5, .longest_step = 0.5};
    ParticleState at{{{0.05, 0.93, 0.4}, Vec3(0.0), Vec3(0.0)}, 0.0, CurveEnd::Running};
    EXPECT_FALSE(
        advance_in_series(field.sampler().cursor(), at, 3.5, options, false, stop.get_token()));
}

TEST(SlidingParticles, AWallIsSaidToBeNearWhereverAnEdgeBetweenFluidEndsGoesThroughIt) {
    CellMesh mesh = block({30, 60, 6}, round_cylinder, true);
    mark_walls(mesh, [](const Vec3& c) { return std::hypot(c.x, c.y) < 0.51; });
    const MeshedField field(std::move(mesh), [](const Vec3&) { return Vec3(1, 0, 0); });
    std::mt19937 random(3);
    int through = 0, free = 0, passing = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 a = 0.4 * field.random_point(random), b = a + 0.2 * field.random_point(random);
        const CellSampler sampler = field.sampler();
        if (sampler.status(a) != PointStatus::Inside || sampler.status(b) != PointStatus::Inside)
            continue;
        const bool near = field.domain.walls.near({glm::min(a, b), glm::max(a, b)});
        const bool crosses = sampler.status(0.5 * (a + b)) == PointStatus::InObstacle;
        const bool may_cross = field.domain.walls.may_cross(a, b);
        EXPECT_TRUE(near || !may_cross);
        EXPECT_TRUE(may_cross || !crosses);
        passing += near && !may_cross;
        through += crosses;
        free += !near;
    }
    EXPECT_GT(through, 50);
    EXPECT_GT(free, 500);
    EXPECT_GT(passing, 50);
}

} // namespace wakesurf::core::sliding_particles_test
