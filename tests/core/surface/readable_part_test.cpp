// What becomes of a surface when a time-step in the middle of its series cannot be read.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/surface.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wakesurf::core::readable_part_test {
namespace {

using wakesurf::tests::SampledSource;

// Seven time-steps 0, 1, ... 6 of a uniform flow that takes 8 time units through the box.
struct Series {
    explicit Series(std::size_t broken, std::size_t budget = std::size_t{1} << 30) {
        source = std::make_shared<SampledSource>(UniformGrid{{0, 0, 0}, {1, 1, 1}, {9, 5, 5}},
                                                 std::vector<double>{0, 1, 2, 3, 4, 5, 6},
                                                 [](const Vec3&, double) { return Vec3(1, 0, 0); });
        source->broken = broken;
        flow = make_stored_flow(
            std::make_shared<TimeStepCache>(source, TimeStepCache::Options{budget, 1}));
    }

    std::shared_ptr<SampledSource> source;
    std::unique_ptr<Flow> flow;
};

Rake rake_at(double x) {
    return {Rake::Kind::Line, {{x, 1, 2}, {x, 3, 2}}, 5};
}

SurfaceParameters asked(SurfaceKind kind, double from, double to) {
    SurfaceParameters p{.kind = kind, .from = from, .to = to, .separation = 0.5};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0, 0, 1);
    return p;
}

double farthest(const Surface& surface) {
    double x = 0.0;
    for (const Vec3& p : surface.mesh.position)
        x = std::max(x, p.x);
    return x;
}

TEST(ReadablePart, SurfacesEndAtTheLastTimeStepThatCanBeReadAndSayWhy) {
    for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const Series series(4);
        const auto surface = value_of(build_surface(*series.flow, rake_at(0.5), asked(kind, 0, 6)));
        EXPECT_TRUE(holds(surface.statistics.stopped, "time-step 4"));
        EXPECT_NEAR(farthest(surface), 0.5 + 3.0, 1e-9) << static_cast<int>(kind);
        const auto times = vertex_times(surface, asked(kind, 0, 6));
        EXPECT_LE(*std::ranges::max_element(times), 3.0) << "fields are sampled no later";
        EXPECT_EQ(surface.mesh.validate(), "");
    }
}

TEST(ReadablePart, SurfacesThatDoNotNeedTheDamagedTimeStepAreWhole) {
    for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const Series series(5);
        const auto surface = value_of(build_surface(*series.flow, rake_at(0.5), asked(kind, 0, 4)));
        EXPECT_EQ(surface.statistics.stopped, "");
        EXPECT_NEAR(farthest(surface), 4.5, 1e-9);
    }
}

TEST(ReadablePart, BackwardSurfacesEndThereToo) {
    const Series series(2);
    const auto p = asked(SurfaceKind::Path, 6, 0);
    const auto surface = value_of(build_surface(*series.flow, rake_at(7), p));
    double nearest = 9.0;
    for (const Vec3& x : surface.mesh.position)
        nearest = std::min(nearest, x.x);
    EXPECT_NEAR(nearest, 7.0 - 3.0, 1e-9);
    for (const double time : vertex_times(surface, p))
        EXPECT_TRUE(time <= 6.0 && time >= 3.0) << time;
}

TEST(ReadablePart, TheReleaseOfABackwardSheetEndsThereAtTheLatest) {
    const Series series(2);
    auto p = asked(SurfaceKind::Streak, 6, 0);
    p.release_until = 1.0;
    const auto surface = value_of(build_surface(*series.flow, rake_at(7), p));
    EXPECT_EQ(surface.ended, 3.0);
    p.to = 3.0;
    p.release_until.reset();
    const auto whole = value_of(build_surface(*series.flow, rake_at(7), p));
    EXPECT_EQ(surface.mesh.position, whole.mesh.position);
}

TEST(ReadablePart, NothingIsBuiltWhereTheReleaseItselfCannotBeRead) {
    for (const double from : {2.0, 2.5, 1.5}) {
        const Series series(2);
        const auto surface =
            build_surface(*series.flow, rake_at(0.5), asked(SurfaceKind::Path, from, 6));
        ASSERT_FALSE(surface.has_value()) << from;
        EXPECT_EQ(surface.error().code, Error::Code::Corrupt);
    }
    const Series series(2);
    EXPECT_FALSE(
        build_surface(*series.flow, rake_at(0.5), asked(SurfaceKind::Stream, 2, 6)).has_value());
}

TEST(ReadablePart, TheWholeSurfaceComesOnceTheTimeStepCanBeRead) {
    const Series series(4);
    const auto p = asked(SurfaceKind::Path, 0, 6);
    ASSERT_NE(build_surface(*series.flow, rake_at(0.5), p)->statistics.stopped, "");
    series.source->broken = ~std::size_t{0};
    const auto surface = value_of(build_surface(*series.flow, rake_at(0.5), p));
    EXPECT_EQ(surface.statistics.stopped, "");
    EXPECT_NEAR(farthest(surface), 6.5, 1e-9);
}

} // namespace
} // namespace wakesurf::core::readable_part_test
