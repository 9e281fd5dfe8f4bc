#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace wakesurf::core::emptiness_test {

namespace {

using Reason = Emptiness::Reason;

Rake line(Vec3 a, Vec3 b) {
    return {Rake::Kind::Line, {a, b}, 16};
}

SurfaceParameters parameters(SurfaceKind kind) {
    SurfaceParameters p{.kind = kind, .to = 2.0, .separation = 0.2};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 0.1, 0.0);
    return p;
}

std::optional<Emptiness> empty(const char* flow, const Rake& rake, const SurfaceParameters& p) {
    const auto surface = build_surface(**make_analytic_flow(flow), rake, p);
    EXPECT_TRUE(surface) << flow << ": " << (surface ? "" : surface.error().message);
    return surface ? surface->statistics.empty : std::nullopt;
}

constexpr std::array kinds{SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                           SurfaceKind::Time};

} // namespace

TEST(Emptiness, NoReasonIsNamedWhereThereIsSomethingToSee) {
    for (const SurfaceKind kind : kinds)
        EXPECT_FALSE(empty("uniform", line({-5, -1, 0}, {-5, 1, 0.5}), parameters(kind)));
}

TEST(Emptiness, ARakeInsideTheBodySaysSo) {
    for (const SurfaceKind kind : kinds) {
        const auto why = empty("sphere", line({-0.1, 0, -0.1}, {0.1, 0, 0.1}), parameters(kind));
        ASSERT_TRUE(why);
        EXPECT_EQ(why->reason, Reason::InBody);
        EXPECT_EQ(why->message, "the whole rake lies inside the body");
        EXPECT_EQ(why->hint, "move the rake into the fluid");
    }
}

/// Between two steps that are kept as well.
TEST(Emptiness, ASurfaceThatIsPlayedSaysWhyItIsEmptyAtThatTime) {
    const auto flow = make_analytic_flow("uniform").value();
    const double end = flow->domain().hi.x;
    const auto plan = plan_surface(*flow, line({end - 0.05, 0, -1}, {end - 0.05, 0, 1}),
                                   parameters(SurfaceKind::Time))
                          .value();
    for (const double time : {0.07, 0.1, 0.9}) {
        const auto shown = surface_at(plan, time, SteadyClock{}, {});
        ASSERT_TRUE(shown) << shown.error().message;
        ASSERT_TRUE(shown->statistics.empty) << time;
        EXPECT_EQ(shown->statistics.empty->message, "all particles have left the domain") << time;
    }
}

TEST(Emptiness, FluidAtRestSaysSo) {
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        const auto why = empty("uniform?u=0", line({-5, -1, 0}, {-5, 1, 0}), parameters(kind));
        ASSERT_TRUE(why);
        EXPECT_EQ(why->reason, Reason::AtRest);
        EXPECT_EQ(why->message, "the fluid is at rest all along the rake");
    }
}

TEST(Emptiness, ARakeAlongTheFlowHasNoArea) {
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        const auto why = empty("uniform", line({-5, 0, 0}, {-4, 0, 0}), parameters(kind));
        ASSERT_TRUE(why);
        EXPECT_EQ(why->reason, Reason::NoArea);
        EXPECT_EQ(why->message, "the rake lies along the flow, so the surface has no area");
        EXPECT_EQ(why->hint, "turn the rake across the flow");
    }
}

TEST(Emptiness, TwoRakesThatAreTheSameSaySo) {
    SurfaceParameters p = parameters(SurfaceKind::Time);
    const Rake rake = line({-5, -1, 0}, {-5, 1, 0});
    p.sweep.reset();
    p.rake2 = rake;
    const auto why = empty("uniform", rake, p);
    ASSERT_TRUE(why);
    EXPECT_EQ(why->reason, Reason::SameRakes);
}

TEST(Emptiness, AnEmptySurfaceOfWhichEverythingHasLeftIsNoMistake) {
    SurfaceParameters p = parameters(SurfaceKind::Time);
    p.to = 100.0;
    p.sweep = Vec3(0.0, 0.0, 0.5);
    const auto why = empty("uniform", line({-5, -1, 0}, {-5, 1, 0}), p);
    ASSERT_TRUE(why);
    EXPECT_EQ(why->reason, Reason::AllLeft);
    EXPECT_TRUE(why->natural());
}

TEST(Emptiness, ASlightlyTiltedRakeIsNoLine) {
    EXPECT_FALSE(
        empty("uniform", line({-5, 0, 0}, {-4, 0.05, 0}), parameters(SurfaceKind::Stream)));
}

} // namespace wakesurf::core::emptiness_test
