// The field between stored times, cubic and along the flow, on every kind of grid.
#include "core/field/stored_flow.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

namespace wakesurf::core::between_test {

namespace {

using Velocity = tests::SampledSource::Velocity;
constexpr std::array curved{Between::Cubic, Between::Flow};
enum class Shape { Uniform, Rectilinear, Cells };
constexpr std::array shapes{Shape::Uniform, Shape::Rectilinear, Shape::Cells};

Vec3 in_box(const Vec3& part) {
    return Vec3(-2.0, -1.5, -1.0) + Vec3(4.0, 3.0, 2.0) * part;
}

Grid grid_of(Shape shape, std::array<std::uint32_t, 3> cells = {20, 15, 10}) {
    UniformGrid uniform;
    uniform.origin = in_box(Vec3(0.0));
    for (std::size_t i = 0; i < 3; ++i)
        uniform.dimensions[i] = cells[i] + 1;
    uniform.spacing = Vec3(4.0, 3.0, 2.0) / Vec3(cells[0], cells[1], cells[2]);
    if (shape == Shape::Uniform)
        return uniform;
    if (shape == Shape::Cells)
        return tests::block(cells, [](const Vec3& part) { return in_box(part); });
    RectilinearGrid stretched;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i <= cells[axis]; ++i) {
            const double part = i / double(cells[axis]);
            stretched.coordinates[axis].push_back(
                in_box(Vec3(part + 0.03 * std::sin(2.0 * std::numbers::pi * part)))[int(axis)]);
        }
    return stretched;
}

std::shared_ptr<const Flow> flow_over(std::shared_ptr<const TimeStepSource> source) {
    TimeStepCache::Options options;
    options.by_brick = source->bricks() != nullptr;
    return make_stored_flow(std::make_shared<TimeStepCache>(std::move(source), options));
}

std::shared_ptr<const Flow> stored(Shape shape, std::vector<double> times, Velocity velocity) {
    return flow_over(std::make_shared<tests::SampledSource>(grid_of(shape), std::move(times),
                                                            std::move(velocity)));
}

Vec3 velocity_of(const Flow& flow, const Vec3& p, double t) {
    Vec3 v(0.0);
    EXPECT_TRUE(flow.sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
    return v;
}

Vec3 swinging(const Vec3& p, double t) {
    return {0.8 + 0.3 * std::sin(2.0 * p.y - 2.5 * t), 0.4 * std::cos(1.5 * p.x - 1.9 * t),
            0.2 * std::sin(1.3 * t + p.x)};
}

struct Swarm {
    explicit Swarm(std::size_t count)
        : position(count), along_s(count, Vec3(1, 0, 0)), along_t(count, Vec3(0, 1, 0)),
          time(count, 0.1), end(count, CurveEnd::Running) {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> part(0.05, 0.95);
        for (Vec3& p : position) {
            const double x = part(random), y = part(random), z = part(random);
            p = in_box({x, y, z});
        }
    }

    void advance(const Flow& flow, double to, double step = 0.05) {
        ASSERT_TRUE(flow.advance({position, along_s, along_t, time, end}, to, {.step = step}, {}));
    }

    bool same_as(const Swarm& other) const {
        return std::memcmp(position.data(), other.position.data(),
                           position.size() * sizeof(Vec3)) == 0 &&
               std::memcmp(along_s.data(), other.along_s.data(), position.size() * sizeof(Vec3)) ==
                   0 &&
               end == other.end;
    }

    std::vector<Vec3> position, along_s, along_t;
    std::vector<double> time;
    std::vector<CurveEnd> end;
};

} // namespace

TEST(Between, CubicHasQuadraticsInTimeExactlyAtUnevenTimesInTheFirstAndTheLastIntervalToo) {
    const auto quadratic = [](const Vec3& p, double t) {
        return Vec3(1.0 + p.y, 0.3 - p.x, p.z) + t * Vec3(0.5 * p.x, 0.2, -p.y) +
               t * t * Vec3(-0.3, 0.1 * p.z, 0.2 * p.x);
    };
    for (const Shape shape : shapes) {
        const auto flow =
            stored(shape, {0.0, 0.7, 1.9, 2.2, 4.0}, quadratic)->interpolated(Between::Cubic);
        for (const double t : {0.0, 0.2, 0.7, 1.1, 2.0, 2.2, 3.1, 4.0})
            for (const Vec3& p : {Vec3(0.1, 0.2, 0.3), Vec3(-1.7, 1.1, -0.9)})
                EXPECT_LT(glm::length(velocity_of(*flow, p, t) - quadratic(p, t)), 3e-6)
                    << static_cast<int>(shape) << " at " << t;
    }
}

TEST(Between, CubicErrorsFallWithTheThirdPowerOfTheIntervalAndThoseOfWaysWithTheFourth) {
    const auto wave = [](const Vec3&, double t) { return Vec3(std::sin(t + 0.4), 0.0, 0.0); };
    const auto in = [&](int intervals) {
        std::vector<double> times;
        for (int k = 0; k <= intervals; ++k)
            times.push_back(4.0 * k / intervals);
        return stored(Shape::Uniform, times, wave)->interpolated(Between::Cubic);
    };
    const auto off = [&](int intervals, double from, double to) {
        const auto flow = in(intervals);
        double most = 0.0;
        for (double t = from; t <= to; t += 0.005)
            most = std::max(most, std::abs(velocity_of(*flow, Vec3(0.0), t).x - wave({}, t).x));
        return most;
    };
    EXPECT_GT(std::log2(off(8, 1.0, 3.0) / off(16, 1.0, 3.0)), 2.7);
    EXPECT_GT(std::log2(off(8, 0.0, 0.5) / off(16, 0.0, 0.25)), 2.7);
    EXPECT_GT(std::log2(off(8, 3.5, 4.0) / off(16, 3.75, 4.0)), 2.7);
    const auto off_way = [&](int intervals) { // by Simpson's rule, which is exact for cubics
        const auto flow = in(intervals);
        const double h = 4.0 / intervals;
        double way = 0.0;
        for (double t = 1.0; t < 3.0; t += h)
            way += h / 6.0 *
                   (velocity_of(*flow, {}, t).x + 4.0 * velocity_of(*flow, {}, t + 0.5 * h).x +
                    velocity_of(*flow, {}, t + h).x);
        return std::abs(way - (std::cos(1.4) - std::cos(3.4)));
    };
    EXPECT_GT(std::log2(off_way(8) / off_way(16)), 3.7);
}

TEST(Between, FlowHasAPatternThatTheFluidCarriesAsItIsStored) {
    // In an interval the pattern goes two cells on, so that it lies in the cells as before.
    for (const Shape shape : {Shape::Uniform, Shape::Cells}) {
        const auto linear = stored(shape, {0.0, 0.4, 0.8, 1.2, 1.6}, [](const Vec3& p, double t) {
            return Vec3(1.0, 0.05 * std::sin(9.0 * (p.x - t)), 0.0);
        });
        const auto flow = linear->interpolated(Between::Flow);
        for (const double part : {0.1, 0.3, 0.5, 0.8})
            for (double x = -0.6; x < 0.6; x += 0.07) {
                const double t = 0.8 + 0.4 * part;
                const Vec3 carried = velocity_of(*linear, Vec3(x - 0.4 * part, 0.1, 0.2), 0.8);
                EXPECT_LT(glm::length(velocity_of(*flow, Vec3(x, 0.1, 0.2), t) - carried), 2e-7);
            }
        const Vec3 crest(0.2, 0.1, 0.2); // where linear interpolation flattens the pattern
        EXPECT_GT(glm::length(velocity_of(*flow, crest, 1.0) - velocity_of(*linear, crest, 1.0)),
                  0.01);
    }
}

TEST(Between, HasStoredTimesAsStoredAndIsContinuousThere) {
    for (const Shape shape : shapes) {
        const auto linear = stored(shape, {0.0, 0.5, 1.2, 1.6, 2.0}, swinging);
        for (const Between between : curved) {
            const auto flow = linear->interpolated(between);
            for (const double t : {0.0, 0.5, 1.2, 1.6, 2.0}) {
                const Vec3 p(0.31, -0.22, 0.17);
                const Vec3 there = velocity_of(*linear, p, t);
                EXPECT_LT(glm::length(velocity_of(*flow, p, t) - there), 1e-12);
                const std::array beside{std::max(t - 1e-9, 0.0), std::min(t + 1e-9, 2.0)};
                for (const double near : beside)
                    EXPECT_LT(glm::length(velocity_of(*flow, p, near) - there), 1e-7);
            }
        }
    }
}

TEST(Between, LeavesAFieldThatStandsStillAsItIs) {
    const auto steady = [](const Vec3& p, double) { return swinging(p, 0.3); };
    for (const Shape shape : shapes) {
        const auto linear = stored(shape, {0.0, 0.5, 1.2, 1.6}, steady);
        for (const Between between : curved)
            for (const double t : {0.2, 0.9, 1.5}) {
                const Vec3 p(0.31, -0.22, 0.17);
                EXPECT_LT(glm::length(velocity_of(*linear->interpolated(between), p, t) -
                                      velocity_of(*linear, p, t)),
                          1e-12);
            }
    }
}

TEST(Between, IsContinuousTowardsABodyAndTheSidesOfTheBox) {
    SolidMask mask;
    const tests::SampledSource nodes(grid_of(Shape::Uniform), {0.0}, swinging);
    for (std::size_t node = 0; node < node_count(nodes.grid()); ++node)
        mask.fluid.push_back(glm::length(nodes.position(node) - Vec3(0.5, 0.0, 0.0)) > 0.45);
    const auto flow = flow_over(std::make_shared<tests::SampledSource>(
                                    grid_of(Shape::Uniform), std::vector{0.0, 0.5, 1.0, 1.5, 2.0},
                                    swinging, mask))
                          ->interpolated(Between::Flow);
    const auto largest_jump = [&](int steps) {
        double most = 0.0;
        Vec3 before(0.0);
        for (int i = 0; i <= steps; ++i) {
            const Vec3 p(-2.0 + 4.0 * i / steps, 0.13, 0.07); // through the body, side to side
            const Vec3 here = velocity_of(*flow, p, 1.2);
            if (i > 0)
                most = std::max(most, glm::length(here - before));
            before = here;
        }
        return most;
    };
    EXPECT_LT(largest_jump(16'000), 0.3 * largest_jump(4'000));
}

TEST(Between, CarriesTangentsByTheGradientOfItsOwnField) {
    for (const Shape shape : shapes)
        for (const Between between : curved) {
            const auto flow =
                stored(shape, {0.0, 0.5, 1.2, 1.6, 2.0}, swinging)->interpolated(between);
            Swarm middle(40), ahead(40);
            constexpr double apart = 1e-6;
            for (Vec3& p : ahead.position)
                p.x += apart;
            for (Swarm* swarm : {&middle, &ahead})
                swarm->advance(*flow, 0.101, 0.001);
            std::size_t same = 0;
            for (std::size_t i = 0; i < 40; ++i) {
                const Vec3 measured = (ahead.position[i] - middle.position[i]) / apart;
                same += glm::length(measured - middle.along_s[i]) <
                        0.02 * glm::length(middle.along_s[i] - Vec3(1, 0, 0)) + 1e-7;
            }
            EXPECT_GE(same, 38u) << static_cast<int>(shape); // one or two cross a face meanwhile
        }
}

TEST(Between, GivesTheSameBytesForAnyNumberOfThreadsAndInBricks) {
    for (const Shape shape : shapes) {
        const auto whole = std::make_shared<tests::SampledSource>(
            grid_of(shape), std::vector{0.0, 0.5, 1.2, 1.6, 2.0}, swinging);
        for (const Between between : curved) {
            const auto carried = [&](const std::shared_ptr<const TimeStepSource>& source,
                                     std::size_t threads) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                                threads);
                Swarm swarm(600);
                swarm.advance(*flow_over(source)->interpolated(between), 1.9);
                return swarm;
            };
            const Swarm one = carried(whole, 1);
            EXPECT_TRUE(one.same_as(carried(whole, 4)));
            if (shape == Shape::Cells) // has no bricks
                continue;
            EXPECT_TRUE(one.same_as(carried(std::make_shared<tests::BrickedSource>(whole, 8), 2)));
        }
    }
}

TEST(Between, HoldsFourTimeStepsAndKeepsThemInATwinThroughFewerOfThem) {
    const auto linear = stored(Shape::Uniform, {0, 1, 2, 3, 4, 5, 6},
                               [](const Vec3&, double t) { return Vec3(t * t * t, 0.0, 0.0); });
    const auto twin = linear->interpolated(Between::Cubic)->thinned(2, 0.0);
    // Hermite between 2 and 4 with the slopes of parabolas through 0, 2, 4 and 2, 4, 6.
    EXPECT_NEAR(velocity_of(*twin, Vec3(0.0), 3.0).x, 0.5 * (8 + 64) + 2.0 / 8.0 * (16 - 52), 1e-4);
}

TEST(Between, IsTheSameFlowEachTimeItIsAskedFor) {
    const auto linear = stored(Shape::Uniform, {0.0, 1.0}, swinging);
    const auto flow = linear->interpolated(Between::Flow);
    EXPECT_EQ(flow, linear->interpolated(Between::Flow));
    EXPECT_NE(flow, linear->interpolated(Between::Cubic));
}

} // namespace wakesurf::core::between_test
