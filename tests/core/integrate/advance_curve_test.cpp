#include "core/field/closed_forms.hpp"
#include "core/integrate/runge_kutta.hpp"
#include "tests/support/curve_at_time.hpp"
#include "tests/support/walled_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wakesurf::core::advance_curve_test {

namespace {

template <class Form>
struct Unbounded {
    Form form;

    Vec3 velocity(const Vec3& p, double t) const { return form.velocity(p, t); }

    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        return (form.velocity(p + 1e-5 * w, t) - form.velocity(p - 1e-5 * w, t)) / 2e-5;
    }

    PointStatus status(const Vec3&) const { return PointStatus::Inside; }
};

template <class Field>
Curve traced(
    const Field& field, Vec3 seed, double duration, TraceOptions options, double release = 0.0) {
    Curve curve;
    curve.seed = seed;
    curve.release = release;
    curve.duration = duration;
    const double sign = duration < 0.0 ? -1.0 : 1.0;
    EXPECT_TRUE(advance_curve(RungeKuttaSteps(field, options, sign), curve, options, duration, {}));
    return curve;
}

const AbcFlow abc{1.0, 1.0, 0.0};

/// With C = 0, H = B sin x + A cos z is constant and y = y0 + H t exactly.
double abc_error(const Curve& curve) {
    const double h = std::sin(curve.seed.x) + std::cos(curve.seed.z);
    return std::abs(curve.last.position.y - (curve.seed.y + h * curve.last.time));
}

} // namespace

TEST(AdvanceCurve, HalvingTheRk4StepDividesTheErrorBySixteen) {
    TraceOptions options{.method = TraceOptions::Method::Rk4, .longest_step = 1.0};
    double previous = 0.0;
    for (const double step : {0.2, 0.1, 0.05}) {
        options.step = step;
        const double error =
            abc_error(traced(Unbounded<AbcFlow>{abc}, {1.0, 0.0, 0.5}, 6.0, options));
        if (previous > 0.0) {
            EXPECT_GT(std::log2(previous / error), 3.5) << "step " << step;
        }
        previous = error;
    }
}

TEST(AdvanceCurve, TheErrorFollowsTheToleranceOfDopri5) {
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
        const Curve curve = traced(Unbounded<AbcFlow>{abc}, {1.0, 0.0, 0.5}, 6.0,
                                   {.tolerance = tolerance, .longest_step = 1.0});
        EXPECT_LT(abc_error(curve), 10.0 * tolerance * curve.last.arc) << "tolerance " << tolerance;
    }
}

TEST(AdvanceCurve, DenseOutputIsAsAccurateAsTheSteps) {
    const LambOseenFlow swirl{2.0 * std::numbers::pi, 0.3, 0.5};
    const Curve curve = traced(Unbounded<LambOseenFlow>{swirl}, {0.7, 0, 0}, 4.0,
                               {.tolerance = 1e-9, .longest_step = 1.0});
    const double rate = (1.0 - std::exp(-0.49 / 0.09)) / 0.49;
    for (double t = 0.0; t <= 4.0; t += 0.037) {
        const CurvePoint point = tests::at_time(curve, t);
        const Vec3 truth(0.7 * std::cos(rate * t), 0.7 * std::sin(rate * t), 0.5 * t);
        EXPECT_LT(glm::length(point.position - truth), 2e-7) << "t " << t;
        EXPECT_NEAR(point.arc, t * std::hypot(0.7 * rate, 0.5), 2e-7);
        EXPECT_LT(glm::length(curve.at_arc(point.arc).position - point.position), 1e-10); // inverse
    }
}

TEST(AdvanceCurve, UpstreamReturnsToTheSeed) {
    const TraceOptions options{.tolerance = 1e-10, .longest_step = 1.0};
    const Curve there =
        traced(Unbounded<OscillatingFlow>{{1.0, 1.0, 2.0}}, {0, 0, 0}, 3.0, options);
    const Curve back = traced(Unbounded<OscillatingFlow>{{1.0, 1.0, 2.0}}, there.last.position,
                              -3.0, options, 3.0);
    EXPECT_LT(glm::length(back.last.position), 1e-8);
    EXPECT_NEAR(back.last.arc, there.last.arc, 1e-8);
}

TEST(AdvanceCurve, AFrozenFieldStaysAtTheReleaseTime) {
    const double release = 0.4;
    const Curve curve = traced(Unbounded<OscillatingFlow>{{1.0, 1.0, 2.0}}, {0, 0, 0}, 2.0,
                               {.frozen = true, .tolerance = 1e-9, .longest_step = 1.0}, release);
    EXPECT_NEAR(curve.last.position.y, 2.0 * std::sin(2.0 * release), 1e-9);
}

TEST(AdvanceCurve, EndsExactlyAtTheDomainsBorder) {
    const Curve curve = traced(tests::WalledFlow{}, {0.0, 0.9, 0.0}, 5.0, {.longest_step = 0.3});
    EXPECT_EQ(curve.end, CurveEnd::Domain);
    EXPECT_NEAR(curve.last.position.x, 1.0, 1e-12);
    EXPECT_NEAR(curve.last.time, 0.5, 1e-12);
}

TEST(AdvanceCurve, EndsAtAnObstacleItWouldStepAcross) {
    const Curve curve = traced(tests::WalledFlow{}, {0.0, 0.0, 0.0}, 5.0, {.longest_step = 0.9});
    EXPECT_EQ(curve.end, CurveEnd::Obstacle);
    EXPECT_NEAR(curve.last.position.x, 0.25, 1e-12);
}

TEST(AdvanceCurve, ASeedInsideAnObstacleOrOutsideGoesNowhere) {
    EXPECT_EQ(traced(tests::WalledFlow{}, {0.5, 0, 0}, 5.0, {.longest_step = 0.3}).end,
              CurveEnd::Obstacle);
    EXPECT_EQ(traced(tests::WalledFlow{}, {1.5, 0, 0}, 5.0, {.longest_step = 0.3}).end,
              CurveEnd::Domain);
}

TEST(AdvanceCurve, StandingStillEndsTheCurve) {
    const Curve curve = traced(Unbounded<StagnationFlow>{{1.0}}, {0, 0, 1}, 100.0,
                               {.frozen = true, .longest_step = 0.1, .stagnation_speed = 1e-3});
    EXPECT_EQ(curve.end, CurveEnd::Stagnation);
    EXPECT_NEAR(curve.last.position.z, 0.5e-3, 2e-4);
}

TEST(AdvanceCurve, AStopRequestEndsTheWork) {
    std::stop_source stop;
    stop.request_stop();
    Curve curve;
    curve.seed = Vec3(1, 0, 0.5);
    curve.duration = 1e9;
    const Unbounded<AbcFlow> field{abc};
    const TraceOptions options{.longest_step = 0.1};
    EXPECT_FALSE(advance_curve(RungeKuttaSteps(field, options, +1.0), curve, options, 1e9,
                               stop.get_token()));
}

TEST(AdvanceCurve, TheTransportedTangentIsTheDerivativeBySeed) {
    const Unbounded<StrainFlow> strain{{0.5, -0.5, 0.0}};
    Curve curve;
    curve.seed = Vec3(1, 1, 0);
    curve.seed_tangent = Vec3(1, 1, 0);
    curve.duration = 2.0;
    const TraceOptions options{.tolerance = 1e-8, .longest_step = 0.05, .stretch = true};
    EXPECT_TRUE(advance_curve(RungeKuttaSteps(strain, options, +1.0), curve, options, 2.0, {}));
    EXPECT_NEAR(curve.last.stretch.x, std::exp(1.0), 1e-7);
    EXPECT_NEAR(curve.last.stretch.y, std::exp(-1.0), 1e-7);
    for (double time = 0.0; time < 2.0; time += 0.013) // within the steps too
        EXPECT_NEAR(curve.at_time(time).stretch.x, std::exp(0.5 * time), 1e-7);
}

} // namespace wakesurf::core::advance_curve_test
