#include "core/field/analytic_flow.hpp"
#include "core/field/velocity_gradient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace wakesurf::core::velocity_gradient_test {

namespace {

std::vector<Vec3> points_in(const Flow& flow, std::size_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.05, 0.95);
    std::vector<Vec3> points;
    while (points.size() < count) {
        const Vec3 p = flow.domain().lo +
                       flow.domain().extent() * Vec3(unit(random), unit(random), unit(random));
        if (flow.status(p) == PointStatus::Inside)
            points.push_back(p);
    }
    return points;
}

/// A flow whose finest detail is of another size: the step of the differences.
class WithDetail : public Flow {
  public:
    WithDetail(const Flow& flow, double step) : flow_(flow), step_(step) {}

    Box domain() const override { return flow_.domain(); }

    std::optional<std::array<double, 2>> time_range() const override { return flow_.time_range(); }

    double finest_spacing() const override { return step_; }

    PointStatus status(const Vec3& p) const override { return flow_.status(p); }

    Result<TraceCost> trace(std::span<Curve> curves,
                            const TraceOptions& options,
                            std::stop_token stop) const override {
        return flow_.trace(curves, options, stop);
    }

    Result<TraceCost> advance(const Particles& particles,
                              double to,
                              const AdvanceOptions& options,
                              std::stop_token stop) const override {
        return flow_.advance(particles, to, options, stop);
    }

    bool few_data(double from, double to) const override { return flow_.few_data(from, to); }

    bool obstacle() const override { return flow_.obstacle(); }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double> times,
                        std::span<Vec3> velocities,
                        std::stop_token stop,
                        bool smooth) const override {
        return flow_.sample(positions, times, velocities, stop, smooth);
    }

  private:
    const Flow& flow_;
    double step_;
};

/// Along x, as fast as the square of the height over a wall.
class OverAWall final : public WithDetail {
  public:
    explicit OverAWall(const Flow& around) : WithDetail(around, 1.0) {}

    PointStatus status(const Vec3& p) const override {
        return p.y < 0.0 ? PointStatus::InObstacle : PointStatus::Inside;
    }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double>,
                        std::span<Vec3> velocities,
                        std::stop_token,
                        bool) const override {
        for (std::size_t i = 0; i < positions.size(); ++i)
            velocities[i] = {positions[i].y * positions[i].y, 0.0, 0.0};
        return {};
    }
};

struct Whirls {
    std::vector<float> vorticity, q;
};

constexpr std::array both{GradientField::Vorticity, GradientField::QCriterion};

Whirls whirls(const Flow& flow,
              const std::vector<Vec3>& points,
              double step,
              const std::vector<double>& times) {
    auto out = sample_gradient_fields(both, WithDetail(flow, step), points, times, {});
    EXPECT_TRUE(out);
    return out ? Whirls{(*out)[0], (*out)[1]} : Whirls{};
}

Whirls whirls(const Flow& flow, const std::vector<Vec3>& points, double step, double time = 0.7) {
    return whirls(flow, points, step, std::vector<double>(points.size(), time));
}

void expect_near(const char* name, double vorticity, double q) {
    const Whirls found = whirls(**make_analytic_flow(name), {{0.2, -0.1, 0.1}}, 1e-3);
    EXPECT_NEAR(found.vorticity.front(), vorticity, 1e-6) << name;
    EXPECT_NEAR(found.q.front(), q, 1e-6) << name;
}

} // namespace

TEST(VelocityGradient, OfLinearFlowsIsThatOfTheirMatrix) {
    expect_near("rotation?omega=1.5", 3.0, 1.5 * 1.5);
    expect_near("shear?g=0.8", 0.8, 0.0);
    expect_near("strain?a=0.5,b=-0.3,c=-0.2", 0.0, -0.5 * (0.25 + 0.09 + 0.04));
}

// The ABC flow is its own curl.
TEST(VelocityGradient, ConvergesToTheVorticityWithTheSecondOrderOfTheStep) {
    const auto flow = *make_analytic_flow("abc?A=1,B=0.7,C=0.4");
    const std::vector<Vec3> points = points_in(*flow, 200);
    const std::vector<double> times(points.size(), 0.7);
    std::vector<Vec3> velocity(points.size());
    ASSERT_TRUE(flow->sample(points, times, velocity, {}));
    const auto error = [&](double step) {
        double worst = 0.0;
        const auto all = whirls(*flow, points, step).vorticity;
        for (std::size_t i = 0; i < points.size(); ++i)
            worst = std::max(worst, std::abs(all[i] - glm::length(velocity[i])));
        return worst;
    };
    const double order = std::log2(error(0.08) / error(0.04));
    EXPECT_NEAR(order, 2.0, 0.1);
}

TEST(VelocityGradient, TellsTheCoreOfAVortexFromTheStrainRoundIt) {
    const auto flow = *make_analytic_flow("lamb-oseen?rc=0.3");
    EXPECT_GT(whirls(*flow, {{0.05, 0.05, 0.0}}, 1e-3).q.front(), 0.1);
    EXPECT_LT(whirls(*flow, {{0.9, 0.0, 0.0}}, 1e-3).q.front(), -0.1);
}

TEST(VelocityGradient, IsOneSidedAtWallsAndTheEndOfTheDomainAndNowhereElse) {
    const auto shear = *make_analytic_flow("shear");
    const OverAWall wall(*shear);
    const auto over = whirls(wall, {{0.0, 0.005, 0.0}, {0.0, 0.1, 0.0}}, 0.02).vorticity;
    EXPECT_NEAR(over[0], (0.025 * 0.025 - 0.005 * 0.005) / 0.02, 1e-7);
    EXPECT_NEAR(over[1], 2.0 * 0.1, 1e-7);
    const auto sphere = *make_analytic_flow("sphere?a=0.5");
    const auto ends = whirls(*sphere, {sphere->domain().hi, Vec3(0.1)}, 0.02).q;
    EXPECT_TRUE(std::isfinite(ends[0]));
    EXPECT_TRUE(std::isnan(ends[1])) << "in the body";
}

// As between two plates, or of data that have no depth.
TEST(VelocityGradient, TakesShorterStepsWhereTheFlowIsThinnerThanTheStep) {
    const auto flow = *make_analytic_flow("shear?g=0.8");
    const double width = glm::length(flow->domain().extent());
    for (const float vorticity : whirls(*flow, points_in(*flow, 20), 4.0 * width).vorticity)
        EXPECT_NEAR(vorticity, 0.8, 1e-6);
}

TEST(VelocityGradient, OfOneFieldIsThatOfBoth) {
    const auto flow = *make_analytic_flow("lamb-oseen");
    const std::vector<Vec3> points = points_in(*flow, 40);
    const std::vector<double> times(points.size(), 0.0);
    const auto all = whirls(*flow, points, flow->finest_spacing(), times);
    const auto q = sample_gradient_fields({both.data() + 1, 1}, *flow, points, times, {});
    ASSERT_TRUE(q);
    EXPECT_EQ((*q)[0], all.q);
}

// The ABC flow is its own curl.
TEST(VelocityGradient, HasTheVorticityAsComponentsWithTheirSigns) {
    const auto flow = *make_analytic_flow("abc?A=1,B=0.7,C=0.4");
    const std::vector<Vec3> points = points_in(*flow, 40);
    const std::vector<double> times(points.size(), 0.7);
    std::vector<Vec3> velocity(points.size());
    ASSERT_TRUE(flow->sample(points, times, velocity, {}));
    constexpr std::array components{GradientField::VorticityX, GradientField::VorticityY,
                                    GradientField::VorticityZ};
    const auto found =
        sample_gradient_fields(components, WithDetail(*flow, 1e-3), points, times, {});
    ASSERT_TRUE(found);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(find_gradient_field(gradient_field_names[1 + axis]), components[axis]);
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_NEAR((*found)[axis][i], velocity[i][static_cast<int>(axis)], 1e-5);
    }
}

TEST(VelocityGradient, OfAPointDoesNotDependOnTheOthersAndTheirTimes) {
    const auto flow = *make_analytic_flow("double-gyre");
    const std::vector<Vec3> points = points_in(*flow, 60);
    std::vector<double> times;
    for (std::size_t i = 0; i < points.size(); ++i)
        times.push_back(static_cast<double>(i * 7 % 11));
    const Whirls together = whirls(*flow, points, 0.01, times);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Whirls alone = whirls(*flow, {points[i]}, 0.01, times[i]);
        EXPECT_EQ(together.vorticity[i], alone.vorticity.front()) << i;
        EXPECT_EQ(together.q[i], alone.q.front()) << i;
    }
}

TEST(VelocityGradient, StopsWhenToldTo) {
    std::stop_source stop;
    stop.request_stop();
    const auto flow = *make_analytic_flow("shear");
    const std::vector<Vec3> points(3, Vec3(0.1));
    const std::vector<double> times(3, 0.0);
    const auto out = sample_gradient_fields(both, *flow, points, times, stop.get_token());
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::velocity_gradient_test
