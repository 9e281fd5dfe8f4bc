// The cells of streak and time surfaces are well shaped, in flows and from rakes that no one chose for it.
#include "tests/support/moving_runs.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <gtest/gtest.h>

#include <array>

namespace wakesurf::core::moving_shape_test {

namespace {

using namespace tests;

/// Of the cells' shapes.
struct Limits {
    double slivers = 0.02, angle5 = 10.0, median = 40.0;
};

/// A sheet that the flow crushes to a filament and folds has cells as narrow as it is.
constexpr Limits crushed{0.2, 2.5, 25.0};
constexpr std::size_t least_quads = 150; ///< fewer say nothing of shares

void expect_well_shaped(const MovingRun& request, const Limits& limits = {}) {
    SCOPED_TRACE(request.name);
    const MeshShape shape = final_shape(request);
    // A body pierces a patch, once.
    const bool pierced = request.flow->obstacle() && request.parameters.kind == SurfaceKind::Time;
    EXPECT_LE(shape.holes(), pierced ? 1 : 0) << shape;
    if (shape.quads < least_quads)
        return;
    EXPECT_TRUE(shape.slivers <= limits.slivers && shape.angle5 >= limits.angle5 &&
                shape.median >= limits.median && shape.specks == 0)
        << shape;
}

MovingRun made(const char* flow, const Rake& rake, const SurfaceParameters& p) {
    return {*make_analytic_flow(flow), rake, p, flow};
}

/// The sine of the angle between what spans the sheet: a rake nearly along the flow, or along its own sweep,
/// makes cells that are thin from the start.
double opening(const AskedSurface& asked) {
    const Vec3 along = asked.rake.points[1] - asked.rake.points[0];
    const Vec3 middle = asked.rake.points[0] + 0.5 * along;
    const double time = 0.0;
    Vec3 across;
    (void)asked.flow->sample({&middle, 1}, {&time, 1}, {&across, 1}, {});
    across = asked.parameters.sweep.value_or(across);
    return glm::length(glm::cross(along, across)) / (glm::length(along) * glm::length(across));
}

/// One surface of every flow that is not too large.
void expect_well_shaped_anywhere(SurfaceKind kind, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (const AnalyticEntry& entry : analytic_entries()) {
        AskedSurface asked = surface_anywhere(entry, kind, 0.12, random);
        while (!(opening(asked) > 0.8))
            asked = surface_anywhere(entry, kind, 0.12, random);
        asked.parameters.to = std::min(asked.parameters.to, 3.0);
        asked.parameters.max_quads = 6'000;
        const SteadyClock clock;
        if (!MovingSurface::start(plan_surface(*asked.flow, asked.rake, asked.parameters).value(),
                                  {}, clock))
            continue; // not even a coarse one fits the budget
        expect_well_shaped(
            {std::move(asked.flow), asked.rake, asked.parameters, std::string(entry.name)},
            entry.name == "hill" && kind == SurfaceKind::Time ? crushed : Limits{});
    }
}

} // namespace

TEST(MovingShape, StreakSurfacesFromRandomRakesHaveFewSliversInEveryFlow) {
    expect_well_shaped_anywhere(SurfaceKind::Streak, 5);
}

TEST(MovingShape, StreakSurfacesFromOtherRandomRakesHaveFewSliversInEveryFlow) {
    expect_well_shaped_anywhere(SurfaceKind::Streak, 2);
}

TEST(MovingShape, TimeSurfacesFromRandomRakesHaveFewSliversInEveryFlow) {
    expect_well_shaped_anywhere(SurfaceKind::Time, 1);
}

TEST(MovingShape, TimeSurfacesFromOtherRandomRakesHaveFewSliversInEveryFlow) {
    expect_well_shaped_anywhere(SurfaceKind::Time, 4);
}

TEST(MovingShape, AFoldedStreakHasFewSlivers) {
    expect_well_shaped(made("abc?C=1", line_rake({0, 0, 0}, {2, 0.3, 1}), streak(6, 0.15)));
    expect_well_shaped(made("abc?C=0.6", line_rake({0, 0, 0}, {0, 2, 0}), streak(6, 0.15)));
}

TEST(MovingShape, StreaksRoundBodiesHaveFewSlivers) {
    expect_well_shaped(made("sphere", line_rake({-2, -1, 0}, {-2, 1, 0}), streak(7, 0.1)));
    expect_well_shaped(made("cylinder", line_rake({-2, -0.6, -1}, {-2, 0.6, 1}), streak(6, 0.1)));
}

TEST(MovingShape, RolledUpStreaksHaveFewSlivers) {
    expect_well_shaped(made("lamb-oseen", line_rake({0.3, 0, -5}, {1.5, 0, -5}), streak(2, 0.06)));
    expect_well_shaped(
        made("double-gyre", line_rake({0.2, 0.5, 0}, {1.8, 0.5, 0}), streak(8, 0.06)));
    expect_well_shaped(
        made("tornado", line_rake({0.3, 0.5, 0.1}, {0.7, 0.5, 0.6}), streak(3, 0.06)));
}

TEST(MovingShape, FoldedTimeSurfacesHaveFewSlivers) {
    expect_well_shaped(
        made("double-gyre", line_rake({0.2, 0.3, 0}, {1.8, 0.3, 0}), swept({0, 0.4, 0}, 5, 0.04)),
        {0.045}); // between x = 0.4 and 1.8 it is a filament: one row, narrower than a twentieth of its cells' length
    expect_well_shaped(made("abc", line_rake({-1, 0, 0}, {1, 0, 0.5}), swept({0, 1, 1}, 4, 0.15)));
    expect_well_shaped(
        made("abc?C=1", line_rake({-1, 0, 0}, {1, 0, 0.5}), swept({0, 1, 1}, 3, 0.15)));
    expect_well_shaped(made("tornado", line_rake({0.3, 0.4, 0.2}, {0.7, 0.4, 0.3}),
                            swept({0, 0.2, 0.2}, 1, 0.04)));
}

/// A cell that is thin beside one that is thin as well, across the same side, could have been joined with it.
TEST(MovingShape, NoTwoThinCellsLieSideBySide) {
    for (const MovingRun& asked :
         {made("abc?C=1", line_rake({0, 0, 0}, {2, 0.3, 1}), streak(6, 0.15)),
          made("abc?C=1", line_rake({-1, 0, 0}, {1, 0, 0.5}), swept({0, 1, 1}, 3, 0.15)),
          made("double-gyre", line_rake({0.2, 0.3, 0}, {1.8, 0.3, 0}),
               swept({0, 0.4, 0}, 4.5, 0.04))}) {
        follow(asked, 2, [&](const MovingSurface&, const KeyedMesh& shown) {
            const double thin = 0.05 * asked.parameters.separation;
            const DirectedEdges edges(shown.mesh);
            std::vector<double> width;
            for (const Cell& cell : shown.mesh.cells)
                width.push_back(narrowest_width(CellOutline(shown.mesh, cell)));
            std::size_t pairs = 0;
            for (const auto& edge : edges.all())
                if (const auto* back = edges.find(edge.to, edge.from)) {
                    const double length =
                        glm::length(shown.mesh.position[edge.to] - shown.mesh.position[edge.from]);
                    pairs += edge.from < edge.to && length > 2.0 * thin &&
                             width[edge.cell] < thin && width[back->cell] < thin;
                }
            // Where the sheet is folded more narrowly than that a few are left.
            EXPECT_LE(static_cast<double>(pairs), 0.03 * static_cast<double>(width.size()))
                << asked.name << ", " << shown.mesh.cells.size() << " quads at " << shown.time;
        });
    }
}

} // namespace wakesurf::core::moving_shape_test
