#include "core/field/advance_particles.hpp"
#include "core/field/analytic_flow.hpp"
#include "tests/support/walled_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace wakesurf::core::advance_particle_test {

namespace {

using Method = AdvanceOptions::Method;

struct Swarm {
    std::vector<Vec3> position;
    std::vector<double> time;
    std::vector<Vec3> along_s{}, along_t{};
    std::vector<CurveEnd> end = std::vector<CurveEnd>(position.size(), CurveEnd::Running);

    Particles particles() { return {position, along_s, along_t, time, end}; }
};

std::unique_ptr<Flow> flow(const char* specification) {
    auto made = make_analytic_flow(specification);
    EXPECT_TRUE(made) << specification;
    return std::move(*made);
}

void carry(const Flow& through, Swarm& swarm, double to, const AdvanceOptions& options) {
    ASSERT_TRUE(through.advance(swarm.particles(), to, options, {}));
}

AdvanceOptions rk4(double step) {
    return {.method = Method::Rk4, .step = step};
}

AdvanceOptions dopri5(double tolerance) {
    return {.method = Method::Dopri5, .tolerance = tolerance, .longest_step = 1.0};
}

const std::vector<Vec3> seeds{
    {0.3, 0.1, 0.2}, {-1.1, 0.4, 2.0}, {2.5, -0.7, -0.9}, {0.9, 1.0, 1.4}};

/// ABC with C = 0: H = B sin x + A cos z is constant along a path, so y = y0 + H t. Largest distance from that at t = 6.
double abc_error(const AdvanceOptions& options) {
    constexpr double a = 1.7320508075688772;
    constexpr double b = 1.4142135623730951;
    const auto abc = flow("abc?A=1.7320508075688772,B=1.4142135623730951,C=0");
    Swarm swarm{seeds, std::vector<double>(seeds.size(), 0.0)};
    carry(*abc, swarm, 6.0, options);
    double most = 0.0;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const double h = b * std::sin(seeds[i].x) + a * std::cos(seeds[i].z);
        EXPECT_EQ(swarm.end[i], CurveEnd::Running);
        EXPECT_EQ(swarm.time[i], 6.0);
        most = std::max(most, std::abs(swarm.position[i].y - (seeds[i].y + 6.0 * h)));
    }
    return most;
}

} // namespace

TEST(AdvanceParticle, Rk4IsOfFourthOrderInTheStep) {
    double coarse = abc_error(rk4(0.2));
    for (const double step : {0.1, 0.05, 0.025}) {
        const double fine = abc_error(rk4(step));
        EXPECT_GT(std::log2(coarse / fine), 3.7) << step;
        coarse = fine;
    }
}

TEST(AdvanceParticle, Dopri5FollowsItsTolerance) {
    double before = 1.0;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const double error = abc_error(dopri5(tolerance));
        EXPECT_LT(error, 20.0 * tolerance); // allowed per unit length, over lengths of about 12
        EXPECT_LT(error, 0.1 * before) << tolerance;
        before = error;
    }
}

TEST(AdvanceParticle, GoingBackEndsWhereItBegan) {
    const auto gyre = flow("double-gyre");
    for (const AdvanceOptions& options : {rk4(0.02), dopri5(1e-9)}) {
        Swarm swarm{{{0.4, 0.3, 0.0}, {1.2, 0.7, 0.1}}, {0.0, 0.0}};
        const auto before = swarm.position;
        carry(*gyre, swarm, 4.0, options);
        EXPECT_GT(glm::length(swarm.position[0] - before[0]), 0.1);
        carry(*gyre, swarm, 0.0, options);
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_LT(glm::length(swarm.position[i] - before[i]), 1e-7);
    }
}

TEST(AdvanceParticle, TangentsAreTheDerivativesOfTheFlowMap) {
    constexpr double h = 1e-4; // central differences of the map: an error of about h squared
    const Vec3 along_s(0.6, -0.3, 0.2);
    const Vec3 along_t(0.1, 0.5, -0.7);
    for (const char* specification : {"abc?C=0.5", "rotating-strain", "lamb-oseen"})
        for (const AdvanceOptions& options : {rk4(0.02), dopri5(1e-10)}) {
            const auto through = flow(specification);
            const Vec3 seed(0.9, 0.4, -0.2);
            Swarm centre{{seed}, {0.5}, {along_s}, {along_t}};
            carry(*through, centre, 2.5, options);
            Swarm beside{
                {seed + h * along_s, seed - h * along_s, seed + h * along_t, seed - h * along_t},
                std::vector<double>(4, 0.5)};
            carry(*through, beside, 2.5, options);
            const auto difference = [&](std::size_t i) {
                return (beside.position[i] - beside.position[i + 1]) / (2.0 * h);
            };
            EXPECT_LT(glm::length(centre.along_s[0] - difference(0)), 1e-5) << specification;
            EXPECT_LT(glm::length(centre.along_t[0] - difference(2)), 1e-5) << specification;
            EXPECT_GT(glm::length(centre.along_s[0] - along_s), 0.1) << specification;
        }
}

TEST(AdvanceParticle, TangentsOfAStrainGrowExponentially) {
    const auto strain = flow("strain?a=0.5,b=-0.5");
    Swarm swarm{{{1.0, 1.0, 0.0}}, {0.0}, {{1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}};
    carry(*strain, swarm, 2.0, rk4(0.05));
    EXPECT_NEAR(swarm.along_s[0].x, std::exp(1.0), 1e-6);
    EXPECT_NEAR(swarm.along_t[0].y, std::exp(-1.0), 1e-6);
}

TEST(AdvanceParticle, TangentsDoNotChangeTheWay) {
    const auto abc = flow("abc");
    for (const AdvanceOptions& options : {rk4(0.1), dopri5(1e-6)}) {
        Swarm with{seeds, std::vector<double>(4, 0.0), std::vector<Vec3>(4, Vec3(1.0)),
                   std::vector<Vec3>(4, Vec3(2.0))};
        Swarm without{seeds, std::vector<double>(4, 0.0)};
        carry(*abc, with, 3.0, options);
        carry(*abc, without, 3.0, options);
        EXPECT_EQ(with.position, without.position);
    }
}

TEST(AdvanceParticle, EachStartsAtItsOwnTime) {
    // x = x0 + u (t - t0), y = y0 + a / omega (cos omega t0 - cos omega t)
    const auto oscillating = flow("oscillating?u=1,a=1,omega=2");
    for (const AdvanceOptions& options : {rk4(0.01), dopri5(1e-10)}) {
        const std::vector<double> starts{0.0, 0.3, 1.7, 2.0};
        Swarm swarm{std::vector<Vec3>(4, Vec3(0.0)), starts};
        swarm.end[1] = CurveEnd::Time; // attached to the rake: stays
        carry(*oscillating, swarm, 2.0, options);
        for (const std::size_t i : {0u, 2u}) {
            EXPECT_EQ(swarm.time[i], 2.0);
            EXPECT_NEAR(swarm.position[i].x, 2.0 - starts[i], 1e-12);
            EXPECT_NEAR(swarm.position[i].y, 0.5 * (std::cos(2.0 * starts[i]) - std::cos(4.0)),
                        1e-9);
        }
        EXPECT_EQ(swarm.position[1], Vec3(0.0));
        EXPECT_EQ(swarm.time[1], starts[1]);
        EXPECT_EQ(swarm.position[3], Vec3(0.0));
    }
}

TEST(AdvanceParticle, OneThatLeavesStaysWhereAndWhenItLeft) {
    const auto uniform = flow("uniform?u=2"); // in a box to x = 10
    for (const AdvanceOptions& options : {rk4(0.3), dopri5(1e-6)}) {
        Swarm swarm{{{9.0, 0.5, 0.0}, {0.0, 0.5, 0.0}, {11.0, 0.0, 0.0}},
                    {1.0, 1.0, 1.0},
                    std::vector<Vec3>(3, Vec3(1.0)),
                    std::vector<Vec3>(3, Vec3(2.0))};
        carry(*uniform, swarm, 3.0, options);
        EXPECT_EQ(swarm.end[0], CurveEnd::Domain);
        EXPECT_NEAR(swarm.position[0].x, 10.0, 1e-10);
        EXPECT_LE(swarm.position[0].x, 10.0);
        EXPECT_NEAR(swarm.time[0], 1.5, 1e-10);
        EXPECT_NEAR(glm::length(swarm.along_s[0] - Vec3(1.0)), 0.0, 1e-12);
        EXPECT_EQ(swarm.end[1], CurveEnd::Running);
        EXPECT_NEAR(swarm.position[1].x, 4.0, 1e-12);
        EXPECT_EQ(swarm.end[2], CurveEnd::Domain);
        EXPECT_EQ(swarm.position[2].x, 11.0);

        const Vec3 left = swarm.position[0];
        const double when = swarm.time[0];
        carry(*uniform, swarm, 5.0, options);
        EXPECT_EQ(swarm.position[0], left);
        EXPECT_EQ(swarm.time[0], when);
        EXPECT_NEAR(swarm.position[1].x, 8.0, 1e-12);
    }
}

TEST(AdvanceParticle, OneThatTurnsOutOfTheDomainLeavesNoFurtherInsideThanItsStepIsRound) {
    const auto rotation = flow("rotation?omega=1,w=0");
    const double radius = std::sqrt(117.0); // meets y = 10 at x = sqrt(17)
    const double when = std::atan2(10.0, std::sqrt(17.0)) - std::atan2(6.0, 9.0);
    for (const double step : {0.05, 0.025, 0.0125}) {
        const double sagitta =
            radius * step * step / 8.0; // it is put on the chord of its last step
        Swarm swarm{{{9.0, 6.0, 0.0}}, {0.0}};
        carry(*rotation, swarm, 3.0, rk4(step));
        EXPECT_EQ(swarm.end[0], CurveEnd::Domain);
        EXPECT_LE(swarm.position[0].y, 10.0);
        EXPECT_GT(swarm.position[0].y, 10.0 - sagitta);
        EXPECT_NEAR(swarm.time[0], when, step * step * step);
    }
}

TEST(AdvanceParticle, OneThatMeetsAnObstacleStopsAtItsWall) {
    for (const AdvanceOptions& options : {rk4(0.1), dopri5(1e-6)}) {
        ParticleState at{{Vec3(0.0), Vec3(0.0), Vec3(0.0)}, 0.0, CurveEnd::Running};
        advance_particle(tests::WalledFlow{}, at, 5.0, options, false);
        EXPECT_EQ(at.end, CurveEnd::Obstacle);
        EXPECT_NEAR(at.carried.position.x, 0.25, 1e-11);
        EXPECT_NEAR(at.time, 0.125, 1e-11);
    }
}

TEST(AdvanceParticle, OneThatStandsStillSaysSo) {
    const auto stagnation = flow("stagnation"); // z -> 0 as e^-2t on the axis
    for (AdvanceOptions options : {rk4(0.01), dopri5(1e-6)}) {
        options.stagnation_speed = 1e-3;
        Swarm swarm{{{0.0, 0.0, 1.0}}, {0.0}};
        carry(*stagnation, swarm, 100.0, options);
        EXPECT_EQ(swarm.end[0], CurveEnd::Stagnation);
        EXPECT_LT(swarm.position[0].z, 0.5e-3);
        EXPECT_LT(swarm.time[0], 100.0);
    }
}

TEST(AdvanceParticle, AStopRequestIsHeard) {
    std::stop_source stop;
    stop.request_stop();
    Swarm swarm{{{0.0, 0.0, 0.0}}, {0.0}};
    const auto stopped = flow("abc")->advance(swarm.particles(), 1.0, rk4(0.1), stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::advance_particle_test
