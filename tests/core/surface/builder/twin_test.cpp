// Twins of surfaces in flows in which each particle's way is known.
#include "core/field/function_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/builder/twin.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::core::twin_test {

namespace {

constexpr double end = 4.0;

std::shared_ptr<const Flow>
stored(double speed, double last = end, const Box& domain = {{-4, -4, -4}, {12, 4, 4}}) {
    UniformGrid grid;
    grid.origin = domain.lo;
    grid.spacing = Vec3(1.0);
    grid.dimensions = {static_cast<int>(domain.extent().x) + 1,
                       static_cast<int>(domain.extent().y) + 1,
                       static_cast<int>(domain.extent().z) + 1};
    std::vector<double> times;
    for (double t = 0.0; t <= last; t += 0.5)
        times.push_back(t);
    auto source = std::make_shared<tests::SampledSource>(
        std::move(grid), std::move(times),
        [speed](const Vec3&, double) { return Vec3(speed, 0.0, 0.0); });
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::move(source), TimeStepCache::Options{}));
}

SurfacePlan plan(std::shared_ptr<const Flow> flow, SurfaceKind kind, const Rake& rake) {
    SurfaceParameters p;
    p.kind = kind;
    p.to = end;
    p.separation = 0.25;
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 0.0, 0.5);
    return value_of(plan_surface(std::move(flow), rake, p));
}

Rake line() {
    return {Rake::Kind::Line, {{0, -1, 0}, {0, 1, 0}}, 5};
}

/// How long the particle of a vertex has been on its way.
double age(SurfaceKind kind, double t) {
    return kind == SurfaceKind::Streak ? end - t : kind == SurfaceKind::Time ? end : t;
}

class TwinsOfAllKinds : public testing::TestWithParam<SurfaceKind> {};

TEST_P(TwinsOfAllKinds, are_apart_by_what_their_flows_differ_and_late_by_the_time_that_takes) {
    const SurfacePlan base = plan(stored(1.0), GetParam(), line());
    const SurfacePlan slower = value_of(plan_twin(base, stored(0.75), {}));
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found = value_of(compare_twin(base, surface, slower, {}));
    ASSERT_GT(surface.mesh.vertices(), 20U);
    for (VertexId v = 0; v < surface.mesh.vertices(); ++v) {
        const double apart = 0.25 * age(GetParam(), surface.mesh.t[v]);
        EXPECT_NEAR(found.distance[v], apart, 1e-4);
        EXPECT_NEAR(found.lag[v], apart, 1e-4); // at speed 1
    }
    EXPECT_EQ(found.stated.all.compared, 1.0);
    EXPECT_NEAR(found.stated.all.age, end, 1e-9);
    EXPECT_NEAR(found.stated.ages.back().p99, 0.25 * end, 0.01);
}

TEST_P(TwinsOfAllKinds, of_a_moved_rake_are_apart_by_the_offset) {
    const auto flow = stored(1.0);
    const SurfacePlan base = plan(flow, GetParam(), line());
    const SurfacePlan moved = value_of(plan_twin(base, flow, {.offset = Vec3(0.0, 0.0, -0.5)}));
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found = value_of(compare_twin(base, surface, moved, {}));
    for (VertexId v = 0; v < surface.mesh.vertices(); ++v) {
        EXPECT_NEAR(found.distance[v], 0.5, 1e-6);
        EXPECT_NEAR(found.lag[v], 0.0, 1e-6);
    }
}

TEST_P(TwinsOfAllKinds, of_the_same_flow_are_the_surface_itself) {
    const auto flow = stored(1.0);
    const SurfacePlan base = plan(flow, GetParam(), line());
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found =
        value_of(compare_twin(base, surface, value_of(plan_twin(base, flow, {})), {}));
    EXPECT_LT(found.stated.all.p99, 1e-5);
}

TEST_P(TwinsOfAllKinds, are_the_same_for_any_number_of_threads) {
    const SurfacePlan base = plan(stored(1.0), GetParam(), line());
    const SurfacePlan slower = value_of(plan_twin(base, stored(0.75), {}));
    const Surface surface = value_of(build_surface(base));
    std::vector<std::vector<float>> distances;
    for (const int threads : {1, 2, 4}) {
        tbb::task_arena arena(threads);
        arena.execute([&] {
            distances.push_back(value_of(compare_twin(base, surface, slower, {})).distance);
        });
    }
    EXPECT_EQ(distances[0], distances[1]);
    EXPECT_EQ(distances[0], distances[2]);
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         TwinsOfAllKinds,
                         testing::Values(SurfaceKind::Stream,
                                         SurfaceKind::Path,
                                         SurfaceKind::Streak,
                                         SurfaceKind::Time));

} // namespace

TEST(Twin, of_a_smaller_domain_is_compared_where_it_has_particles) {
    const SurfacePlan base = plan(stored(1.0), SurfaceKind::Path, line());
    const auto smaller = stored(0.75, end, {{-4, -4, -4}, {2, 4, 4}});
    const SurfacePlan twin = value_of(plan_twin(base, smaller, {}));
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found = value_of(compare_twin(base, surface, twin, {}));
    for (VertexId v = 0; v < surface.mesh.vertices(); ++v)
        EXPECT_EQ(std::isnan(found.distance[v]), 0.75 * surface.mesh.t[v] > 2.0 + 1e-9)
            << surface.mesh.t[v];
    EXPECT_NEAR(found.stated.all.compared, 2.0 / 3.0, 0.1);
    EXPECT_LT(found.stated.ages.back().age, 2.0 / 0.75 + 0.5);
}

TEST(Twin, whose_rake_is_partly_outside_keeps_the_partners_of_the_others) {
    const auto flow = stored(1.0);
    const SurfacePlan base = plan(flow, SurfaceKind::Streak, line());
    const SurfacePlan moved = value_of(plan_twin(base, flow, {.offset = Vec3(0.0, 4.0, 0.0)}));
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found = value_of(compare_twin(base, surface, moved, {}));
    for (VertexId v = 0; v < surface.mesh.vertices(); ++v)
        if (surface.mesh.position[v].y > 0.01) {
            EXPECT_TRUE(std::isnan(found.distance[v]));
        } else {
            EXPECT_NEAR(found.distance[v], 4.0, 1e-6);
        }
}

TEST(Twin, whose_data_end_earlier_is_compared_as_far_as_they_go) {
    const SurfacePlan base = plan(stored(1.0), SurfaceKind::Path, line());
    const SurfacePlan twin = value_of(plan_twin(base, stored(0.75, 2.0), {}));
    const Surface surface = value_of(build_surface(base));
    const TwinComparison found = value_of(compare_twin(base, surface, twin, {}));
    EXPECT_NEAR(found.stated.all.compared, 0.5, 0.1);
    EXPECT_NEAR(found.stated.ages.back().age, 2.0, 0.3);

    const SurfacePlan streak = plan(stored(1.0), SurfaceKind::Streak, line());
    const Surface shown = value_of(build_surface(streak));
    const auto refused =
        compare_twin(streak, shown, value_of(plan_twin(streak, stored(0.75, 2.0), {})), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the twin's data end at 2: they have no surface at the time that is shown");
}

TEST(Twin, is_refused_where_its_data_begin_later_or_its_rake_lies_outside) {
    const SurfacePlan base = plan(stored(1.0), SurfaceKind::Path, line());
    const auto outside = plan_twin(base, stored(1.0, end, {{4, -4, -4}, {12, 4, 4}}), {});
    ASSERT_FALSE(outside);
    EXPECT_TRUE(outside.error().message.starts_with("the twin: ")) << outside.error().message;
    EXPECT_FALSE(plan_twin(base, stored(1.0),
                           {.interpolation = Interpolation::Smooth, .between = Between::Flow}));
}

TEST(Twin, band_is_the_mean_of_the_runs_and_their_root_mean_square_distance_from_it) {
    const SurfacePlan base = plan(stored(1.0), SurfaceKind::Path, line());
    const Surface surface = value_of(build_surface(base));
    std::vector<TwinComparison> twins;
    for (const double speed : {0.9, 1.1})
        twins.push_back(value_of(
            compare_twin(base, surface, value_of(plan_twin(base, stored(speed), {})), {})));
    const TwinBand band = band_of(surface, twins);
    for (VertexId v = 0; v < surface.mesh.vertices(); ++v) {
        EXPECT_NEAR(glm::length(band.mean[v] - surface.mesh.position[v]), 0.0, 1e-4);
        EXPECT_NEAR(band.spread[v], 0.1 * surface.mesh.t[v] * std::sqrt(2.0 / 3.0), 1e-4);
        EXPECT_EQ(band.arrived[v], 3.0F);
    }
}

} // namespace wakesurf::core::twin_test
