// Walls that particles must not cross: thin ones inside the fluid, obstacles' corners, at any length of step.
#include "core/field/advance_particles.hpp"
#include "core/field/cells/cell_steps.hpp"
#include "core/field/trace_curves.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::cell_walls_test {

using namespace tests;

namespace {

/// A wall without thickness at x = 1/2, up to y = 0.6.
MeshedField baffle(const MeshedField::Flow& flow) {
    CellMesh mesh = block({10, 10, 4}, [](const Vec3& u) { return u; });
    mark_walls(mesh, [](const Vec3& c) { return std::abs(c.x - 0.5) < 1e-9 && c.y < 0.6; });
    return {std::move(mesh), flow};
}

/// A square cylinder from (0.4, 0.4) to (0.6, 0.6), refined round it.
MeshedField square_cylinder(const MeshedField::Flow& flow) {
    CellMesh mesh = TwoToOne(
                        10,
                        [](const Vec3& c) {
                            const double away = std::max(std::abs(c.x - 0.5), std::abs(c.y - 0.5));
                            return away < 0.1   ? TwoToOne::Kind::Hole
                                   : away < 0.2 ? TwoToOne::Kind::Fine
                                                : TwoToOne::Kind::Coarse;
                        },
                        [](const Vec3& u) { return u; })
                        .take();
    mark_walls(mesh, [](const Vec3& c) {
        return std::max(std::abs(c.x - 0.5), std::abs(c.y - 0.5)) < 0.1 + 1e-9;
    });
    return {std::move(mesh), flow};
}

/// Points this near to a wall are on it: face_tolerance of a cell.
constexpr double on_wall = 1e-9;

bool goes_through_baffle(const Vec3& a, const Vec3& b) {
    if ((a.x - 0.5) * (b.x - 0.5) >= 0.0 || std::abs(b.x - 0.5) < on_wall)
        return false;
    return a.y + (b.y - a.y) * (0.5 - a.x) / (b.x - a.x) < 0.6 - 1e-9;
}

bool goes_through_square(const Vec3& a, const Vec3& b) {
    double in = 0.0, out = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        const double first = (0.4 - a[axis]) / way, second = (0.6 - a[axis]) / way;
        in = std::max(in, std::min(first, second));
        out = std::min(out, std::max(first, second));
    }
    return (out - in) * glm::length(b - a) > 10.0 * on_wall;
}

/// A particle's cursor that checks the way from each place the particle may be at to the next. With long steps that is a
/// bent way in several parts, along the integrator's cubic.
template <class Through>
struct Watched {
    CellSamplerCursor cursor;
    const Through& through;
    mutable Vec3 last;
    mutable int crossings = 0;

    Vec3 velocity(const Vec3& p, double t) const { return cursor.velocity(p, t); }

    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        return cursor.derivative(p, t, w);
    }

    PointStatus status(const Vec3& p) const {
        const PointStatus status = cursor.status(p);
        if (status == PointStatus::Inside) {
            crossings += through(last, p);
            last = p;
        }
        return status;
    }
};

template <class Through>
int carry(const MeshedField& field, double step, const Through& through, int& ends_at_wall) {
    std::mt19937 random(23);
    int crossings = 0;
    const CellSampler sampler = field.sampler();
    for (int i = 0; i < 400; ++i) {
        const Vec3 seed = field.random_point(random);
        if (sampler.status(seed) != PointStatus::Inside)
            continue;
        const Watched<Through> watched{sampler.cursor(), through, seed};
        AdvanceOptions options;
        options.step = step;
        ParticleState at{{seed, Vec3(0.0), Vec3(0.0)}, 0.0, CurveEnd::Running};
        for (int k = 0; k < 200 && at.end == CurveEnd::Running; ++k)
            rk4_particle_step(watched, at, step, options, false);
        EXPECT_EQ(at.carried.position, watched.last);
        crossings += watched.crossings;
        ends_at_wall += at.end == CurveEnd::Obstacle;
    }
    return crossings;
}

} // namespace

TEST(CellWalls, NoParticleCrossesAThinWallInTheFluid) {
    // The nodes of the wall have one velocity for both sides here, which drives particles into it.
    const MeshedField field =
        baffle([](const Vec3& p) { return Vec3(1.0, 0.8 * std::sin(9.0 * p.x), 0.1); });
    for (const double step : {0.003, 0.03, 0.3, 0.9}) {
        int at_wall = 0;
        EXPECT_EQ(carry(field, step, goes_through_baffle, at_wall), 0) << step;
        EXPECT_GT(at_wall, 20) << step;
    }
}

TEST(CellWalls, NoParticleCutsTheCornerOfAnObstacle) {
    const MeshedField field = square_cylinder([](const Vec3& p) {
        return Vec3(0.3 - (p.y - 0.5), p.x - 0.5, 0.05); // round and past it
    });
    for (const double step : {0.01, 0.1, 0.5, 1.0}) {
        int at_wall = 0;
        EXPECT_EQ(carry(field, step, goes_through_square, at_wall), 0) << step;
        EXPECT_GT(at_wall, 10) << step;
    }
}

TEST(CellWalls, ACurveEndsAtAThinWallAndAnotherPassesItsEnd) {
    const MeshedField field = baffle([](const Vec3&) { return Vec3(1, 0, 0); });
    std::vector<Curve> curves(2);
    curves[0].seed = {0.05, 0.3, 0.52};
    curves[1].seed = {0.05, 0.7, 0.52};
    for (Curve& curve : curves)
        curve.duration = 10.0;
    TraceOptions options{.frozen = true, .longest_step = 0.4};
    ASSERT_TRUE(trace_curves(field.sampler(), std::span(curves), options, 1e9, {}));
    EXPECT_EQ(curves[0].end, CurveEnd::Obstacle);
    EXPECT_NEAR(curves[0].last.position.x, 0.5, 1e-8);
    EXPECT_EQ(curves[1].end, CurveEnd::Domain);
    EXPECT_NEAR(curves[1].last.position.x, 1.0, 1e-8);
}

TEST(CellWalls, AParticleThatSlidesAlongAWallGoesOn) {
    // On a plane that no coordinate axis lies in, so that rounding puts points on either side of it.
    const auto turned = [](const Vec3& u) {
        return Vec3(u.x + 0.25 * u.y, 0.75 * u.y - 0.25 * u.x, u.z + 0.125 * u.x - 0.25 * u.y);
    };
    CellMesh mesh = block({20, 20, 5}, turned);
    for (MeshCell& cell : mesh.cells)
        cell.beyond[4] = cell.beyond[4] >= beyond_wall ? beyond_wall : cell.beyond[4];
    const Vec3 along = turned({0.5, 0.75, 0.0}); // exact in float
    const MeshedField field(std::move(mesh), [&](const Vec3&) { return along; });
    const auto cursor = field.sampler().cursor();
    AdvanceOptions options;
    options.step = 0.01;
    ParticleState at{{turned({0.1, 0.12, 0.0}), Vec3(0.0), Vec3(0.0)}, 0.0, CurveEnd::Running};
    advance_particle(cursor, at, 1.0, options, false);
    EXPECT_EQ(at.end, CurveEnd::Running);
}

TEST(CellWalls, APlaceInAnObstacleIsSaidToBeThereHoweverDeep) {
    // As snappyHexMesh leaves a ball: cubes whose nodes near it are moved onto it.
    CellMesh mesh = TwoToOne(
                        12,
                        [](const Vec3& c) {
                            const double away = glm::length(c - 0.5);
                            return away < 0.28   ? TwoToOne::Kind::Hole
                                   : away < 0.42 ? TwoToOne::Kind::Fine
                                                 : TwoToOne::Kind::Coarse;
                        },
                        [](const Vec3& u) {
                            const double away = glm::length(u - 0.5);
                            return away > 0.265 && away < 0.32 ? 0.5 + 0.3 / away * (u - 0.5) : u;
                        })
                        .take();
    for (const BoundaryFace& each : boundary_faces(mesh)) {
        const MeshCell& cell = mesh.cells[each.cell];
        if (glm::length(mesh.points[cell.node[face(cell.shape, each.face).node[0]]] - 0.5) < 0.4)
            mesh.cells[each.cell].beyond[each.face] = beyond_wall;
    }
    const MeshedField field(std::move(mesh), [](const Vec3&) { return Vec3(1, 0, 0); });
    std::mt19937 random(3);
    int solid = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 p = field.random_point(random);
        const PointStatus status = field.sampler().status(p);
        EXPECT_NE(status, PointStatus::OutsideDomain) << p.x << " " << p.y << " " << p.z;
        solid += status == PointStatus::InObstacle;
    }
    EXPECT_GT(solid, 1000);
}

TEST(CellWalls, ASegmentThroughABentFaceIsFoundOnEitherDiagonal) {
    CellMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0.4}, {1, 1, 0}, {0, 1, 0.4},
                   {0, 0, 2}, {1, 0, 2},   {1, 1, 2}, {0, 1, 2}};
    add_cell(mesh, CellShape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
    mesh.cells[0].beyond[4] = beyond_wall;
    const CellWalls walls(mesh);
    const auto height = [](double x, double y) { return 0.4 * (x + y - 2.0 * x * y); };
    for (double x = 0.05; x < 1.0; x += 0.1)
        for (double y = 0.05; y < 1.0; y += 0.1) {
            const double z = height(x, y);
            EXPECT_TRUE(walls.crossed({x, y, z + 0.01}, {x, y, z - 0.01}));
            EXPECT_FALSE(walls.crossed({x, y, z + 0.02}, {x, y, z + 0.001}));
            EXPECT_FALSE(walls.crossed({x, y, z - 0.01}, {x, y, z + 0.01})) << "from outside";
        }
    EXPECT_FALSE(walls.crossed({1.2, 0.5, 1}, {1.2, 0.5, -1}));
}

} // namespace wakesurf::core::cell_walls_test
