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

std::vector<glm::dmat3>
gradients(const Flow& flow, const std::vector<Vec3>& points, double step, double time = 0.7) {
    const std::vector<double> times(points.size(), time);
    auto out = velocity_gradients(flow, points, times, step, {});
    EXPECT_TRUE(out);
    return out ? *out : std::vector<glm::dmat3>{};
}

glm::dmat3 gradient(const char* name, const Vec3& point, double step = 1e-3) {
    return gradients(**make_analytic_flow(name), {point}, step).front();
}

} // namespace

TEST(VelocityGradient, OfLinearFlowsIsTheirMatrix) {
    const glm::dmat3 turning = gradient("rotation?omega=1.5", {0.2, -0.3, 0.1});
    EXPECT_NEAR(turning[0].y, 1.5, 1e-9);  // dv/dx
    EXPECT_NEAR(turning[1].x, -1.5, 1e-9); // du/dy
    EXPECT_NEAR(vorticity(turning), 3.0, 1e-9);
    EXPECT_NEAR(q_criterion(turning), 1.5 * 1.5, 1e-9);
    const glm::dmat3 shear = gradient("shear?g=0.8", {0.2, 0.1, 0.1});
    EXPECT_NEAR(vorticity(shear), 0.8, 1e-9);
    EXPECT_NEAR(q_criterion(shear), 0.0, 1e-9);
    const glm::dmat3 strain = gradient("strain?a=0.5,b=-0.3,c=-0.2", {0.2, 0.1, 0.1});
    EXPECT_NEAR(vorticity(strain), 0.0, 1e-9);
    EXPECT_NEAR(q_criterion(strain), -0.5 * (0.25 + 0.09 + 0.04), 1e-9);
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
        const auto all = gradients(*flow, points, step);
        for (std::size_t i = 0; i < points.size(); ++i)
            worst = std::max(worst, std::abs(vorticity(all[i]) - glm::length(velocity[i])));
        return worst;
    };
    const double order = std::log2(error(0.08) / error(0.04));
    EXPECT_NEAR(order, 2.0, 0.1);
}

TEST(VelocityGradient, TellsTheCoreOfAVortexFromTheStrainRoundIt) {
    const auto flow = *make_analytic_flow("lamb-oseen?rc=0.3");
    EXPECT_GT(q_criterion(gradients(*flow, {{0.05, 0.05, 0.0}}, 1e-3).front()), 0.1);
    EXPECT_LT(q_criterion(gradients(*flow, {{0.9, 0.0, 0.0}}, 1e-3).front()), -0.1);
}

TEST(VelocityGradient, IsOneSidedAtWallsAndTheEndOfTheDomainAndNowhereElse) {
    const auto sphere = *make_analytic_flow("sphere?a=0.5");
    const double step = 0.02;
    // Past the equator: from the wall outwards, as finely as the step allows, it is what it is a little further out.
    const Vec3 at_wall{0.0, 0.505, 0.0};
    const double near = gradients(*sphere, {at_wall}, step).front()[1].x;
    const double central =
        gradients(*sphere, {at_wall + Vec3(0, step / 2, 0)}, step / 2).front()[1].x;
    EXPECT_NEAR(near, central, 1e-9);
    const auto corner = gradients(*sphere, {sphere->domain().hi}, step).front();
    EXPECT_TRUE(finite(corner[0]) && finite(corner[1]) && finite(corner[2]));
    EXPECT_FALSE(finite(gradients(*sphere, {Vec3(0.1)}, step).front()[0])) << "in the body";
}

// As between two plates, or of data that have no depth.
TEST(VelocityGradient, TakesShorterStepsWhereTheFlowIsThinnerThanTheStep) {
    const auto flow = *make_analytic_flow("shear?g=0.8");
    const double width = glm::length(flow->domain().extent());
    const auto gradient = gradients(*flow, points_in(*flow, 20), 4.0 * width);
    for (const glm::dmat3& each : gradient)
        EXPECT_NEAR(vorticity(each), 0.8, 1e-9);
}

TEST(VelocityGradient, FieldsAreThoseOfTheGradientsTogetherOrAlone) {
    const auto flow = *make_analytic_flow("lamb-oseen");
    const std::vector<Vec3> points = points_in(*flow, 40);
    const std::vector<double> times(points.size(), 0.0);
    constexpr std::array both{GradientField::QCriterion, GradientField::Vorticity};
    const auto together = sample_gradient_fields(both, *flow, points, times, {});
    const auto alone = sample_gradient_fields({both.data() + 1, 1}, *flow, points, times, {});
    const auto all = gradients(*flow, points, flow->finest_spacing(), 0.0);
    ASSERT_TRUE(together && alone);
    EXPECT_EQ((*together)[1], (*alone)[0]);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_FLOAT_EQ((*together)[0][i], static_cast<float>(q_criterion(all[i])));
        EXPECT_FLOAT_EQ((*together)[1][i], static_cast<float>(vorticity(all[i])));
    }
}

TEST(VelocityGradient, OfAPointDoesNotDependOnTheOthersAndTheirTimes) {
    const auto flow = *make_analytic_flow("double-gyre");
    const std::vector<Vec3> points = points_in(*flow, 60);
    std::vector<double> times;
    for (std::size_t i = 0; i < points.size(); ++i)
        times.push_back(static_cast<double>(i * 7 % 11));
    const auto together = velocity_gradients(*flow, points, times, 0.01, {});
    ASSERT_TRUE(together);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ((*together)[i], gradients(*flow, {points[i]}, 0.01, times[i]).front()) << i;
}

TEST(VelocityGradient, StopsWhenToldTo) {
    std::stop_source stop;
    stop.request_stop();
    const auto flow = *make_analytic_flow("shear");
    const std::vector<Vec3> points(3, Vec3(0.1));
    const std::vector<double> times(3, 0.0);
    const auto out = velocity_gradients(*flow, points, times, 0.1, stop.get_token());
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::velocity_gradient_test
