#include "core/field/grid_sampler.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wakesurf::core::stored_flow_test {

using tests::SampledSource;

namespace {

const UniformGrid grid{Vec3(-1.0, 0.0, 2.0), Vec3(0.25, 0.5, 0.125), {9, 5, 9}};

/// Trilinear in space and linear in time: the grid must give it back exactly.
Vec3 trilinear(const Vec3& p, double t) {
    return {1.0 + p.x * p.y * p.z, t * p.x - p.z, 2.0 * t + p.y * p.z};
}

std::unique_ptr<Flow> stored(std::shared_ptr<SampledSource> source) {
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}));
}

Vec3 velocity_at(const Flow& flow, Vec3 p, double t) {
    Vec3 v;
    EXPECT_TRUE(flow.sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
    return v;
}

} // namespace

TEST(StoredFlow, ReproducesFieldsTrilinearInSpaceAndLinearInTime) {
    const auto flow =
        stored(std::make_shared<SampledSource>(grid, std::vector{0.0, 0.5, 2.0}, trilinear));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Box box = flow->domain();
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = box.lo + box.extent() * Vec3(unit(random), unit(random), unit(random));
        const double t = 2.0 * unit(random);
        EXPECT_LT(glm::length(velocity_at(*flow, p, t) - trilinear(p, t)), 2e-6);
    }
    EXPECT_LT(glm::length(velocity_at(*flow, box.hi, 2.0) - trilinear(box.hi, 2.0)), 2e-6);
}

TEST(StoredFlow, HalvingTheSpacingDividesTheInterpolationErrorByFour) {
    const auto bent = [](const Vec3& p, double) {
        return Vec3(std::sin(2 * p.x), std::cos(p.y + p.z), p.x * p.x);
    };
    std::vector<double> errors;
    for (const std::uint32_t n : {9u, 17u, 33u}) {
        const UniformGrid cube{Vec3(0.0), Vec3(2.0 / (n - 1)), {n, n, n}};
        const auto flow = stored(std::make_shared<SampledSource>(cube, std::vector{0.0}, bent));
        double worst = 0.0;
        for (double x = 0.01; x < 2.0; x += 0.0317)
            worst =
                std::max(worst, glm::length(velocity_at(*flow, {x, 0.7 * x, 1.9 - 0.8 * x}, 0.0) -
                                            bent({x, 0.7 * x, 1.9 - 0.8 * x}, 0.0)));
        errors.push_back(worst);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 1.7);
}

TEST(StoredFlow, AWallLiesMidwayBetweenAFluidAndASolidNode) {
    SolidMask mask;
    mask.fluid.assign(grid.nodes(), 1);
    mask.fluid[(4 * 5 + 2) * 9 + 4] = 0; // node (4, 2, 4) at (0, 1, 2.5)
    const auto flow =
        stored(std::make_shared<SampledSource>(grid, std::vector{0.0}, trilinear, mask));
    EXPECT_EQ(flow->status({0.0, 1.0, 2.5}), PointStatus::InObstacle);
    EXPECT_EQ(flow->status({0.12, 1.0, 2.5}), PointStatus::InObstacle);
    EXPECT_EQ(flow->status({0.13, 1.0, 2.5}), PointStatus::Inside);
    EXPECT_EQ(flow->status({0.0, 1.26, 2.5}), PointStatus::Inside);
    EXPECT_EQ(flow->status({0.0, 1.24, 2.5}), PointStatus::InObstacle);
    EXPECT_EQ(flow->status({-1.01, 1.0, 2.5}), PointStatus::OutsideDomain);
}

TEST(StoredFlow, PathlinesThroughStoredTimeStepsMatchTheField) {
    // dx/dt = t on stored times: linear interpolation is exact, so the pathline is t^2 / 2 to rounding.
    const UniformGrid box{Vec3(-10.0), Vec3(2.0), {11, 11, 11}};
    const auto source =
        std::make_shared<SampledSource>(box, std::vector{0.0, 1.0, 1.5, 4.0},
                                        [](const Vec3&, double t) { return Vec3(t, 0.5, 0); });
    const auto flow = stored(source);
    std::vector<Curve> curves(5);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        curves[i].seed = Vec3(-5.0, -1.0, static_cast<double>(i));
        curves[i].release = 0.25;
        curves[i].duration = 3.5;
    }
    ASSERT_TRUE(flow->trace(curves, {.tolerance = 1e-9, .longest_step = 2.0}, {}));
    for (const Curve& curve : curves) {
        EXPECT_EQ(curve.end, CurveEnd::Time);
        EXPECT_NEAR(curve.last.position.x, -5.0 + 0.5 * (3.75 * 3.75 - 0.25 * 0.25), 1e-6);
        for (const CurveStep& step : curve.steps)
            for (const double stored_time : source->times())
                EXPECT_FALSE(step.time + 0.25 < stored_time - 1e-9 &&
                             step.time + 0.25 + step.dt > stored_time + 1e-9)
                    << "a step straddles time " << stored_time;
    }
    std::vector<Curve> back(1);
    back[0].seed = curves[0].last.position;
    back[0].release = 3.75;
    back[0].duration = -3.5;
    ASSERT_TRUE(flow->trace(back, {.tolerance = 1e-9, .longest_step = 2.0}, {}));
    EXPECT_LT(glm::length(back[0].last.position - curves[0].seed), 1e-6);
}

TEST(StoredFlow, AFrozenFieldLoadsOnlyTheTimeStepItNeeds) {
    const auto source =
        std::make_shared<SampledSource>(grid, std::vector{0.0, 1.0, 2.0, 3.0}, trilinear);
    const auto flow = stored(source);
    std::vector<Curve> curves(1);
    curves[0].seed = Vec3(-0.9, 1.0, 2.5);
    curves[0].release = 2.0;
    curves[0].duration = 0.1;
    ASSERT_TRUE(flow->trace(curves, {.frozen = true, .longest_step = 0.1}, {}));
    EXPECT_EQ(source->loads, 1);
}

} // namespace wakesurf::core::stored_flow_test
