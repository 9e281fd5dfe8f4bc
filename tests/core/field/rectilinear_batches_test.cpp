// Particles in batches through stored data on rectilinear grids: beside the steps in double on the same data,
// and beside the uniform grid's.
#include "core/field/advance_particles.hpp"
#include "core/field/advance_stored.hpp"
#include "core/field/grid_sampling.hpp"
#include "core/field/refill_batch.hpp"
#include "core/field/stored_pair.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace wakesurf::core::rectilinear_batches_test {
namespace {

using namespace tests;

const Box box{{-1.0, 0.0, 2.0}, {2.0, 2.5, 4.0}};
const Vec3 middle(0.5, 1.2, 3.0);

/// @param stretch  0: even; 0.97: cells in the middle are 60 times as wide as at the ends
RectilinearGrid grid_of(const std::array<std::size_t, 3>& nodes, double stretch) {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        for (std::size_t k = 0; k < nodes[axis]; ++k) {
            const double u = static_cast<double>(k) / static_cast<double>(nodes[axis] - 1);
            const double bent = u - stretch * std::sin(2.0 * M_PI * u) / (2.0 * M_PI);
            grid.coordinates[axis].push_back(box.lo[i] + bent * box.extent()[i]);
        }
        grid.coordinates[axis].back() = box.hi[i];
    }
    return grid;
}

Vec3 swirling(const Vec3& p, double t) {
    const double a = 1.7 + 0.5 * t;
    return {a * std::sin(p.z) + std::cos(p.y), 1.4 * std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + 1.4 * std::cos(p.x)};
}

/// Two time-steps in memory, with a solid ball in the middle, and what samples them.
template <class Axes>
struct Data {
    template <class SomeGrid>
    Data(const SomeGrid& grid, const Axes& axes)
        : mask(ball(grid)), cells(dimensions(axes), mask), source(grid, {0.0, 1.0}, swirling, mask),
          first(source.load(0, {}).value()), second(source.load(1, {}).value()),
          field(linear_sampler(axes, cells, mask, {nullptr, first, second, nullptr})) {}

    static SolidMask ball(const Grid& grid) {
        SolidMask mask;
        const SampledSource where(grid, {0.0}, swirling);
        for (std::size_t node = 0; node < node_count(grid); ++node)
            mask.fluid.push_back(glm::length(where.position(node) - middle) > 0.45);
        return mask;
    }

    SolidMask mask;
    CellMask cells;
    SampledSource source;
    std::shared_ptr<const TimeStep> first, second;
    GridSampler<Axes> field;
};

struct Swarm {
    std::vector<Vec3> position, along_s, along_t;
    std::vector<double> time;
    std::vector<CurveEnd> end;
    std::vector<float> expansion;

    Particles particles() { return {position, along_s, along_t, time, end, {}, {}, {}, expansion}; }
};

/// Anywhere, on the border, at nodes, and beside the ball. @param together  else every other one is released
/// later
Swarm everywhere(const RectilinearGrid& grid, bool together) {
    Swarm swarm;
    swarm.position = random_points(box, 1500, 3);
    for (std::size_t i = 0; i < swarm.position.size(); ++i) {
        Vec3& p = swarm.position[i];
        const int axis = static_cast<int>(i / 5 % 3);
        const auto& nodes = grid.coordinates[i / 5 % 3];
        if (i % 5 == 1)
            p[axis] = i % 2 == 0 ? box.lo[axis] : box.hi[axis];
        if (i % 5 == 2)
            p[axis] = nodes[i % nodes.size()];
        if (i % 5 == 3)
            p = middle + glm::normalize(p - middle) * 0.55;
        swarm.along_s.emplace_back(1.0, 0.3, -0.2);
        swarm.along_t.emplace_back(-0.1, 0.8, 0.5);
        swarm.time.push_back(together || i % 2 == 0 ? 0.1 : 0.3);
        swarm.end.push_back(CurveEnd::Running);
        swarm.expansion.push_back(0.25f);
    }
    return swarm;
}

AdvanceOptions in_steps_of(double step) {
    return {.step = step, .stagnation_speed = 0.02};
}

void expect_same_bits(const Swarm& a, const Swarm& b) {
    const auto same = [](const auto& one, const auto& other) {
        return std::memcmp(one.data(), other.data(), one.size() * sizeof(one[0])) == 0;
    };
    EXPECT_TRUE(same(a.position, b.position));
    EXPECT_TRUE(same(a.along_s, b.along_s));
    EXPECT_TRUE(same(a.expansion, b.expansion));
    EXPECT_TRUE(same(a.along_t, b.along_t));
    EXPECT_TRUE(same(a.time, b.time));
    EXPECT_EQ(a.end, b.end);
}

std::size_t ended(const Swarm& swarm, CurveEnd end) {
    return static_cast<std::size_t>(std::count(swarm.end.begin(), swarm.end.end(), end));
}

/// The larger at most `share` of the differences, and the largest.
std::array<double, 2> apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double share) {
    std::vector<double> apart;
    for (std::size_t i = 0; i < a.size(); ++i)
        apart.push_back(glm::length(a[i] - b[i]));
    std::sort(apart.begin(), apart.end());
    return {apart[static_cast<std::size_t>(share * static_cast<double>(apart.size()))],
            apart.back()};
}

TEST(RectilinearBatches, AgreeWithTheStepsInDoubleAlsoWhereTheyCrossManyCells) {
    for (const double stretch : {0.0, 0.6, 0.97})
        for (const double step :
             {0.01, 0.2}) { // of 0.02 to 0.6 lengths: up to a hundred narrow cells
            const RectilinearGrid grid = grid_of({33, 28, 41}, stretch);
            const RectilinearAxes axes(grid);
            const Data data(grid, axes);
            for (const int sign : {1, -1}) {
                Swarm exact = everywhere(grid, true);
                const double to = sign > 0 ? 0.9 : 0.0;
                Swarm fast = exact;
                ASSERT_TRUE(advance_particles(data.field, exact.particles(), to, sign,
                                              in_steps_of(step), {}));
                ASSERT_TRUE(advance_stored(data.field, choose_rk4_kernel(Simd::Best),
                                           fast.particles(), to, sign, in_steps_of(step), {}));
                EXPECT_GT(ended(exact, CurveEnd::Running), 100u);
                EXPECT_EQ(exact.end, fast.end) << stretch << " " << step;
                EXPECT_LT(apart(exact.position, fast.position, 1.0 - 1e-9)[1], 4e-6);
                // Gradients jump at faces: a rare stage falls on the other side of one.
                EXPECT_LT(apart(exact.along_s, fast.along_s, 0.95)[0], 2e-5);
                EXPECT_LT(apart(exact.along_t, fast.along_t, 0.95)[0], 2e-5);
            }
        }
}

TEST(RectilinearBatches, EvenAxesCarryParticlesAsTheUniformKernelDoes) {
    const std::array<std::size_t, 3> nodes{33, 28, 41};
    const RectilinearGrid grid = grid_of(nodes, 0.0);
    const UniformGrid even{box.lo, box.extent() / Vec3(32.0, 27.0, 40.0), {33, 28, 41}};
    const RectilinearAxes axes(grid);
    const Data data(grid, axes);
    const Data<UniformGrid> twin(even, even);
    Swarm a = everywhere(grid, true);
    Swarm b = a;
    const Rk4Kernel kernel = choose_rk4_kernel(Simd::Best);
    ASSERT_TRUE(advance_stored(data.field, kernel, a.particles(), 0.9, 1, in_steps_of(0.02), {}));
    ASSERT_TRUE(advance_stored(twin.field, kernel, b.particles(), 0.9, 1, in_steps_of(0.02), {}));
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.end.size(); ++i) // on the border a rounding decides
        same += a.end[i] == b.end[i] ? 1 : 0;
    EXPECT_GT(same, a.end.size() - 5);
    EXPECT_LT(apart(a.position, b.position, 0.99)[0], 1e-6);
    EXPECT_LT(apart(a.along_s, b.along_s, 0.95)[0], 1e-5);
}

TEST(RectilinearBatches, AreTheSameBitsWithEveryKernelAndTogetherAsStepByStep) {
    for (const double stretch : {0.6, 0.97})
        for (const double step : {0.013, 0.15})
            for (const bool together : {true, false}) {
                const RectilinearGrid grid = grid_of({33, 28, 41}, stretch);
                const RectilinearAxes axes(grid);
                const Data data(grid, axes);
                const Swarm start = everywhere(grid, together);
                const AdvanceOptions options = in_steps_of(step);
                Swarm one_by_one = start;
                const Particles particles = one_by_one.particles();
                const StoredPair pair = stored_pair(data.field, options);
                RefillBatch batch(data.field, pair, choose_rk4_kernel(Simd::Portable), particles,
                                  0.9, options);
                for (std::size_t i = 0; i < start.position.size(); ++i) {
                    while (batch.full())
                        batch.step();
                    batch.enqueue(i);
                }
                while (!batch.empty())
                    batch.step();
                EXPECT_GT(ended(one_by_one, CurveEnd::Running), 100u);
                EXPECT_GT(ended(one_by_one, CurveEnd::Domain), 100u);
                EXPECT_GT(ended(one_by_one, CurveEnd::Obstacle), 20u);
                for (const Simd simd : {Simd::Best, Simd::Avx2, Simd::Portable}) {
                    Swarm swarm = start;
                    ASSERT_TRUE(advance_stored(data.field, choose_rk4_kernel(simd),
                                               swarm.particles(), 0.9, 1, options, {}));
                    expect_same_bits(one_by_one, swarm);
                }
            }
}

} // namespace
} // namespace wakesurf::core::rectilinear_batches_test
