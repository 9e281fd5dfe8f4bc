#include "core/field/advance_particles.hpp"
#include "core/field/advance_stored.hpp"
#include "core/field/refill_batch.hpp"
#include "core/field/stored_flow.hpp"
#include "core/field/stored_pair.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>

namespace wakesurf::core::advance_stored_test {

using tests::SampledSource;

namespace {

const UniformGrid grid{Vec3(0.0, -1.0, 2.0), Vec3(0.1, 0.12, 0.09), {33, 29, 31}};

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * t * std::sin(std::numbers::pi * t);
    return {a * std::sin(p.z) + std::cos(p.y), 1.4 * std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + 1.4 * std::cos(p.x)};
}

/// A ball of solid nodes in the middle.
SolidMask ball() {
    SolidMask mask;
    const SampledSource where(grid, {0.0}, swirling);
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        const Vec3 p = where.position(node);
        mask.fluid.push_back(glm::length(p - Vec3(1.6, 0.68, 3.35)) > 0.5);
    }
    return mask;
}

struct Swarm {
    std::vector<Vec3> position, along_s, along_t;
    std::vector<double> time;
    std::vector<CurveEnd> end;
    std::vector<float> expansion{};

    Particles particles(bool tangents) {
        return {position,
                tangents ? std::span(along_s) : std::span<Vec3>{},
                tangents ? std::span(along_t) : std::span<Vec3>{},
                time,
                end,
                {},
                {},
                {},
                tangents ? std::span(expansion) : std::span<float>{}};
    }

    Swarm only(std::size_t i) const {
        return {{position[i]}, {along_s[i]}, {along_t[i]}, {time[i]}, {end[i]}, {expansion[i]}};
    }
};

/// Inside, on the borders, just outside, at nodes and faces, in and beside the ball; released at different times, some
/// when they shall arrive.
Swarm everywhere(std::size_t count, double earliest, double latest) {
    Swarm swarm;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    const Box box = grid.bounds();
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 p = box.lo + box.extent() * vector();
        if (i % 7 == 1)
            p[static_cast<int>(i / 7 % 3)] = i % 2 == 0 ? box.lo[static_cast<int>(i / 7 % 3)]
                                                        : box.hi[static_cast<int>(i / 7 % 3)];
        if (i % 7 == 2)
            p = box.lo - 0.01 + (box.extent() + 0.02) * glm::round(vector());
        if (i % 7 == 3)
            p = grid.origin + grid.spacing * glm::round((p - grid.origin) / grid.spacing);
        if (i % 7 == 4)
            p = Vec3(1.6, 0.68, 3.35) +
                glm::normalize(vector() - 0.5) * (0.35 + 0.3 * unit(random));
        swarm.position.push_back(p);
        swarm.along_s.push_back(vector() - 0.5);
        swarm.along_t.push_back(vector() - 0.5);
        swarm.time.push_back(i % 5 == 0 ? earliest : earliest + (latest - earliest) * unit(random));
        swarm.end.push_back(i % 31 == 0 ? CurveEnd::Domain : CurveEnd::Running);
        swarm.expansion.push_back(0.1f * static_cast<float>(i % 3));
    }
    return swarm;
}

AdvanceOptions in_steps_of(double step, bool smooth = false) {
    return {.step = step, .stagnation_speed = 0.02, .smooth = smooth};
}

std::unique_ptr<Flow>
stored(std::vector<double> times, Simd simd, SampledSource::Velocity velocity = swirling) {
    auto source = std::make_shared<SampledSource>(grid, std::move(times), velocity, ball());
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}),
        std::make_shared<SteadyClock>(), simd);
}

std::array<std::uint64_t, 3> bits(const Vec3& v) {
    return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
            std::bit_cast<std::uint64_t>(v.z)};
}

void expect_same_bits(const Swarm& a, const Swarm& b) {
    for (std::size_t i = 0; i < a.position.size(); ++i) {
        ASSERT_EQ(bits(a.position[i]), bits(b.position[i])) << "particle " << i;
        ASSERT_EQ(bits(a.along_s[i]), bits(b.along_s[i])) << "particle " << i;
        ASSERT_EQ(bits(a.along_t[i]), bits(b.along_t[i])) << "particle " << i;
        ASSERT_EQ(a.time[i], b.time[i]) << "particle " << i;
        ASSERT_EQ(a.expansion[i], b.expansion[i]) << "particle " << i;
        ASSERT_EQ(a.end[i], b.end[i]) << "particle " << i;
    }
}

std::size_t ended(const Swarm& swarm, CurveEnd end) {
    return static_cast<std::size_t>(std::count(swarm.end.begin(), swarm.end.end(), end));
}

} // namespace

TEST(AdvanceStored, EveryKernelThatTheProcessorRunsGivesTheSameBits) {
    if (choose_rk4_kernel(Simd::Best) == choose_rk4_kernel(Simd::Portable))
        GTEST_SKIP() << "this processor has one kernel only";
    const std::vector<std::vector<double>> series{{0.0}, {0.0, 0.3, 0.7, 1.0}};
    for (const std::vector<double>& times : series)
        for (const int kind : {0, 1, 2, 3, 4, 5, 6, 7}) {
            const bool tangents = (kind & 1) != 0;
            const bool back = (kind & 2) != 0;
            const AdvanceOptions options = in_steps_of(0.013, (kind & 4) != 0);
            const Swarm start = back ? everywhere(2000, 0.95, 0.4) : everywhere(2000, 0.05, 0.7);
            const double to = back ? 0.1 : 0.9;
            const auto carried_by = [&](Simd simd) {
                Swarm swarm = start;
                EXPECT_TRUE(
                    stored(times, simd)->advance(swarm.particles(tangents), to, options, {}));
                return swarm;
            };
            const Swarm a = carried_by(Simd::Portable);
            expect_same_bits(a, carried_by(Simd::Avx2));
            expect_same_bits(a, carried_by(Simd::Best));
            EXPECT_GT(ended(a, CurveEnd::Running), 200u);
            EXPECT_GT(ended(a, CurveEnd::Domain), 200u);
            EXPECT_GT(ended(a, CurveEnd::Obstacle), 20u);
        }
}

TEST(AdvanceStored, AParticleDoesNotDependOnThoseItTravelsWithNorOnThreads) {
    const auto flow = stored({0.0, 0.3, 0.7, 1.0}, Simd::Best);
    const Swarm start = everywhere(700, 0.05, 0.7);
    for (const bool smooth : {false, true}) {
        const AdvanceOptions options = in_steps_of(0.02, smooth);
        Swarm together = start;
        ASSERT_TRUE(flow->advance(together.particles(true), 0.9, options, {}));
        Swarm alone;
        for (std::size_t i = 0; i < start.position.size(); ++i) {
            Swarm one = start.only(i);
            ASSERT_TRUE(flow->advance(one.particles(true), 0.9, options, {}));
            alone.position.push_back(one.position[0]);
            alone.along_s.push_back(one.along_s[0]);
            alone.along_t.push_back(one.along_t[0]);
            alone.time.push_back(one.time[0]);
            alone.end.push_back(one.end[0]);
            alone.expansion.push_back(one.expansion[0]);
        }
        expect_same_bits(together, alone);
        const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
        Swarm serial = start;
        ASSERT_TRUE(flow->advance(serial.particles(true), 0.9, options, {}));
        expect_same_bits(together, serial);
    }
}

TEST(AdvanceStored, ThoseThatSetOutTogetherGoStraightWithTheBitsOfOneStepAtATime) {
    const SolidMask mask = ball();
    const CellMask cells(grid.dimensions, mask);
    const CellMask round_cells = CellMask::round_cells(grid.dimensions, mask);
    const SampledSource source(grid, {0.0, 1.0}, swirling, mask);
    const auto first = source.load(0, {}).value();
    const auto second = source.load(1, {}).value();
    const GridSampler<UniformGrid> linear{
        &grid, &cells, &mask, first->velocity().data(), second->velocity().data(), 0.0, 1.0};
    const auto compare = [](const auto& field, const AdvanceOptions& options, bool tangents) {
        const double to = 0.9;
        const Swarm start = everywhere(1500, 0.05, 0.05);
        const Rk4Kernel kernel = choose_rk4_kernel(Simd::Best);
        Swarm one_by_one = start;
        const Particles particles = one_by_one.particles(tangents);
        const StoredPair pair = stored_pair(field, options);
        RefillBatch batch(field, pair, kernel, particles, to, options);
        for (std::size_t i = 0; i < start.position.size(); ++i) {
            while (batch.full())
                batch.step();
            if (still_to_go(particles, i, to, 1))
                batch.enqueue(i);
        }
        while (!batch.empty())
            batch.step();
        Swarm straight = start;
        ASSERT_TRUE(
            advance_stored(field, kernel, straight.particles(tangents), to, 1, options, {}));
        expect_same_bits(one_by_one, straight);
        EXPECT_GT(ended(straight, CurveEnd::Running), 200u);
        EXPECT_GT(ended(straight, CurveEnd::Domain), 200u);
        EXPECT_GT(ended(straight, CurveEnd::Obstacle), 20u);
    };
    for (const bool tangents : {false, true}) {
        compare(linear, in_steps_of(0.05), tangents);
        compare(linear, in_steps_of(0.006), tangents); // more than the kernel takes at once
        CubicSampler smooth{linear};
        smooth.round_cells = &round_cells;
        compare(smooth, in_steps_of(0.05, true), tangents);
        compare(smooth, in_steps_of(0.006, true), tangents);
    }
}

TEST(AdvanceStored, AgreesWithTheStepsInDouble) {
    const SolidMask mask = ball();
    const CellMask cells(grid.dimensions, mask);
    const SampledSource source(grid, {0.0, 1.0}, swirling, mask);
    const auto first = source.load(0, {}).value();
    const auto second = source.load(1, {}).value();
    const GridSampler<UniformGrid> field{
        &grid, &cells, &mask, first->velocity().data(), second->velocity().data(), 0.0, 1.0};
    for (const double to : {0.9, 0.1}) {
        Swarm exact = to > 0.5 ? everywhere(2000, 0.05, 0.7) : everywhere(2000, 0.95, 0.4);
        Swarm fast = exact;
        const int sign = to > 0.5 ? 1 : -1;
        ASSERT_TRUE(
            advance_particles(field, exact.particles(true), to, sign, in_steps_of(0.013), {}));
        ASSERT_TRUE(advance_stored(field, choose_rk4_kernel(Simd::Best), fast.particles(true), to,
                                   sign, in_steps_of(0.013), {}));
        std::vector<double> tangent;
        for (std::size_t i = 0; i < exact.position.size(); ++i) {
            EXPECT_EQ(exact.end[i], fast.end[i]) << i;
            EXPECT_LT(glm::length((exact.position[i] - fast.position[i]) / grid.spacing), 4e-5)
                << i;
            EXPECT_NEAR(exact.time[i], fast.time[i], 1e-5) << i;
            tangent.push_back(glm::length(exact.along_s[i] - fast.along_s[i]) +
                              glm::length(exact.along_t[i] - fast.along_t[i]));
        }
        // The gradient jumps between cells, at the ball by up to a speed of 3 a spacing of 0.1: a rare stage, of weight
        // 1/3, falls on the other side of a face.
        std::sort(tangent.begin(), tangent.end());
        EXPECT_LT(tangent[tangent.size() * 95 / 100], 1e-5);
        EXPECT_LT(tangent.back(), 3.0 / 0.1 * 0.013 / 3.0);
    }
}

TEST(AdvanceStored, TheSmoothFieldAgreesWithTheStepsInDouble) {
    const SolidMask mask = ball();
    const CellMask cells(grid.dimensions, mask);
    const CellMask round_cells = CellMask::round_cells(grid.dimensions, mask);
    const SampledSource source(grid, {0.0, 0.3, 0.7, 1.0, 1.6}, swirling, mask);
    std::vector<std::shared_ptr<const TimeStep>> steps;
    for (std::size_t i = 0; i < source.times().size(); ++i)
        steps.push_back(source.load(i, {}).value());
    for (const std::size_t k : {0u, 1u, 3u}) { // at the ends of the series a time-step is missing
        const double from = source.times()[k];
        const double to = source.times()[k + 1];
        CubicSampler field{{&grid, &cells, &mask, steps[k]->velocity().data(),
                            steps[k + 1]->velocity().data(), from, to - from}};
        if (k > 0) {
            field.before = steps[k - 1]->velocity().data();
            field.time_before = steps[k - 1]->time;
        }
        if (k + 2 < steps.size()) {
            field.after = steps[k + 2]->velocity().data();
            field.time_after = steps[k + 2]->time;
        }
        CubicSampler in_batches = field;
        in_batches.round_cells = &round_cells;
        ASSERT_TRUE(kernel_samples(in_batches));
        Swarm exact = everywhere(2000, from, to);
        Swarm fast = exact;
        ASSERT_TRUE(advance_particles(field, exact.particles(true), to, 1, in_steps_of(0.013), {}));
        ASSERT_TRUE(advance_stored(in_batches, choose_rk4_kernel(Simd::Best), fast.particles(true),
                                   to, 1, in_steps_of(0.013), {}));
        std::vector<double> tangent;
        for (std::size_t i = 0; i < exact.position.size(); ++i) {
            EXPECT_EQ(exact.end[i], fast.end[i]) << i;
            EXPECT_LT(glm::length((exact.position[i] - fast.position[i]) / grid.spacing), 4e-5)
                << i;
            tangent.push_back(glm::length(exact.along_s[i] - fast.along_s[i]) +
                              glm::length(exact.along_t[i] - fast.along_t[i]));
        }
        std::sort(tangent.begin(), tangent.end());
        EXPECT_LT(tangent[tangent.size() * 95 / 100], 1e-5);
    }
}

TEST(AdvanceStored, OfACellAndThoseRoundItOneSolidNodeMakesTheFieldLinear) {
    const SolidMask mask = ball();
    const CellMask round = CellMask::round_cells(grid.dimensions, mask);
    const auto& n = grid.dimensions;
    const auto node = [&](std::size_t x, std::size_t y, std::size_t z) {
        return (z * n[1] + y) * n[0] + x;
    };
    std::size_t near = 0;
    for (std::size_t z = 0; z + 1 < n[2]; ++z)
        for (std::size_t y = 0; y + 1 < n[1]; ++y)
            for (std::size_t x = 0; x + 1 < n[0]; ++x) {
                bool fluid = true;
                for (std::size_t c = z - std::min<std::size_t>(z, 1);
                     c < std::min<std::size_t>(z + 3, n[2]); ++c)
                    for (std::size_t b = y - std::min<std::size_t>(y, 1);
                         b < std::min<std::size_t>(y + 3, n[1]); ++b)
                        for (std::size_t a = x - std::min<std::size_t>(x, 1);
                             a < std::min<std::size_t>(x + 3, n[0]); ++a)
                            fluid = fluid && mask.fluid[node(a, b, c)] != 0;
                ASSERT_EQ(round.state({x, y, z}, node(x, y, z)) == CellMask::Fluid, fluid)
                    << x << " " << y << " " << z;
                near += fluid ? 0 : 1;
            }
    EXPECT_GT(near, 100u);
}

TEST(AdvanceStored, StandingParticlesWaitWhereTheyAre) {
    const auto still = [](const Vec3& p, double) { return Vec3(p.x < 1.0 ? 0.0 : 1.0, 0.0, 0.0); };
    const auto flow = stored({0.0, 1.0}, Simd::Best, still);
    Swarm swarm = everywhere(2, 0.0, 0.0);
    swarm.position = {Vec3(0.5, 0.0, 3.0), Vec3(1.5, 0.0, 3.0)};
    swarm.end = {CurveEnd::Running, CurveEnd::Running};
    ASSERT_TRUE(flow->advance(swarm.particles(false), 0.5, in_steps_of(0.1), {}));
    EXPECT_EQ(swarm.end[0], CurveEnd::Running);
    EXPECT_EQ(swarm.time[0], 0.5);
    EXPECT_EQ(swarm.position[0], Vec3(0.5, 0.0, 3.0));
    EXPECT_EQ(swarm.end[1], CurveEnd::Running);
    EXPECT_NEAR(swarm.position[1].x, 2.0, 1e-6);
}

TEST(AdvanceStored, VelocitiesThatAreNoNumbersEndParticles) {
    const auto broken = [](const Vec3& p, double) {
        return p.x < 1.0 ? Vec3(3.0, 0.0, 0.0) : Vec3(std::nan(""), 1.0, 1.0);
    };
    for (const Simd simd : {Simd::Best, Simd::Portable}) {
        const auto flow = stored({0.0, 1.0}, simd, broken);
        Swarm swarm = everywhere(200, 0.0, 0.0);
        ASSERT_TRUE(flow->advance(swarm.particles(true), 1.0, in_steps_of(0.05), {}));
        EXPECT_EQ(ended(swarm, CurveEnd::Running), 0u);
    }
}

} // namespace wakesurf::core::advance_stored_test
