// A mesh that need not change does not: ids last, and a sheet that nothing deforms stays the grid it was
// released as.
#include "core/field/analytic_flow.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::steady_mesh_test {

namespace {

using namespace tests;

MovingRun made(const char* flow, const Rake& rake, const SurfaceParameters& p) {
    return {*make_analytic_flow(flow), rake, p, flow};
}

/// Cells born since the step before, but those beside a row that was released since.
std::size_t born_beyond_release(const KeyedMesh& before, const KeyedMesh& now) {
    std::vector<std::uint32_t> fresh;
    std::set_difference(now.cell_id.begin(), now.cell_id.end(), before.cell_id.begin(),
                        before.cell_id.end(), std::back_inserter(fresh));
    std::size_t beyond = 0;
    for (std::size_t c = 0; c < now.cell_id.size(); ++c) {
        if (!std::binary_search(fresh.begin(), fresh.end(), now.cell_id[c]))
            continue;
        const auto& corner = now.mesh.cells[c].corner;
        beyond +=
            std::ranges::none_of(corner, [&](VertexId v) { return now.mesh.t[v] > before.time; });
    }
    return beyond;
}

/// The mean share of cells that are born in a step after the time `constant` for another reason than the
/// release.
double share_born(const MovingRun& asked, double constant) {
    KeyedMesh before;
    double born = 0.0, cells = 0.0;
    std::size_t steps = 0;
    follow(asked, 0, [&](const MovingSurface& surface, const KeyedMesh& shown) {
        if (surface.time() > constant && !before.cell_id.empty()) {
            born += static_cast<double>(born_beyond_release(before, shown));
            cells += static_cast<double>(shown.mesh.cells.size());
            ++steps;
        }
        before = shown;
    });
    EXPECT_GT(steps, 8u) << asked.name;
    EXPECT_GT(cells, 300.0 * static_cast<double>(steps)) << asked.name;
    return born / std::max(cells, 1.0);
}

/// Of quads that lie in rows and columns as they were laid: each a parallelogram without a hanging node.
void expect_plain_grid(const KeyedMesh& shown, double tolerance) {
    std::size_t hanging = 0, bent = 0;
    for (const Cell& cell : shown.mesh.cells) {
        for (const VertexId v : cell.mid)
            hanging += v != no_vertex;
        const auto& p = shown.mesh.position;
        const Vec3 off =
            p[cell.corner[0]] + p[cell.corner[2]] - p[cell.corner[1]] - p[cell.corner[3]];
        bent += glm::length(off) > tolerance;
    }
    EXPECT_EQ(hanging, 0u) << "of " << shown.mesh.cells.size() << " at " << shown.time;
    EXPECT_EQ(bent, 0u) << "of " << shown.mesh.cells.size() << " at " << shown.time;
}

} // namespace

TEST(SteadyMesh, CellsOfAStreakOfConstantSizeLast) {
    struct Case {
        MovingRun run;
        double constant;
    };

    for (const Case& each : {
             Case{made("uniform", line_rake({0, -1, 0}, {0, 1, 0.3}), streak(13, 0.1)), 10.5},
             Case{made("cylinder", line_rake({-2, 0.3, -1}, {-2, 1.6, -0.7}), streak(17, 0.2)), 14},
             Case{made("sphere", line_rake({-2, 0.3, -0.5}, {-2, 0.5, 0.9}), streak(17, 0.2)),
                  14.5},
         })
        EXPECT_LE(share_born(each.run, each.constant), 0.04) << each.run.name;
}

TEST(SteadyMesh, CellsOfATimeSurfaceThatOnlyMovesLastForEver) {
    for (const MovingRun& asked :
         {made("uniform?u=1,v=0.4", line_rake({-9, -1, 0}, {-9, 1, 0.3}), swept({0, 1, 2}, 8, 0.1)),
          made("rotation", line_rake({1, -1, -3}, {3, 1, -3}), swept({1, 0, 2}, 8, 0.15)),
          made("oscillating", line_rake({-5, -1, 0}, {-5, 1, 1}), swept({1, 0, 1}, 6, 0.1))}) {
        std::vector<std::uint32_t> first;
        std::size_t changed = 0;
        follow(asked, 20, [&](const MovingSurface&, const KeyedMesh& shown) {
            if (first.empty())
                first = shown.cell_id;
            changed += shown.cell_id != first;
        });
        EXPECT_EQ(changed, 0u) << "of 20 looks at " << asked.name;
        EXPECT_GT(first.size(), 200u) << asked.name;
    }
}

TEST(SteadyMesh, ASheetOfAUniformFlowIsThePlainGridItWasReleasedAs) {
    // Across the flow, slanted to it, and a patch.
    for (const MovingRun& asked :
         {made("uniform", line_rake({-9, -1, 0}, {-9, 1, 0}), streak(12, 0.1)),
          made("uniform?u=1,v=0.3,w=0.1", line_rake({-9, -1, 0}, {-8.5, 1, 0.4}), streak(9, 0.15)),
          made("uniform", line_rake({-9, -1, 0}, {-9, 1, 0}), swept({0.3, 0, 2}, 9, 0.1))})
        follow(asked, 6, [&](const MovingSurface&, const KeyedMesh& shown) {
            expect_plain_grid(shown, 1e-9);
        });
}

TEST(SteadyMesh, ASheetThatTurnsAsAWholeStaysThePlainGridItWasLaidAs) {
    const MovingRun asked =
        made("rotation", line_rake({1, -1, -3}, {3, 1, -3}), swept({1, 0, 2}, 6, 0.15));
    follow(asked, 6, [&](const MovingSurface&, const KeyedMesh& shown) {
        expect_plain_grid(shown, 1e-3 * asked.parameters.separation);
    });
}

/// Ids are of the same cells for as long as they are there: a cell's corners do not change under its id in a
/// sheet that nothing deforms.
TEST(SteadyMesh, AnIdStaysWithItsCell) {
    const MovingRun asked = made("uniform", line_rake({-9, -1, 0}, {-9, 1, 0}), streak(9, 0.1));
    KeyedMesh before;
    std::size_t kept = 0, changed = 0;
    follow(asked, 0, [&](const MovingSurface&, const KeyedMesh& shown) {
        for (std::size_t c = 0; c < before.cell_id.size(); ++c) {
            const auto at = std::ranges::lower_bound(shown.cell_id, before.cell_id[c]);
            if (at == shown.cell_id.end() || *at != before.cell_id[c])
                continue;
            ++kept;
            const Cell& now =
                shown.mesh.cells[static_cast<std::size_t>(at - shown.cell_id.begin())];
            for (std::size_t k = 0; k < 4; ++k) {
                const VertexId was = before.mesh.cells[c].corner[k];
                changed += shown.vertex_id[now.corner[k]] != before.vertex_id[was];
            }
        }
        before = shown;
    });
    EXPECT_EQ(changed, 0u);
    EXPECT_GT(kept, 10'000u);
}

} // namespace wakesurf::core::steady_mesh_test
