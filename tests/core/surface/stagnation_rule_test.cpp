// SurfaceParameters::stagnation_speed: one rule for what counts as at rest, in all four kinds of surface.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::stagnation_rule_test {

namespace {

/// Particles fall towards the stagnation point from above it, ever slower: at x = 1e-3, after a time of 1, at 0.54; the fastest of the
/// domain have 12.2.
std::uint64_t at_rest(SurfaceKind kind, double stagnation_speed) {
    SurfaceParameters p{
        .kind = kind, .to = 2.0, .separation = 0.05, .stagnation_speed = stagnation_speed};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 1e-3, 0.0);
    Rake rake{
        .kind = Rake::Kind::Line, .points = {{-1e-3, 0.0, 2.0}, {1e-3, 0.0, 2.0}}, .seeds = 5};
    const auto surface = build_surface(**make_analytic_flow("stagnation"), rake, p);
    EXPECT_TRUE(surface) << surface.error().message;
    return surface->statistics.terminated.stagnation;
}

} // namespace

TEST(StagnationRule, IsTheSameForEveryKindOfSurface) {
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        EXPECT_GT(at_rest(kind, 0.05), 0U) << static_cast<int>(kind);
        EXPECT_EQ(at_rest(kind, 1e-4), 0U) << static_cast<int>(kind);
        EXPECT_EQ(at_rest(kind, SurfaceParameters{}.stagnation_speed), 0U)
            << static_cast<int>(kind);
    }
}

TEST(StagnationRule, RefusesAPartOfTheLargestSpeedThatIsNone) {
    SurfaceParameters p{.to = 1.0, .separation = 0.1};
    Rake rake{.points = {{0.0, 0.0, 2.0}, {1.0, 0.0, 2.0}}, .seeds = 5};
    for (const double wrong : {-0.1, 0.2, std::nan("")}) {
        p.stagnation_speed = wrong;
        EXPECT_FALSE(build_surface(**make_analytic_flow("stagnation"), rake, p)) << wrong;
    }
}

} // namespace wakesurf::core::stagnation_rule_test
