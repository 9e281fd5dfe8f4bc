// What is downloaded is what is shown: the mesh of each kind at a time of the clock, against the code behind live surfaces.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/growing_mesh.hpp"
#include "core/surface/playback/played_surface.hpp"
#include "core/surface/playback/surface_at.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::surface_at_test {

namespace {

struct Job {
    std::shared_ptr<const Flow> flow;
    Rake rake;
    SurfaceParameters parameters;
};

Job job_of(SurfaceKind kind) {
    Job job;
    job.rake = {Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    job.parameters.kind = kind;
    job.parameters.from = 1.0;
    job.parameters.to = 3.0;
    job.parameters.separation = 0.3;
    job.flow = *make_analytic_flow("double-gyre");
    job.rake.points = {{0.5, 0.2, 0}, {0.5, 0.8, 0}};
    job.parameters.separation = 0.05;
    return job;
}

SurfaceAt made(const Job& job, std::optional<double> time) {
    auto out = surface_at(plan_surface(*job.flow, job.rake, job.parameters).value(), time,
                          SteadyClock{}, {});
    EXPECT_TRUE(out) << (out ? "" : out.error().message);
    return out.value_or(SurfaceAt{});
}

} // namespace

TEST(SurfaceAt, OfAPathSurfaceIsWhatHasGrownUntilThen) {
    const Job job = job_of(SurfaceKind::Path);
    const auto whole = build_surface(*job.flow, job.rake, job.parameters);
    ASSERT_TRUE(whole);
    const auto expected = GrowingMesh(whole->mesh, 2.0).at(0.75).mesh;
    const SurfaceAt then = made(job, 1.75);
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

TEST(SurfaceAt, OfAStreakSurfaceIsWhatIsPlayedThen) {
    const Job job = job_of(SurfaceKind::Streak);
    const SteadyClock clock;
    auto played = PlayedSurface::start(plan_surface(*job.flow, job.rake, job.parameters).value(),
                                       1U << 26, clock, {});
    ASSERT_TRUE(played);
    for (const double time : {1.0, 1.4, 2.9}) {
        const auto expected = played->at(time - 1.0, {});
        ASSERT_TRUE(expected);
        const SurfaceAt then = made(job, time);
        EXPECT_EQ(then.mesh.position, expected->mesh.mesh.position);
        EXPECT_EQ(then.mesh.cells, expected->mesh.mesh.cells);
        for (const double each : then.times)
            EXPECT_EQ(each, time);
    }
}

TEST(SurfaceAt, WithoutATimeIsTheWholeSurface) {
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        const Job job = job_of(kind);
        const auto whole = build_surface(*job.flow, job.rake, job.parameters);
        ASSERT_TRUE(whole);
        EXPECT_EQ(made(job, std::nullopt).mesh.position, whole->mesh.position);
    }
}

TEST(SurfaceAt, OfAStreamSurfaceIsTheSameAtAllTimes) {
    const Job job = job_of(SurfaceKind::Stream);
    EXPECT_EQ(made(job, 1.2).mesh.position, made(job, std::nullopt).mesh.position);
}

} // namespace wakesurf::core::surface_at_test
