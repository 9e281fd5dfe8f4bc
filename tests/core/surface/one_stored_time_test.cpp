// One stored time is a flow that stands still, at all times. Twin: the same values stored twice.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace wakesurf::core::one_stored_time_test {

using namespace tests;

namespace {

Vec3 whirl(const Vec3& p, double) {
    return {0.6 - (p.y - 1.0), p.x - 1.0, 0.2 + 0.1 * p.x};
}

Vec3 with_rest(const Vec3& p, double) {
    return {p.x < 1.0 ? 1.0 - p.x : 0.0, 0.0, 0.0};
}

enum class Stored { Uniform, Rectilinear, Cells };

std::unique_ptr<Flow>
stored(Stored grid, std::vector<double> times, SampledSource::Velocity velocity) {
    const std::vector<double> axis{0.0, 0.3, 0.7, 1.2, 1.6, 2.0};
    Grid in = RectilinearGrid{{axis, axis, axis}};
    if (grid == Stored::Uniform)
        in = UniformGrid{.spacing = Vec3(0.25), .dimensions = {9, 9, 9}};
    if (grid == Stored::Cells)
        in = block({6, 6, 6}, [](const Vec3& u) { return 2.0 * u; });
    return make_stored_flow(std::make_shared<TimeStepCache>(
        std::make_shared<SampledSource>(std::move(in), std::move(times), std::move(velocity)),
        TimeStepCache::Options{}));
}

Surface surface_of(const Flow& flow, const SurfaceParameters& parameters) {
    const Rake rake{.points = {{0.5, 0.6, 0.2}, {1.5, 0.7, 0.4}}, .seeds = 8};
    auto built = build_surface(flow, rake, parameters);
    EXPECT_TRUE(built) << (built ? "" : built.error().message);
    return built ? std::move(*built) : Surface();
}

/// The largest distance of a vertex from the one of the same place in the other mesh; infinite if there is none.
double apart(const QuadComplex& one, const QuadComplex& other) {
    if (one.vertices() != other.vertices())
        return std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t v = 0; v < one.vertices(); ++v)
        most = std::max(most, glm::length(one.position[v] - other.position[v]));
    return most;
}

} // namespace

TEST(OneStoredTime, HasTheSurfacesOfAFlowThatIsStoredAgainAndAgain) {
    for (const Stored grid : {Stored::Uniform, Stored::Rectilinear, Stored::Cells}) {
        const auto once = stored(grid, {3.0}, whirl);
        const auto twice = stored(grid, {-50.0, 50.0}, whirl);
        for (const SurfaceKind kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
            for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact})
                for (const auto& [from, to] : {std::pair{0.0, 1.5}, {5.0, 3.5}, {2.0, 4.0}}) {
                    SurfaceParameters wanted{.kind = kind,
                                             .from = from,
                                             .to = to,
                                             .separation = 0.1,
                                             .accuracy = accuracy};
                    if (kind == SurfaceKind::Time)
                        wanted.sweep = Vec3(0.1, 0.2, 0.5);
                    const Surface one = surface_of(*once, wanted);
                    const Surface other = surface_of(*twice, wanted);
                    EXPECT_GT(one.mesh.cells.size(), 30u);
                    EXPECT_LT(apart(one.mesh, other.mesh), 1e-7) // batches compute in float
                        << static_cast<int>(grid) << static_cast<int>(kind)
                        << static_cast<int>(accuracy) << " " << from;
                }
    }
}

TEST(OneStoredTime, IsTheSameFieldAtAllTimes) {
    const std::vector<Vec3> places(3, Vec3(0.4, 1.1, 0.9));
    const std::vector<double> times{-7.0, 3.0, 1e6};
    std::vector<Vec3> velocities(3);
    for (const Stored grid : {Stored::Uniform, Stored::Rectilinear, Stored::Cells}) {
        const auto flow = stored(grid, {3.0}, whirl);
        ASSERT_TRUE(flow->sample(places, times, velocities, {}, grid == Stored::Uniform));
        for (const Vec3& v : velocities)
            EXPECT_LT(glm::length(v - whirl(places[0], 0.0)), 1e-6);
        std::vector<Vec3f> fast(3);
        ASSERT_TRUE(flow->sample_at(places, 1e6, fast, {}));
        EXPECT_LT(glm::length(Vec3(fast[2]) - whirl(places[0], 0.0)), 1e-5);
        EXPECT_FALSE(flow->time_bounds());
    }
}

TEST(OneStoredTime, EndsParticlesThatCanNeverMoveAgain) {
    for (const Stored grid : {Stored::Uniform, Stored::Rectilinear, Stored::Cells})
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Exact}) {
            const auto flow = stored(grid, {0.0}, with_rest);
            SurfaceParameters wanted{
                .kind = SurfaceKind::Time, .to = 40.0, .separation = 0.1, .accuracy = accuracy};
            wanted.sweep = Vec3(0.0, 0.1, 0.5);
            const Surface surface = surface_of(*flow, wanted);
            EXPECT_GT(surface.statistics.terminated.stagnation, 0) << static_cast<int>(grid);
        }
}

} // namespace wakesurf::core::one_stored_time_test
