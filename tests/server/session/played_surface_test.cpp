#include "core/base/clock.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/surface_builder.hpp"
#include "server/session/played_surface.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

namespace {

SurfaceJob streak(core::Direction direction) {
    SurfaceJob job;
    job.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    job.parameters.kind = core::SurfaceKind::Streak;
    job.parameters.to = 2.0;
    job.parameters.direction = direction;
    job.parameters.separation = 0.3;
    job.flow = *core::make_analytic_flow("abc");
    return job;
}

} // namespace

TEST(PlayedSurface, ShowsAtItsEndWhatTheBuilderGives) {
    const core::SteadyClock clock;
    for (const auto direction :
         {core::Direction::Forward, core::Direction::Backward, core::Direction::Both}) {
        const SurfaceJob job = streak(direction);
        const auto built = core::build_surface(*job.flow, job.rake, job.parameters);
        ASSERT_TRUE(built) << built.error().message;
        auto played = PlayedSurface::start(job, 1U << 26, clock, {});
        ASSERT_TRUE(played) << played.error().message;
        ASSERT_TRUE(played->at(0.7, {}));
        const auto shown = played->at(2.0, {});
        ASSERT_TRUE(shown) << shown.error().message;
        EXPECT_EQ(shown->mesh.mesh.position, built->mesh.position);
        EXPECT_EQ(shown->mesh.mesh.cells, built->mesh.cells);
        EXPECT_EQ(shown->statistics.quads, built->statistics.quads);
        EXPECT_EQ(shown->statistics.max_edge, built->statistics.max_edge);
        EXPECT_TRUE(std::is_sorted(shown->mesh.vertex_id.begin(), shown->mesh.vertex_id.end()));
    }
}

TEST(PlayedSurface, ShowsTheSameAtATimeWhateverWasShownBefore) {
    const core::SteadyClock clock;
    const SurfaceJob job = streak(core::Direction::Both);
    auto one = *PlayedSurface::start(job, 1U << 26, clock, {});
    auto other = *PlayedSurface::start(job, 1U << 26, clock, {});
    const auto straight = one.at(0.9, {});
    for (const double age : {1.9, 0.2, 0.0, 1.1})
        ASSERT_TRUE(other.at(age, {}));
    const auto roundabout = other.at(0.9, {});
    EXPECT_EQ(core::hash(straight->mesh), core::hash(roundabout->mesh));
    EXPECT_EQ(straight->mesh.vertex_id, roundabout->mesh.vertex_id);
}

} // namespace wakesurf::server
