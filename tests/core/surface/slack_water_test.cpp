// Fluid that is at rest for a moment: particles of path, streak and time surfaces wait, and go on with it.
// Velocities are the same everywhere and linear between the stored times, so that ways are integrals.
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace wakesurf::core::slack_water_test {

using namespace tests;

namespace {

/// A pace by time, of a flow that moves along one direction.
struct Tide {
    const char* name;
    std::vector<double> times;
    std::function<double(double)> pace;
    double from, to;

    /// Returns the way from time a to b in the interpolated field.
    double way(double a, double b) const {
        if (a > b)
            return -way(b, a);
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double left = std::clamp(a, times[i], times[i + 1]);
            const double right = std::clamp(b, times[i], times[i + 1]);
            const auto at = [&](double t) {
                const double part = (t - times[i]) / (times[i + 1] - times[i]);
                return std::lerp(pace(times[i]), pace(times[i + 1]), part);
            };
            sum += 0.5 * (right - left) * (at(left) + at(right));
        }
        return sum;
    }
};

std::vector<double> every(double dt, int count) {
    std::vector<double> times;
    for (int i = 0; i <= count; ++i)
        times.push_back(i * dt);
    return times;
}

const std::vector<Tide>& tides() {
    static const std::vector<Tide> all{
        {"slack", every(0.25, 8), [](double t) { return std::cos(0.5 * std::numbers::pi * t); }, 0,
         2},
        {"from rest", every(0.5, 3), [](double t) { return t; }, 0, 1.4},
        {"to rest, upstream", every(0.5, 3), [](double t) { return t; }, 1.4, 0},
        {"rest between", every(1.0, 6), [](double t) { return t < 1.5 || t > 4.5 ? 0.3 : 0.0; }, 0,
         6},
        {"a pulse", every(1.0, 40), [](double t) { return t == 29.0 ? 1.0 : 0.0; }, 0, 40},
        {"hardly at rest", every(1.0, 40), [](double t) { return t == 29.0 ? 1.0 : 1e-13; }, 0, 40},
    };
    return all;
}

const Vec3 direction(0.4, 0.1, 0.05);

enum class Stored { Uniform, Rectilinear, Hexahedra, AllShapes };

std::unique_ptr<Flow> stored(const Tide& tide, Stored grid) {
    const auto velocity = [pace = tide.pace](const Vec3&, double t) { return pace(t) * direction; };
    if (grid == Stored::Hexahedra || grid == Stored::AllShapes) {
        const auto whole = [](const Vec3& u) { return 2.0 * u; };
        const auto kind = [](const Vec3& c) {
            return c.x < 0.5 ? TwoToOne::Kind::Fine : TwoToOne::Kind::Coarse;
        };
        return meshed_flow(grid == Stored::Hexahedra ? block({6, 6, 6}, whole)
                                                     : TwoToOne(6, kind, whole).take(),
                           tide.times, velocity);
    }
    const std::vector<double> axis{0.0, 0.3, 0.7, 1.2, 1.6, 2.0};
    const Grid in = grid == Stored::Uniform
                        ? Grid(UniformGrid{.spacing = Vec3(0.25), .dimensions = {9, 9, 9}})
                        : Grid(RectilinearGrid{{axis, axis, axis}});
    return make_stored_flow(std::make_shared<TimeStepCache>(
        std::make_shared<SampledSource>(in, tide.times, velocity), TimeStepCache::Options{}));
}

/// The largest distance of a vertex from where the closed form has it.
double
largest_error(const Surface& surface, const Tide& tide, const Rake& rake, const Vec3& sweep) {
    const QuadComplex& mesh = surface.mesh;
    double most = 0.0;
    for (VertexId v = 0; v < mesh.vertices(); ++v) {
        Vec3 truth = rake.points[0] + mesh.s[v] * (rake.points[1] - rake.points[0]);
        switch (surface.statistics.kind) {
        case SurfaceKind::Path:
            truth += tide.way(tide.from, tide.from + mesh.t[v]) * direction;
            break;
        case SurfaceKind::Streak:
            truth += tide.way(mesh.t[v], tide.to) * direction;
            break;
        default:
            truth += mesh.t[v] * sweep + tide.way(tide.from, tide.to) * direction;
        }
        most = std::max(most, glm::length(mesh.position[v] - truth));
    }
    return most;
}

} // namespace

TEST(SlackWater, ParticlesWaitAndGoOnWithTheFluid) {
    const Rake rake{.points = {{0.7, 0.6, 0.4}, {0.7, 1.2, 0.7}}, .seeds = 5};
    for (const Tide& tide : tides())
        for (const Stored grid :
             {Stored::Uniform, Stored::Rectilinear, Stored::Hexahedra, Stored::AllShapes}) {
            const auto flow = stored(tide, grid);
            for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
                for (const auto accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
                    SCOPED_TRACE(testing::Message()
                                 << tide.name << " " << static_cast<int>(grid) << " "
                                 << static_cast<int>(kind) << " " << static_cast<int>(accuracy));
                    SurfaceParameters p{.kind = kind,
                                        .from = tide.from,
                                        .to = tide.to,
                                        .separation = 0.2,
                                        .accuracy = accuracy};
                    const Vec3 sweep(0.0, 0.0, 0.3);
                    if (kind == SurfaceKind::Time)
                        p.sweep = sweep;
                    const auto surface = build_surface(*flow, rake, p);
                    ASSERT_TRUE(surface) << surface.error().message;
                    const SurfaceStatistics& of = surface->statistics;
                    EXPECT_FALSE(of.empty);
                    EXPECT_EQ(of.terminated.stagnation + of.terminated.obstacle, 0U);
                    // Velocities are floats. A streak trusts vertices between others, to a fifth
                    // of the separation.
                    const bool between = kind == SurfaceKind::Streak && accuracy != Accuracy::Exact;
                    EXPECT_LT(largest_error(*surface, tide, rake, sweep),
                              between ? 0.2 * p.separation : 1e-6);
                }
        }
}

TEST(SlackWater, RowsOfAStreakThatStartsFromRestLieAsCloseAsThoseOfASteadyOne) {
    const Rake rake{.points = {{0.2, 0.6, 0.4}, {0.2, 1.2, 0.7}}, .seeds = 5};
    const Tide& tide = tides()[1];
    const auto flow = stored(tide, Stored::Uniform);
    const SurfaceParameters p{.kind = SurfaceKind::Streak,
                              .from = tide.from,
                              .to = tide.to,
                              .separation = 0.02,
                              .refine = Refine::Off};
    const auto surface = build_surface(*flow, rake, p);
    ASSERT_TRUE(surface) << surface.error().message;
    EXPECT_LT(surface->statistics.max_edge, 3.0 * std::max(p.separation, 0.67 / 4.0));
}

TEST(SlackWater, BeforeTheFluidMovesThereIsNothingYet) {
    const Rake rake{.points = {{0.7, 0.6, 0.4}, {0.7, 1.2, 0.7}}, .seeds = 5};
    const std::shared_ptr<const Flow> flow = stored(tides()[4], Stored::Uniform);
    const SurfaceParameters p{.kind = SurfaceKind::Streak, .to = 29.0, .separation = 0.2};
    const auto shown = surface_at(plan_surface(flow, rake, p).value(), 20.0, SteadyClock{}, {});
    ASSERT_TRUE(shown) << shown.error().message;
    ASSERT_TRUE(shown->statistics.empty);
    EXPECT_EQ(shown->statistics.empty->reason, Emptiness::Reason::NothingYet)
        << shown->statistics.empty->message;
}

TEST(SlackWater, FluidThatNeverMovesAlongTheRakeIsRefusedInWords) {
    const Tide still{"never", every(1.0, 3), [](double) { return 0.0; }, 0, 3};
    const Rake rake{.points = {{0.2, 0.6, 0.4}, {0.2, 1.2, 0.7}}, .seeds = 5};
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        const SurfaceParameters p{.kind = kind, .to = 3.0, .separation = 0.2};
        const auto surface = build_surface(*stored(still, Stored::Uniform), rake, p);
        ASSERT_TRUE(surface) << surface.error().message;
        ASSERT_TRUE(surface->statistics.empty);
        EXPECT_EQ(surface->statistics.empty->reason, Emptiness::Reason::AtRest);
    }
}

} // namespace wakesurf::core::slack_water_test
