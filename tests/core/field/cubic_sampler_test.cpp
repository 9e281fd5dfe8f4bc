#include "core/field/closed_forms.hpp"
#include "core/field/cubic_sampler.hpp"
#include "core/field/stored_flow.hpp"
#include "core/integrate/runge_kutta.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>

namespace wakesurf::core::cubic_sampler_test {

using tests::SampledSource;

namespace {

constexpr double pi = std::numbers::pi;

const UniformGrid& grid_of(const TimeStepSource& source) {
    return std::get<UniformGrid>(source.grid());
}

/// A sampler over the interval `k` of a source, with what it reads.
struct Stored {
    Stored(const UniformGrid& grid,
           std::vector<double> series,
           SampledSource::Velocity velocity,
           std::size_t k = 0,
           SolidMask mask = {})
        : source(grid, std::move(series), std::move(velocity), std::move(mask)),
          cells(grid_of(source).dimensions, source.mask()) {
        const std::vector<double>& times = source.times();
        for (std::size_t i = k - std::min<std::size_t>(k, 1); i < std::min(k + 3, times.size());
             ++i)
            steps.push_back(source.load(i, {}).value());
        const auto find = [&](std::size_t i) -> const float* {
            for (const auto& step : steps)
                if (step->index == i)
                    return step->velocity().data();
            return nullptr;
        };
        sampler.linear.grid = &grid_of(source);
        sampler.linear.cells = &cells;
        sampler.linear.mask = &source.mask();
        sampler.linear.velocity0 = find(k);
        sampler.linear.velocity1 = find(k + 1);
        sampler.linear.time0 = times[k];
        sampler.linear.interval = k + 1 < times.size() ? times[k + 1] - times[k] : 1.0;
        sampler.before = k > 0 ? find(k - 1) : nullptr;
        sampler.time_before = k > 0 ? times[k - 1] : 0.0;
        sampler.after = find(k + 2);
        sampler.time_after = k + 2 < times.size() ? times[k + 2] : 0.0;
    }

    SampledSource source;
    CellMask cells;
    std::vector<std::shared_ptr<const TimeStep>> steps;
    CubicSampler sampler;
};

Vec3 random_point(const Box& box, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    return box.lo + box.extent() * Vec3(unit(random), unit(random), unit(random));
}

std::unique_ptr<Flow> flow_of(std::shared_ptr<SampledSource> source, std::size_t budget) {
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{budget}));
}

std::vector<double> even_times(double to, int intervals) {
    std::vector<double> times;
    for (int i = 0; i <= intervals; ++i)
        times.push_back(to * i / intervals);
    return times;
}

/// Where particles get to by RK4 steps short enough not to matter.
std::vector<Vec3>
carried(const Flow& flow, std::vector<Vec3> position, double to, double step, bool smooth) {
    std::vector<double> time(position.size(), 0.0);
    std::vector<CurveEnd> end(position.size(), CurveEnd::Running);
    AdvanceOptions options{.step = step, .smooth = smooth};
    EXPECT_TRUE(flow.advance({position, {}, {}, time, end}, to, options, {}));
    for (const CurveEnd e : end)
        EXPECT_EQ(e, CurveEnd::Running);
    return position;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, glm::length(a[i] - b[i]));
    return most;
}

} // namespace

TEST(CubicSampler, ReproducesFieldsQuadraticInTimeWhateverTheTimesAndAtTheEndsOfTheSeries) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.5), {4, 4, 4}};
    const std::vector<double> times{0.0, 0.5, 2.0, 2.25};
    const auto field = [](const Vec3& p, double t) {
        return Vec3(1.0 - 2.0 * t + 3.0 * t * t, t * t, p.x * t);
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const Stored stored(grid, times, field, k);
        for (double u = 0.0; u <= 1.0; u += 0.125) {
            const double t = times[k] + u * (times[k + 1] - times[k]);
            const Vec3 p(0.7, 0.2, 1.1);
            EXPECT_LT(glm::length(stored.sampler.velocity(p, t) - field(p, t)), 2e-6)
                << k << " " << t;
        }
    }
}

TEST(CubicSampler, IsLinearInTimeWhereThereAreOnlyTwoTimeSteps) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.5), {4, 4, 4}};
    const Stored stored(grid, {0.0, 2.0},
                        [](const Vec3&, double t) { return Vec3(t, 1.0, t * t); });
    EXPECT_LT(glm::length(stored.sampler.velocity(Vec3(0.7), 0.5) - Vec3(0.5, 1.0, 1.0)), 1e-12);
}

TEST(CubicSampler, ReproducesFieldsQuadraticInSpaceInsideAndLinearOnesUpToTheBorder) {
    const UniformGrid grid{Vec3(-1.0), Vec3(0.25, 0.5, 0.125), {9, 5, 9}};
    const auto bent = [](const Vec3& p, double) {
        return Vec3(p.x * p.x + p.y * p.z, 1.0 - p.z * p.z, p.y * p.y * p.x);
    };
    const auto straight = [](const Vec3& p, double) {
        return Vec3(p.x + 2.0 * p.y, 1.0 - p.z, p.x * p.z);
    };
    const Stored inside(grid, {0.0}, bent);
    const Stored border(grid, {0.0}, straight);
    std::mt19937 random(5);
    const Box box = grid.bounds();
    for (int i = 0; i < 300; ++i) {
        const Vec3 inner = random_point({box.lo + grid.spacing, box.hi - grid.spacing}, random);
        EXPECT_LT(glm::length(inside.sampler.velocity(inner, 0.0) - bent(inner, 0.0)), 1e-6);
        const Vec3 any = random_point(box, random);
        EXPECT_LT(glm::length(border.sampler.velocity(any, 0.0) - straight(any, 0.0)), 1e-6);
    }
    EXPECT_LT(glm::length(border.sampler.velocity(box.hi, 0.0) - straight(box.hi, 0.0)), 1e-6);
    EXPECT_EQ(border.sampler.velocity(box.hi + 1.0, 0.0), border.sampler.velocity(box.hi, 0.0));
}

TEST(CubicSampler, TheDerivativeIsThatOfTheVelocity) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.3, 0.25, 0.2), {7, 6, 8}};
    const auto field = [](const Vec3& p, double t) {
        return Vec3(std::sin(2.0 * p.x + t), p.y * std::cos(p.z), std::exp(-p.x * p.y) * t);
    };
    const Stored stored(grid, {0.0, 1.0, 1.5, 2.5}, field, 1);
    std::mt19937 random(6);
    const Box box = grid.bounds();
    const double h = 1e-5;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = random_point({box.lo + 2.0 * h, box.hi - 2.0 * h}, random);
        const Vec3 w = random_point({Vec3(-1.0), Vec3(1.0)}, random);
        const Vec3 difference =
            (stored.sampler.velocity(p + h * w, 1.2) - stored.sampler.velocity(p - h * w, 1.2)) /
            (2.0 * h);
        EXPECT_LT(glm::length(stored.sampler.derivative(p, 1.2, w) - difference), 1e-4);
    }
}

TEST(CubicSampler, IsTrilinearInCellsWhoseNeighboursTouchAnObstacle) {
    const UniformGrid grid{Vec3(0.0), Vec3(1.0), {12, 12, 12}};
    SolidMask mask;
    mask.fluid.assign(grid.nodes(), 1);
    mask.fluid[(6 * 12 + 6) * 12 + 6] = 0;
    const Stored stored(
        grid, {0.0}, [](const Vec3& p, double) { return Vec3(std::sin(p.x), p.y * p.y, p.z); }, 0,
        mask);
    std::mt19937 random(8);
    int beside = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 p = random_point({Vec3(1.0), Vec3(10.0)}, random);
        const Vec3 cell = glm::floor(p);
        // The stencil of a cell reaches from one node before it to two after its lowest.
        const bool touches =
            cell.x >= 4 && cell.x <= 7 && cell.y >= 4 && cell.y <= 7 && cell.z >= 4 && cell.z <= 7;
        const double apart =
            glm::length(stored.sampler.velocity(p, 0.0) - stored.sampler.linear.velocity(p, 0.0));
        const Vec3 w(1.0, -2.0, 0.5);
        const double derivatives_apart = glm::length(stored.sampler.derivative(p, 0.0, w) -
                                                     stored.sampler.linear.derivative(p, 0.0, w));
        if (touches) {
            EXPECT_LT(apart, 1e-12);
            EXPECT_LT(derivatives_apart, 1e-11);
            ++beside;
        } else
            EXPECT_GT(apart + derivatives_apart, 1e-6);
    }
    EXPECT_GT(beside, 100);
}

TEST(SmoothSampling, ErrorsOfPathsFallWithThePower2OfTheSpacingWhenTrilinearAnd3HalfWhenTricubic) {
    // docs/measurements.md, Order of the field's interpolation: slopes 2.0 and 3.5 to 3.6.
    const AbcFlow abc{std::sqrt(3.0), std::sqrt(2.0), 1.0};
    const auto velocity = [&](const Vec3& p, double t) { return abc.velocity(p, t); };
    std::vector<Vec3> seeds;
    std::mt19937 random(4);
    for (int i = 0; i < 40; ++i)
        seeds.push_back(random_point({Vec3(2.5), Vec3(4.0)}, random));
    const double step = 0.01;
    std::vector<Vec3> exact = seeds;
    for (Vec3& p : exact)
        for (int i = 0; i < 50; ++i) {
            const auto slope = [&](const Vec3& y, double t) { return abc.velocity(y, t); };
            p += rk4_change(slope, p, 0.0, step, slope(p, 0.0));
        }
    std::array<std::vector<double>, 2> error;
    for (const std::uint32_t n : {17u, 33u, 65u}) {
        const UniformGrid cube{Vec3(0.0), Vec3(2.0 * pi / (n - 1)), {n, n, n}};
        const auto flow = flow_of(
            std::make_shared<SampledSource>(cube, std::vector{0.0, 1.0}, velocity), 1u << 30);
        for (const bool smooth : {false, true})
            error[smooth].push_back(farthest(carried(*flow, seeds, 0.5, step, smooth), exact));
    }
    const auto slope = [&](bool smooth) {
        return 0.5 * std::log2(error[smooth].front() / error[smooth].back());
    };
    EXPECT_NEAR(slope(false), 2.0, 0.1);
    EXPECT_NEAR(slope(true), 3.5, 0.2);
}

TEST(SmoothSampling, CubicInTimeIsTenTimesBetterThanLinearAtThirtyTwoTimeStepsAPeriod) {
    const DoubleGyreFlow gyre{0.1, 0.25, 10.0, 0.0};
    const UniformGrid sheet{Vec3(0.0), Vec3(1.0 / 32, 1.0 / 32, 1.0), {65, 33, 2}};
    const auto velocity = [&](const Vec3& p, double t) { return gyre.velocity(p, t); };
    std::vector<Vec3> seeds;
    std::mt19937 random(4);
    for (int i = 0; i < 20; ++i)
        seeds.push_back(random_point({Vec3(0.3, 0.2, 0.1), Vec3(1.7, 0.8, 0.9)}, random));
    // The truth has the same spatial error: what differs is due to time.
    const auto after_15 = [&](int steps_per_period, bool smooth) {
        const auto flow = flow_of(std::make_shared<SampledSource>(
                                      sheet, even_times(15.0, steps_per_period * 3 / 2), velocity),
                                  1u << 30);
        return carried(*flow, seeds, 15.0, 0.04, smooth);
    };
    std::array<std::vector<double>, 2> error;
    for (const bool smooth : {false, true}) {
        const std::vector<Vec3> truth = after_15(512, smooth);
        for (const int steps : {16, 32, 64})
            error[smooth].push_back(farthest(after_15(steps, smooth), truth));
    }
    EXPECT_GT(error[0][1], 10.0 * error[1][1]);
    EXPECT_GT(error[0][2], 10.0 * error[1][2]);
    EXPECT_GT(std::log2(error[1][0] / error[1][1]), 3.0);
}

TEST(SmoothSampling, SamplesCurvesAndParticlesSeeTheSameField) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.25), {17, 17, 17}};
    const auto turning = [](const Vec3& p, double t) {
        return Vec3(2.0 - p.y, p.x - 2.0, 0.3 * std::sin(3.0 * t));
    };
    const auto source = std::make_shared<SampledSource>(grid, even_times(2.0, 8), turning);
    const auto flow = flow_of(source, 4 * source->bytes_per_step());
    std::vector<Curve> curves(1);
    curves[0].seed = Vec3(3.0, 2.0, 1.0);
    curves[0].duration = 2.0;
    ASSERT_TRUE(flow->trace(curves, {.tolerance = 1e-10, .longest_step = 0.2, .smooth = true}, {}));
    const Vec3 there = carried(*flow, {curves[0].seed}, 2.0, 0.005, true)[0];
    EXPECT_LT(glm::length(there - curves[0].last.position), 1e-7);
    const Vec3 linear = carried(*flow, {curves[0].seed}, 2.0, 0.005, false)[0];
    EXPECT_GT(glm::length(there - linear), 1e-4);

    const double t = 0.3;
    Vec3 smooth, plain;
    ASSERT_TRUE(flow->sample({&there, 1}, {&t, 1}, {&smooth, 1}, {}, true));
    ASSERT_TRUE(flow->sample({&there, 1}, {&t, 1}, {&plain, 1}, {}));
    EXPECT_LT(std::abs(smooth.z - turning(there, t).z),
              0.2 * std::abs(plain.z - turning(there, t).z));
}

TEST(SmoothSampling, CallersWhoShareTheSmallestCacheAllArrive) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.25), {9, 9, 9}};
    const auto source = std::make_shared<SampledSource>(
        grid, even_times(2.0, 30), [](const Vec3&, double t) { return Vec3(0.1, 0.1 * t, 0.0); });
    const auto flow = flow_of(source, 0);
    std::vector<std::jthread> callers;
    for (int i = 0; i < 3; ++i)
        callers.emplace_back([&, smooth = i != 1] {
            const Vec3 there = carried(*flow, {Vec3(1.0)}, 2.0, 0.05, smooth)[0];
            EXPECT_NEAR(there.y, 1.2, 1e-6);
        });
}

} // namespace wakesurf::core::cubic_sampler_test
