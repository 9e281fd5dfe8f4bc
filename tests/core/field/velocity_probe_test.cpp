// Velocities that come out of advancing, and those of many points at one time: the same samples.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace wakesurf::core::velocity_probe_test {
namespace {

using namespace tests;

const Box box{{-1.0, 0.0, 2.0}, {2.0, 2.5, 4.0}};
const UniformGrid even{box.lo, box.extent() / Vec3(30.0, 25.0, 20.0), {31, 26, 21}};
const std::vector<double> times{0.0, 0.3, 0.7, 1.3};

RectilinearGrid stretched() {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        for (int k = 0; k <= 24; ++k)
            grid.coordinates[axis].push_back(
                box.lo[i] + box.extent()[i] * (k / 24.0 - 0.1 * std::sin(2.0 * M_PI * k / 24.0)));
        grid.coordinates[axis].back() = box.hi[i];
    }
    return grid;
}

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * std::sin(3.0 * t);
    return {a * std::sin(p.z) + std::cos(p.y), 1.4 * std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + 1.4 * std::cos(p.x)};
}

Vec3 with_a_hole(const Vec3& p, double t) {
    return glm::length(p - box.lo) < 0.5 ? Vec3(std::nan("")) : swirling(p, t);
}

SolidMask ball(const Grid& grid) {
    SolidMask mask;
    const SampledSource where(grid, {0.0}, swirling);
    for (std::size_t node = 0; node < node_count(grid); ++node)
        mask.fluid.push_back(glm::length(where.position(node) - Vec3(0.5, 1.2, 3.0)) > 0.45);
    return mask;
}

std::unique_ptr<Flow>
flow_on(const Grid& grid, Simd simd = Simd::Best, SampledSource::Velocity velocity = swirling) {
    auto source = std::make_shared<SampledSource>(grid, times, std::move(velocity), ball(grid));
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}),
        std::make_shared<SteadyClock>(), simd);
}

bool same_bits(const Vec3f& a, const Vec3f& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Inside, on the border, and a little outside.
std::vector<Vec3> points() {
    std::vector<Vec3> points = random_points({box.lo - 0.1, box.hi + 0.1}, 1000, 4);
    for (std::size_t i = 0; i < points.size(); i += 9)
        points[i] = box.lo + box.extent() * glm::round((points[i] - box.lo) / box.extent());
    return points;
}

TEST(VelocityProbe, ThoseWhoArriveHaveTheBitsOfSamplingAfterwards) {
    struct Way {
        double from, to;
    };

    const Way ways[] = {{0.05, 0.25}, {0.05, 0.3}, {0.05, 0.6}, {0.4, 1.3}, {1.2, 0.7}, {0.6, 0.0}};
    for (const Grid& grid : {Grid(even), Grid(stretched())})
        for (const bool smooth : {false, true})
            for (const auto& [from, to] : ways)
                for (const Simd simd : {Simd::Best, Simd::Portable}) {
                    const auto flow = flow_on(grid, simd);
                    PlainSwarm swarm(random_points(box, 1000, 6), from);
                    Particles particles = swarm.particles();
                    const Vec3f untouched(7.0f);
                    std::vector<Vec3f> velocity(particles.count(), untouched);
                    std::vector<std::uint8_t> sampled(particles.count(), 0);
                    particles.velocity = velocity;
                    particles.sampled = sampled;
                    AdvanceOptions options{.step = 0.05, .smooth = smooth};
                    ASSERT_TRUE(flow->advance(particles, to, options, {}));
                    std::vector<Vec3f> afterwards(particles.count());
                    ASSERT_TRUE(flow->sample_at(swarm.position, to, afterwards, {}, smooth));
                    std::size_t arrived = 0;
                    for (std::size_t i = 0; i < particles.count(); ++i) {
                        arrived += swarm.end[i] == CurveEnd::Running ? 1 : 0;
                        ASSERT_TRUE(same_bits(velocity[i], sampled[i] ? afterwards[i] : untouched))
                            << i << " to " << to;
                        ASSERT_TRUE(!sampled[i] || swarm.end[i] == CurveEnd::Running);
                    }
                    const auto written = std::count(sampled.begin(), sampled.end(), 1);
                    EXPECT_GT(arrived, 90u);
                    EXPECT_GT(static_cast<std::size_t>(written), arrived * 7 / 10);
                }
}

TEST(VelocityProbe, ManyPointsAtOneTimeAreTheSamplesInDoubleToTheRoundingOfFloats) {
    for (const Grid& grid : {Grid(even), Grid(stretched())})
        for (const bool smooth : {false, true})
            for (const double time : {0.0, 0.13, 0.3, 0.9, 1.3}) {
                const auto flow = flow_on(grid);
                const auto at = points();
                const std::vector<double> same(at.size(), time);
                std::vector<Vec3> exact(at.size());
                std::vector<Vec3f> fast(at.size());
                ASSERT_TRUE(flow->sample(at, same, exact, {}, smooth));
                ASSERT_TRUE(flow->sample_at(at, time, fast, {}, smooth));
                for (std::size_t i = 0; i < at.size(); ++i)
                    EXPECT_LT(glm::length(Vec3(fast[i]) - exact[i]), 5e-6) << i << " " << time;
            }
}

TEST(VelocityProbe, IsTheSameBitsWithEveryKernelAndOfAPointByItself) {
    for (const Grid& grid : {Grid(even), Grid(stretched())})
        for (const bool smooth : {false, true}) {
            const auto at = points();
            std::vector<Vec3f> all(at.size());
            ASSERT_TRUE(flow_on(grid, Simd::Portable)->sample_at(at, 0.9, all, {}, smooth));
            for (const Simd simd : {Simd::Best, Simd::Avx2}) {
                const auto flow = flow_on(grid, simd);
                std::vector<Vec3f> others(at.size());
                ASSERT_TRUE(flow->sample_at(at, 0.9, others, {}, smooth));
                for (std::size_t i = 0; i < at.size(); ++i)
                    ASSERT_TRUE(same_bits(all[i], others[i])) << i;
                for (std::size_t i = 0; i < at.size(); i += 50) {
                    Vec3f one;
                    ASSERT_TRUE(flow->sample_at({&at[i], 1}, 0.9, {&one, 1}, {}, smooth));
                    ASSERT_TRUE(same_bits(all[i], one)) << i;
                }
            }
        }
}

TEST(VelocityProbe, WithoutTheKernelItIsTheSampleInDouble) {
    const auto holes = flow_on(even, Simd::Best, with_a_hole);
    const auto closed = make_analytic_flow("abc").value();
    for (const Flow* flow : {holes.get(), closed.get()}) {
        const auto at = random_points(box, 300, 2);
        const std::vector<double> same(at.size(), 0.9);
        std::vector<Vec3> exact(at.size());
        std::vector<Vec3f> fast(at.size());
        ASSERT_TRUE(flow->sample(at, same, exact, {}));
        ASSERT_TRUE(flow->sample_at(at, 0.9, fast, {}));
        for (std::size_t i = 0; i < at.size(); ++i)
            EXPECT_EQ(fast[i], Vec3f(exact[i])) << i;
    }
}

} // namespace
} // namespace wakesurf::core::velocity_probe_test
