// What is downloaded is what is shown: the mesh of each kind at a time of the clock, against the code behind live surfaces.
#include "core/field/analytic_flow.hpp"
#include "core/surface/surface_builder.hpp"
#include "server/session/growing_mesh.hpp"
#include "server/session/played_surface.hpp"
#include "server/session/surface_mesh.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

namespace {

SurfaceJob job_of(core::SurfaceKind kind) {
    SurfaceJob job;
    job.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    job.parameters.kind = kind;
    job.parameters.from = 1.0;
    job.parameters.to = 3.0;
    job.parameters.separation = 0.3;
    job.flow = *core::make_analytic_flow("double-gyre");
    job.rake.points = {{0.5, 0.2, 0}, {0.5, 0.8, 0}};
    job.parameters.separation = 0.05;
    return job;
}

SurfaceMesh made(const SurfaceJob& job, std::optional<double> time) {
    auto out = surface_mesh(job, time, core::SteadyClock{}, {});
    EXPECT_TRUE(out) << (out ? "" : out.error().message);
    return out.value_or(SurfaceMesh{});
}

} // namespace

TEST(SurfaceMesh, OfAPathSurfaceIsWhatHasGrownUntilThen) {
    const SurfaceJob job = job_of(core::SurfaceKind::Path);
    const auto whole = core::build_surface(*job.flow, job.rake, job.parameters);
    ASSERT_TRUE(whole);
    const auto expected = GrowingMesh(whole->mesh, 2.0).at(0.75).mesh;
    const SurfaceMesh then = made(job, 1.75);
    EXPECT_EQ(then.mesh.position, expected.position);
    EXPECT_EQ(then.mesh.cells, expected.cells);
    EXPECT_EQ(then.statistics.quads, expected.cells.size());
    ASSERT_LT(then.mesh.vertices(), whole->mesh.vertices());
    ASSERT_EQ(then.times.size(), then.mesh.vertices());
    for (std::size_t v = 0; v < then.times.size(); ++v) {
        EXPECT_EQ(then.times[v], 1.0 + then.mesh.t[v]);
        EXPECT_LE(then.times[v], 1.75 + 1e-12);
    }
}

TEST(SurfaceMesh, OfAStreakSurfaceIsWhatIsPlayedThen) {
    const SurfaceJob job = job_of(core::SurfaceKind::Streak);
    auto played = PlayedSurface::start(job, 1U << 26, core::SteadyClock{}, {});
    ASSERT_TRUE(played);
    for (const double time : {1.0, 1.4, 2.9}) {
        const auto expected = played->at(time - 1.0, {});
        ASSERT_TRUE(expected);
        const SurfaceMesh then = made(job, time);
        EXPECT_EQ(then.mesh.position, expected->mesh.mesh.position);
        EXPECT_EQ(then.mesh.cells, expected->mesh.mesh.cells);
        EXPECT_EQ(then.times, expected->times());
    }
}

TEST(SurfaceMesh, WithoutATimeIsTheWholeSurface) {
    for (const auto kind :
         {core::SurfaceKind::Stream, core::SurfaceKind::Path, core::SurfaceKind::Streak}) {
        const SurfaceJob job = job_of(kind);
        const auto whole = core::build_surface(*job.flow, job.rake, job.parameters);
        ASSERT_TRUE(whole);
        EXPECT_EQ(made(job, std::nullopt).mesh.position, whole->mesh.position);
    }
}

TEST(SurfaceMesh, OfAStreamSurfaceIsTheSameAtAllTimes) {
    const SurfaceJob job = job_of(core::SurfaceKind::Stream);
    EXPECT_EQ(made(job, 1.2).mesh.position, made(job, std::nullopt).mesh.position);
}

} // namespace wakesurf::server
