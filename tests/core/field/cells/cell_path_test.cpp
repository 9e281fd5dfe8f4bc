// Curves by one Taylor series a cell, beside Runge-Kutta steps.
#include "core/field/cells/cell_steps.hpp"
#include "core/field/trace_curves.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

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

Vec3 at(const PathSeries& series, double t) {
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
            const CellPath path = cursor.path(p, 0.5, sign, false);
            for (const double t : {0.0, 0.01, 0.02}) {
                const Vec3 x = at(path.space, t);
                // Order 5: what is left out is about t^6.
                EXPECT_LT(glm::length(geometry.position(at(path.local, t)) - x), 1e-9);
                const Vec3 slope(path.space.slope(0, t), path.space.slope(1, t),
                                 path.space.slope(2, t));
                EXPECT_LT(glm::length(sign * cursor.velocity(x, 0.5 + sign * t) - slope), 2e-7);
            }
        }
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
