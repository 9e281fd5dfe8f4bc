#include "core/field/trace_curves.hpp"
#include "core/field/trilinear_steps.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace wakesurf::core::trace_together_test {

namespace {

const UniformGrid grid{Vec3(0.0, -1.0, 2.0), Vec3(0.1, 0.12, 0.09), {33, 29, 31}};

/// Nothing moves along one axis, so that terms are 0 there: also the sign of a 0 is one of the bits.
Vec3 plane(const Vec3& p, double t) {
    return {std::cos(p.y) + t, 1.4 * std::sin(p.x), 0.0};
}

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * t;
    return {a * std::sin(p.z) + std::cos(p.y), 1.4 * std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + 1.4 * std::cos(p.x)};
}

/// In the domain, some just outside of it and some in a ball, for longer and shorter.
std::vector<Curve> everywhere(double duration) {
    std::vector<Curve> curves(61);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-0.01, 1.01);
    for (Curve& curve : curves) {
        curve.seed = grid.bounds().lo +
                     grid.bounds().extent() * Vec3(unit(random), unit(random), unit(random));
        curve.seed_tangent = {unit(random), unit(random), 0.3};
        curve.release = 0.5;
        curve.duration = duration * std::abs(unit(random));
    }
    curves[5].duration = 1e-9 * duration;
    return curves;
}

template <class Number>
bool same_bytes(const std::vector<Number>& a, const std::vector<Number>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

} // namespace

TEST(TraceTogether, ACurveHasTheBitsThatItHasAlone) {
    for (const auto& velocity : {swirling, plane}) {
        SolidMask mask;
        const tests::SampledSource where(grid, {0.0}, swirling);
        for (std::size_t node = 0; node < grid.nodes(); ++node)
            mask.fluid.push_back(glm::length(where.position(node) - Vec3(1.6, 0.68, 3.35)) > 0.5);
        const CellMask cells(grid.dimensions, mask);
        const tests::SampledSource source(grid, {0.0, 1.0}, velocity, mask);
        const auto first = source.load(0, {}).value();
        const auto second = source.load(1, {}).value();
        const CellwiseSampler<UniformGrid> field{
            {&grid, &cells, &mask, first->velocity().data(), second->velocity().data(), 0.0, 1.0}};
        for (const bool frozen : {true, false})
            for (const double duration : {+1.5, -1.5})
                for (const double tolerance : {1e-6, 1e-13}) { // the second shortens steps
                    const TraceOptions options{.frozen = frozen,
                                               .tolerance = tolerance,
                                               .longest_step = 0.1,
                                               .stagnation_speed = 1e-3,
                                               .stretch = true};
                    std::vector<Curve> together = everywhere(duration);
                    std::vector<Curve> alone = together;
                    ASSERT_TRUE(trace_curves(field, together, options,
                                             duration * std::numeric_limits<double>::infinity(), {},
                                             series_kernel()));
                    for (std::size_t i = 0; i < alone.size(); ++i) {
                        ASSERT_TRUE(
                            advance_curve(field.series_steps(options, duration < 0.0 ? -1.0 : 1.0),
                                          alone[i], options, alone[i].duration, {}));
                        EXPECT_EQ(alone[i].end, together[i].end) << i;
                        EXPECT_EQ(alone[i].attempts, together[i].attempts) << i;
                        EXPECT_EQ(alone[i].last.position, together[i].last.position) << i;
                        EXPECT_TRUE(same_bytes(alone[i].steps, together[i].steps)) << i;
                        EXPECT_TRUE(same_bytes(alone[i].stretches, together[i].stretches)) << i;
                    }
                }
    }
}

TEST(TraceTogether, EveryKernelGivesTheSameBits) {
    const SeriesKernel& best = series_kernel();
    if (best.expand == series_portable.expand)
        GTEST_SKIP() << "this processor has the portable kernel alone";
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int round = 0; round < 2000; ++round) {
        SeriesBatch a;
        std::memset(static_cast<void*>(&a), 0, sizeof a);
        a.unsteady = round % 2 == 1;
        for (std::size_t lane = 0; lane < SeriesBatch::lanes; ++lane) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (std::size_t i = 0; i < 8; ++i) {
                    a.now[i][axis][lane] = round % 5 == 0 && axis == 2 ? 0.0 : unit(random);
                    a.change[i][axis][lane] = 0.1 * unit(random);
                }
                a.place[axis][lane] = std::abs(unit(random));
                a.size[axis][lane] = 0.1 + 0.05 * unit(random);
                a.low[axis][lane] = unit(random);
            }
            a.part[lane] = a.rate[lane] = 0.5;
            a.allowed[lane] = 1e-6;
        }
        SeriesBatch b = a;
        best.expand(a);
        series_portable.expand(b);
        for (std::size_t lane = 0; lane < SeriesBatch::lanes; ++lane)
            a.time[lane] = b.time[lane] = std::min(b.exit_time[lane], 10.0);
        best.step(a);
        series_portable.step(b);
        ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << round;
    }
}

} // namespace wakesurf::core::trace_together_test
