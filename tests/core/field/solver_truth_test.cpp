// What is between stored times, against a solver that stored nearly every step: the wake of a sphere at Re 500, on a small grid
// (tests/between_times/extract.py). All of its times are the truth; users have every few of them.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/builder/twin.hpp"
#include "tests/support/places.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace wakesurf::core::solver_truth_test {

namespace {

constexpr std::size_t steps = 49;

class SphereWake final : public TimeStepSource {
  public:
    SphereWake() {
        UniformGrid grid;
        grid.origin = {0.75, -1.0, -1.0};
        grid.spacing = Vec3(0.25);
        grid.dimensions = {13, 9, 9};
        grid_ = grid;
        for (std::size_t k = 0; k < steps; ++k)
            times_.push_back(42.0 + static_cast<double>(k) / 10.0);
        std::ifstream file(tests::source_folder() / "tests/between_times/sphere_wake.i16",
                           std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(file), {});
        values_.resize(bytes.size() / 2);
        std::memcpy(values_.data(), bytes.data(), bytes.size());
    }

    bool whole() const { return values_.size() == steps * node_count(grid_) * 3; }

    const Grid& grid() const override { return grid_; }

    const SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return node_count(grid_) * 12; }

    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token) const override {
        auto step = std::make_shared<TimeStep>();
        step->index = index;
        step->time = times_[index];
        step->slab = Slab(bytes_per_step());
        auto* out = reinterpret_cast<float*>(step->slab.bytes().data());
        const std::size_t count = node_count(grid_) * 3;
        for (std::size_t i = 0; i < count; ++i)
            out[i] = static_cast<float>(values_[index * count + i]) / 16384.0F;
        return step;
    }

  private:
    Grid grid_;
    SolidMask mask_;
    std::vector<double> times_;
    std::vector<std::int16_t> values_;
};

std::shared_ptr<const Flow> solver() {
    const auto wake = std::make_shared<SphereWake>();
    EXPECT_TRUE(wake->whole());
    return make_stored_flow(std::make_shared<TimeStepCache>(wake, TimeStepCache::Options{}));
}

/// What a user with every `stride`-th time builds behind the sphere, and where the solver takes the same particles.
struct Beside {
    Surface surface;
    TwinComparison truth;
};

Beside
beside_the_solver(const std::shared_ptr<const Flow>& all, std::size_t stride, Between between) {
    SurfaceParameters p;
    p.kind = SurfaceKind::Streak;
    p.from = 42.0;
    p.to = 46.4;
    p.separation = 0.1;
    p.between = between;
    const SurfacePlan plan =
        value_of(plan_surface(all->thinned(stride, 42.0),
                              {Rake::Kind::Line, {{0.9, -0.6, 0.1}, {0.9, 0.6, 0.1}}, 17}, p));
    Surface surface = value_of(build_surface(plan));
    EXPECT_TRUE(state_interval_errors(plan, surface, {}));
    auto truth = value_of(compare_twin(
        plan, surface, value_of(plan_twin(plan, all, {.between = Between::Linear})), {}));
    return {std::move(surface), std::move(truth)};
}

} // namespace

TEST(SolverTruth, IsAsFarAsTheStatedErrorWithinAFactorOfThree) {
    const auto all = solver();
    for (const std::size_t stride : {4U, 8U}) {
        const auto [surface, truth] = beside_the_solver(all, stride, Between::Linear);
        std::size_t resolved = 0, near = 0;
        for (VertexId v = 0; v < surface.mesh.vertices(); ++v) {
            const double stated = surface.mesh.interval_error[v];
            const double off = truth.distance[v];
            if (surface.mesh.approximated[v] != 0 || std::isnan(stated) || std::isnan(off))
                continue;
            ++resolved;
            near += off < 3.0 * stated + 1e-4 && stated < 3.0 * off + 1e-4 ? 1 : 0;
        }
        ASSERT_TRUE(surface.statistics.interval_error);
        EXPECT_GT(resolved, surface.mesh.vertices() / 4);
        EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(resolved)) << stride;
    }
}

TEST(SolverTruth, IsFartherFromLinearInterpolationThanFromThatAlongTheFlow) {
    const auto all = solver();
    for (const std::size_t stride : {4U, 8U}) {
        const TwinDistance linear =
            beside_the_solver(all, stride, Between::Linear).truth.stated.all;
        const TwinDistance flow = beside_the_solver(all, stride, Between::Flow).truth.stated.all;
        EXPECT_LT(flow.p50, 1.05 * linear.p50);
        EXPECT_LT(flow.p90, 0.6 * linear.p90);
    }
}

} // namespace wakesurf::core::solver_truth_test
