// What the accuracy `fast` is worth: as few quads as balanced, for less work.

#include "tests/support/surfaces_anywhere.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace wakesurf::core::fast_surface_test {

namespace {

using namespace tests;

/// Nothing: not even a coarse one fits the quad budget.
std::optional<SurfaceStatistics> built(AskedSurface& asked, Accuracy accuracy) {
    asked.parameters.accuracy = accuracy;
    const auto surface = asked.built();
    if (surface)
        return surface->statistics;
    EXPECT_EQ(surface.error().code, Error::Code::OverLimit) << surface.error().message;
    return std::nullopt;
}

} // namespace

TEST(FastSurface, NeedsAtMostAThirdMoreQuadsThanBalancedAndThreeQuartersOfItsStepsInEveryFlow) {
    std::mt19937 random(16);
    int compared = 0;
    for (const AnalyticEntry& entry : analytic_entries())
        for (const SurfaceKind kind : {SurfaceKind::Streak, SurfaceKind::Time}) {
            AskedSurface asked = surface_anywhere(entry, kind, 0.15, random);
            asked.parameters.max_quads = 10'000;
            const auto balanced = built(asked, Accuracy::Balanced);
            const auto fast = built(asked, Accuracy::Fast);
            if (!balanced || balanced->coarsened())
                continue;
            ++compared;
            ASSERT_TRUE(fast) << entry.name;
            EXPECT_LE(static_cast<double>(fast->quads), 1.3 * static_cast<double>(balanced->quads))
                << entry.name << ' ' << static_cast<int>(kind);
            EXPECT_LE(static_cast<double>(fast->vertex_steps),
                      0.75 * static_cast<double>(balanced->vertex_steps))
                << entry.name << ' ' << static_cast<int>(kind);
        }
    EXPECT_GE(compared, 24);
}

/// Where webs were cut without end, and the trials of coarser surfaces traced nothing again, none of any
/// separation fitted.
TEST(FastSurface, KeepsASmallQuadBudgetWhereTheFlowRollsItUp) {
    const auto flow = make_analytic_flow("lamb-oseen");
    for (const std::uint64_t most : {500u, 2000u}) {
        SurfaceParameters p{.kind = SurfaceKind::Streak,
                            .to = 20.0,
                            .separation = 0.002,
                            .accuracy = Accuracy::Fast,
                            .max_quads = most};
        const Rake rake{Rake::Kind::Line, {{0.2, 0.0, -1.0}, {1.0, 0.0, -1.0}}, 16};
        const auto surface = build_surface(**flow, rake, p);
        ASSERT_TRUE(surface) << surface.error().message;
        EXPECT_LE(surface->statistics.quads, most);
        EXPECT_GE(surface->statistics.quads, most / 2);
    }
}

TEST(FastSurface, RolledUpSheetsHaveNoMoreQuadsThanBalancedOnes) {
    struct Case {
        const char* flow;
        Vec3 from, to;
        double until, separation;
    };

    // 11.5, 2.5 and 2.6 times the quads of balanced where cuts were on the chord, as each showed the fold
    // that it was to smooth.
    for (const Case& c : {Case{"hill", {-0.3, 0.0, -0.6}, {0.5, 0.0, -0.6}, 6.0, 0.1},
                          Case{"tornado", {0.3, 0.5, 0.1}, {0.7, 0.5, 0.6}, 4.0, 0.04},
                          Case{"lamb-oseen", {0.1, 0.0, -1.0}, {1.5, 0.0, -1.0}, 5.0, 0.15}}) {
        AskedSurface asked{*make_analytic_flow(c.flow), {Rake::Kind::Line, {c.from, c.to}, 16}, {}};
        asked.parameters.kind = SurfaceKind::Streak;
        asked.parameters.to = c.until;
        asked.parameters.separation = c.separation;
        const auto balanced = built(asked, Accuracy::Balanced);
        const auto fast = built(asked, Accuracy::Fast);
        ASSERT_TRUE(balanced && fast) << c.flow;
        EXPECT_GT(balanced->quads, 500u) << c.flow;
        EXPECT_LE(static_cast<double>(fast->quads), 1.1 * static_cast<double>(balanced->quads))
            << c.flow;
    }
}

} // namespace wakesurf::core::fast_surface_test
