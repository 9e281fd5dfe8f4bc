// Curves by one Taylor series a cell, beside Runge-Kutta steps.
#include "core/field/cells/cell_steps.hpp"
#include "core/field/trace_curves.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wakesurf::core::cell_path_test {

using namespace tests;

namespace {

Vec3 swirl(const Vec3& p) {
    return {1.0 + 0.4 * std::sin(3.0 * p.y + p.z), std::cos(2.0 * p.x + p.z), p.x * p.y - 0.3};
}

Vec3 later(const Vec3& p) {
    return {1.2 - 0.3 * p.z, 0.7 * std::sin(3.0 * p.x), 0.4 - p.x * p.z};
}

MeshedField refined() {
    return {TwoToOne(
                8,
                [](const Vec3& c) {
                    return glm::length(c - 0.5) < 0.3 ? TwoToOne::Kind::Fine
                                                      : TwoToOne::Kind::Coarse;
                },
                wavy)
                .take(),
            swirl, later};
}

template <std::size_t Order>
Vec3 at(const PathSeriesOf<Order>& series, double t) {
    return {series.at(0, t), series.at(1, t), series.at(2, t)};
}

} // namespace

TEST(CellPath, SeriesHasTheVelocityOfTheCellAndItsTwoFormsAgree) {
    for (CellMesh& mesh : single_cells()) {
        const MeshedField field(std::move(mesh), swirl, later);
        CellSampler sampler = field.sampler();
        sampler.interval = 2.0;
        const auto cursor = sampler.cursor();
        CellGeometry geometry;
        geometry.enter(*field.mesh, 0);
        const Vec3 p = geometry.position(cell_centre(geometry.shape()));
        for (const double sign : {1.0, -1.0}) {
            ASSERT_EQ(cursor.status(p), PointStatus::Inside);
            CellPath path = cursor.path(p, 0.5, sign, false);
            const auto five = cursor.series<0, 5>(path, p);
            const auto eight = cursor.series<5, 8>(path, p);
            const auto check = [&](const auto& series, double t, double most, double most_slope) {
                const Vec3 x = at(series.space, t);
                EXPECT_LT(glm::length(geometry.position(at(series.local, t)) - x), most);
                const Vec3 slope(series.space.slope(0, t), series.space.slope(1, t),
                                 series.space.slope(2, t));
                EXPECT_LT(glm::length(sign * cursor.velocity(x, 0.5 + sign * t) - slope),
                          most_slope);
            };
            for (const double t : {0.0, 0.01, 0.02}) {
                // What is left out is about t^6, and t^9.
                check(five, t, 1e-9, 2e-7);
                check(eight, t, 1e-12, 1e-9);
            }
        }
    }
}

TEST(MeshCellExit, IsWhereAPathFirstLeavesAlsoIfItComesBackAndLeavesThroughAnotherFace) {
    PathSeriesOf<8> path{};
    path.term[0] = {0.1, 0.0, 0.5};
    path.term[1] = {-0.55, 1.2, 0.0};
    path.term[2] = {0.8, 0.0, 0.0};
    path.term[3] = {-0.25, 0.0, 0.0}; // x < 0 from about 0.30 to 0.56
    for (const double expected : {0.35, 1.0 / 1.2}) {
        MeshCellExit exit(CellShape::Hexahedron, path);
        EXPECT_NEAR(exit.time, 1.0 / 1.2, 1e-6); // the first three terms know of no other
        EXPECT_TRUE(exit.is_after(path, 0.25));
        EXPECT_FALSE(exit.is_after(path, expected));
        exit.sharpen(path, expected);
        EXPECT_NEAR(path.at(0, exit.time), -1e-7, 2e-8);
        EXPECT_NEAR(exit.time, 0.302, 1e-3);
    }
}

TEST(CellPath, CurvesEndWhereRungeKuttaStepsOfALowToleranceEnd) {
    const MeshedField field = refined();
    CellSampler sampler = field.sampler();
    sampler.interval = 1.5;
    std::mt19937 random(31);
    for (const bool frozen : {true, false})
        for (const double sign : {+1.0, -1.0})
            for (int i = 0; i < 50; ++i) {
                const double duration = sign * 0.6;
                Curve series, steps;
                series.seed = steps.seed = 0.3 + 0.4 * field.random_point(random);
                series.duration = steps.duration = duration;
                series.release = steps.release = 0.7;
                TraceOptions options{.frozen = frozen, .longest_step = 0.1};
                ASSERT_TRUE(advance_curve(sampler.series_steps(options, sign), series, options,
                                          duration, {}));
                options.tolerance = 1e-10;
                const auto field_there = sampler.cursor();
                ASSERT_TRUE(advance_curve(RungeKuttaSteps(field_there, options, sign), steps,
                                          options, duration, {}));
                EXPECT_EQ(series.end, steps.end);
                // A millionth of the length, and what the flow makes of it.
                EXPECT_LT(glm::length(series.last.position - steps.last.position), 1e-5);
                EXPECT_NEAR(series.last.arc, steps.last.arc, 1e-4 * steps.last.arc);
            }
}

TEST(CellPath, ParticlesCarryTheirTangentsToWhereRungeKuttaStepsOfALowToleranceDo) {
    const MeshedField field = refined();
    CellSampler sampler = field.sampler();
    sampler.interval = 1.5;
    std::mt19937 random(41);
    std::size_t left = 0;
    for (const double to : {0.7 - 0.6, 0.7 + 0.6})
        for (int i = 0; i < 100; ++i) {
            ParticleState series{
                {field.random_point(random), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.7, CurveEnd::Running};
            ParticleState steps = series;
            AdvanceOptions options{.method = AdvanceOptions::Method::Dopri5, .longest_step = 0.1};
            options.tolerance = 1e-7;
            ASSERT_TRUE(advance_in_series(sampler.cursor(), series, to, options, true));
            options.tolerance = 1e-10;
            advance_particle(sampler.cursor(), steps, to, options, true);
            ASSERT_EQ(series.end, steps.end);
            left += series.end == CurveEnd::Domain;
            // Of the length, and what the flow makes of it.
            EXPECT_LT(glm::length(series.carried.position - steps.carried.position), 1e-6);
            if (series.end == CurveEnd::Domain)
                continue; // its tangents are those of the whole last step
            EXPECT_LT(glm::length(series.carried.along_s - steps.carried.along_s), 2e-4);
            EXPECT_LT(glm::length(series.carried.along_t - steps.carried.along_t), 2e-4);
            EXPECT_NEAR(series.carried.expansion, steps.carried.expansion, 5e-4);
        }
    EXPECT_GT(left, 20u);
    EXPECT_LT(left, 180u);
}

TEST(CellPath, TangentsTurnWithTheFluidWhereACellIsMuchLongerThanTheSteps) {
    const MeshedField field(block({1, 1, 1}, [](const Vec3& u) { return 4.0 * u - 2.0; }),
                            [](const Vec3& p) { return Vec3(-p.y, p.x, 0.0); });
    double before = 0.1;
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        ParticleState at{{Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.0, CurveEnd::Running};
        const AdvanceOptions options{.method = AdvanceOptions::Method::Dopri5,
                                     .tolerance = tolerance,
                                     .longest_step = 100.0};
        ASSERT_TRUE(
            advance_in_series(field.sampler().cursor(), at, 2.0 * std::numbers::pi, options, true));
        const Vec3 off = at.carried.position - Vec3(1, 0, 0);
        EXPECT_LT(glm::length(off), 2.0 * std::numbers::pi * tolerance);
        const double turned = glm::length(at.carried.along_s - Vec3(1, 0, 0));
        EXPECT_LT(turned, 0.5 * before); // steps of eighth order, tangents of fourth: a root
        before = turned;
    }
    EXPECT_LT(before, 1e-4);
}

TEST(CellPath, ParticlesGoTheSameWayInAnyUnits) {
    const auto end_of = [](double length, double speed) {
        const MeshedField field(block({4, 4, 4}, [&](const Vec3& u) { return length * wavy(u); }),
                                [&](const Vec3& p) { return speed * swirl(p / length); });
        std::vector<Vec3> ends;
        std::mt19937 random(9);
        for (int i = 0; i < 50; ++i) {
            ParticleState at{
                {field.random_point(random), Vec3(0.0), Vec3(0.0)}, 0.0, CurveEnd::Running};
            const AdvanceOptions options{.method = AdvanceOptions::Method::Dopri5,
                                         .tolerance = 1e-7,
                                         .longest_step = 0.1 * length};
            EXPECT_TRUE(advance_in_series(field.sampler().cursor(), at, 0.5 * length / speed,
                                          options, false));
            ends.push_back(at.carried.position / length);
        }
        return ends;
    };
    const auto ends = end_of(1.0, 1.0);
    for (const double length : {1e-6, 1e6})
        for (const double speed : {1e-6, 1e6}) {
            const auto others = end_of(length, speed);
            for (std::size_t i = 0; i < ends.size(); ++i)
                EXPECT_LT(glm::length(others[i] - ends[i]), 1e-6);
        }
}

TEST(CellPath, TakesAboutAStepACell) {
    const MeshedField field = refined();
    const CellSampler sampler = field.sampler();
    std::vector<Curve> curves(100);
    std::mt19937 random(37);
    std::size_t steps = 0, cells = 0;
    for (Curve& curve : curves) {
        curve.seed = field.random_point(random) * Vec3(0.1, 1.0, 1.0);
        curve.duration = 5.0;
    }
    TraceOptions options{.frozen = true, .longest_step = 0.1};
    ASSERT_TRUE(trace_curves(sampler, std::span(curves), options, 1e9, {}));
    for (const Curve& curve : curves) {
        steps += curve.steps.size();
        const auto cursor = sampler.cursor();
        std::uint32_t last = CellCursor::nowhere;
        for (double arc = 0.0; arc <= curve.last.arc; arc += 1e-4) {
            ASSERT_EQ(cursor.status(curve.at_arc(arc).position), PointStatus::Inside);
            cells += cursor.place().cell() != last;
            last = cursor.place().cell();
        }
    }
    EXPECT_LT(static_cast<double>(steps), 1.3 * static_cast<double>(cells));
}

TEST(CellPath, PassesThroughAPyramidsApex) {
    CellMesh mesh; // two pyramids with their apexes together
    mesh.points = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1.25}, {-1, 1, -1}, {0, 0, 0},
                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1.5},   {-1, 1, 1}};
    add_cell(mesh, CellShape::Pyramid, {0, 1, 2, 3, 4});
    add_cell(mesh, CellShape::Pyramid, {8, 7, 6, 5, 4});
    connect_cells(mesh);
    const MeshedField field(std::move(mesh), [](const Vec3&) { return Vec3(0, 0, 1); });
    Curve curve;
    curve.seed = {0, 0, -0.9};
    curve.duration = 1.5;
    TraceOptions options{.frozen = true, .longest_step = 0.5};
    ASSERT_TRUE(
        advance_curve(field.sampler().series_steps(options, +1.0), curve, options, 1.5, {}));
    EXPECT_EQ(curve.end, CurveEnd::Time);
    EXPECT_LT(glm::length(curve.last.position - Vec3(0, 0, 0.6)), 1e-9);
}

} // namespace wakesurf::core::cell_path_test
