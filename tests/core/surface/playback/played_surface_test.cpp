#include "core/base/clock.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/played_surface.hpp"
#include "tests/support/mesh_hash.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::played_surface_test {

namespace {

using tests::hash;

struct Streak {
    std::shared_ptr<const Flow> flow;
    Rake rake;
    SurfaceParameters parameters;
};

/// Until 2 after the release at 0, or before it.
Streak streak(double to) {
    Streak job;
    job.rake = {Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    job.parameters.kind = SurfaceKind::Streak;
    job.parameters.to = to;
    job.parameters.separation = 0.3;
    job.flow = *make_analytic_flow("abc");
    return job;
}

} // namespace

TEST(PlayedSurface, ShowsAtItsEndWhatTheBuilderGives) {
    const SteadyClock clock;
    for (const double to : {2.0, -2.0}) {
        const Streak job = streak(to);
        const auto built = value_of(build_surface(*job.flow, job.rake, job.parameters));
        auto played = value_of(PlayedSurface::start(
            plan_surface(*job.flow, job.rake, job.parameters).value(), 1U << 26, clock, {}));
        ASSERT_TRUE(played.at(0.7, {}));
        const auto shown = value_of(played.at(2.0, {}));
        EXPECT_EQ(shown.mesh.mesh.position, built.mesh.position);
        EXPECT_EQ(shown.mesh.mesh.cells, built.mesh.cells);
        EXPECT_EQ(shown.time, to);
        EXPECT_EQ(shown.statistics.quads, built.statistics.quads);
        EXPECT_EQ(shown.statistics.max_edge, built.statistics.max_edge);
        EXPECT_TRUE(std::is_sorted(shown.mesh.vertex_id.begin(), shown.mesh.vertex_id.end()));
    }
}

TEST(PlayedSurface, ShowsTheSameAtATimeWhateverWasShownBefore) {
    const SteadyClock clock;
    const Streak job = streak(-2.0);
    auto one = *PlayedSurface::start(plan_surface(*job.flow, job.rake, job.parameters).value(),
                                     1U << 26, clock, {});
    auto other = *PlayedSurface::start(plan_surface(*job.flow, job.rake, job.parameters).value(),
                                       1U << 26, clock, {});
    const auto straight = one.at(0.9, {});
    for (const double age : {1.9, 0.2, 0.0, 1.1})
        ASSERT_TRUE(other.at(age, {}));
    const auto roundabout = other.at(0.9, {});
    EXPECT_EQ(hash(straight->mesh), hash(roundabout->mesh));
    EXPECT_EQ(straight->mesh.vertex_id, roundabout->mesh.vertex_id);
}

} // namespace wakesurf::core::played_surface_test
