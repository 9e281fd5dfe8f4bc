#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace wakesurf::core::column_merge_test {

using namespace tests;

namespace {

struct Case {
    const char* flow;
    Rake rake;
    double to, separation;
    SurfaceKind kind = SurfaceKind::Stream;
    Direction direction = Direction::Forward;
    bool converges = true; ///< at a merge of 0.35 columns stop
};

Surface built(const Case& c, double merge) {
    SurfaceParameters p{.kind = c.kind,
                        .to = c.to,
                        .direction = c.direction,
                        .separation = c.separation,
                        .merge = merge};
    auto surface = build_surface(**make_analytic_flow(c.flow), c.rake, p);
    EXPECT_TRUE(surface) << c.flow;
    return std::move(*surface);
}

/// Across the converging direction of the strain: the sheet narrows to a twentieth.
const Case converging{"strain", {Rake::Kind::Line, {{0.5, -1, 0}, {0.5, 1, 0}}, 16}, 6.0, 0.125};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        converging,
        {"stagnation?a=-0.5",
         {Rake::Kind::Circle, {{0, 0, 0.1}, {4, 0, 0.1}, {0, 4, 0.1}}, 30},
         3,
         0.1},
        {"hill", {Rake::Kind::Line, {{-0.3, 0, -2}, {0.5, 0, -2}}, 16}, 8, 0.05},
        {"sphere", {Rake::Kind::Line, {{-4, -2, 0}, {-4, 2, 0}}, 16}, 9, 0.1},
        {"strain?a=-0.5,b=0.5", {Rake::Kind::Line, {{-2, 0.5, 0}, {2, 0.5, 0.5}}, 64}, 4, 0.1},
        {"abc",
         {Rake::Kind::Line, {{0, 0, 0}, {3, 0, 0}}, 16},
         6,
         0.1,
         SurfaceKind::Stream,
         Direction::Forward,
         false},
        {"abc",
         {Rake::Kind::Line, {{0, 0, 0}, {3, 0, 0}}, 64},
         3,
         0.1,
         SurfaceKind::Stream,
         Direction::Both,
         false},
        {"double-gyre",
         {Rake::Kind::Line, {{0.2, 0.5, 0}, {1.8, 0.5, 0}}, 64},
         8,
         0.05,
         SurfaceKind::Path},
    };
    return all;
}

using Place = std::tuple<double, double, double, double, double>;

std::map<double, std::map<double, Place>> by_column(const QuadComplex& mesh) {
    std::map<double, std::map<double, Place>> columns;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const Vec3& p = mesh.position[v];
        columns[mesh.s[v]][mesh.t[v]] = {mesh.s[v], mesh.t[v], p.x, p.y, p.z};
    }
    return columns;
}

} // namespace

TEST(ColumnMerge, ConvergingStrainTakesAtMostTwoFifthsOfTheCells) {
    const Surface whole = built(converging, 0.0);
    const Surface merged = built(converging, 0.35);
    EXPECT_LE(static_cast<double>(merged.mesh.cells.size()),
              0.4 * static_cast<double>(whole.mesh.cells.size()));
}

TEST(ColumnMerge, WhereAColumnStoppedItDoesNotBeginAgain) {
    const auto whole = by_column(built(converging, 0.0).mesh);
    const auto merged = by_column(built(converging, 0.35).mesh);
    std::size_t stopped = 0;
    for (auto [s, column] : merged) {
        column.erase(converging.to); // the sheet's outline keeps vertices of columns that stopped
        stopped += column.size() + 1 < whole.at(s).size();
        std::size_t i = 0;
        for (auto full = whole.at(s).begin(); i < column.size(); ++full, ++i)
            ASSERT_TRUE(column.contains(full->first)) << "column " << s << " has a gap";
    }
    EXPECT_GT(2 * stopped, merged.size()) << "there is nothing to see";
}

TEST(ColumnMerge, TheSheetStaysWatertightAndWithinTheSeparation) {
    for (const Case& c : cases())
        for (const double merge : {0.2, 0.35, 0.5}) {
            const Surface whole = built(c, 0.0);
            const Surface merged = built(c, merge);
            if (merge == 0.35) {
                EXPECT_EQ(merged.mesh.cells.size() < whole.mesh.cells.size(), c.converges)
                    << c.flow << " " << merge;
            }
            EXPECT_EQ(merged.mesh.validate(), "") << c.flow << " " << merge;
            EXPECT_EQ(euler_characteristic(merged.mesh), euler_characteristic(whole.mesh))
                << c.flow;
            EXPECT_EQ(boundary_loops(merged.mesh), boundary_loops(whole.mesh)) << c.flow;
            EXPECT_LE(merged.statistics.max_edge, c.separation * (1.0 + 1e-6)) << c.flow;
            for (const auto& [edge, uses] : edge_uses(merged.mesh))
                ASSERT_LE(uses, 2) << c.flow;
        }
}

TEST(ColumnMerge, VerticesGoButNeverMove) {
    for (const Case& c : cases()) {
        const Surface all = built(c, 0.0);
        const Surface merged = built(c, 0.35);
        EXPECT_EQ(merged.mesh.vertices() < all.mesh.vertices(), c.converges) << c.flow;
        const auto whole = by_column(all.mesh);
        for (const auto& [s, column] : by_column(merged.mesh))
            for (const auto& [t, place] : column)
                ASSERT_EQ(place, whole.at(s).at(t)) << c.flow;
    }
}

TEST(ColumnMerge, FewCellsAreNarrowAfterwards) {
    const Surface merged = built(converging, 0.35);
    std::size_t narrow = 0;
    for (const Cell& cell : merged.mesh.cells) {
        double longest = 0.0;
        for (std::size_t side = 0; side < 4; side += 2)
            longest = std::max(longest, glm::length(merged.mesh.position[cell.corner[side]] -
                                                    merged.mesh.position[cell.corner[side + 1]]));
        narrow += longest < 0.25 * converging.separation;
    }
    EXPECT_LT(static_cast<double>(narrow), 0.05 * static_cast<double>(merged.mesh.cells.size()));
}

TEST(ColumnMerge, AKnobOutsideItsRangeIsRefused) {
    for (const double merge : {-0.1, 0.51, std::nan("")}) {
        SurfaceParameters p;
        p.merge = merge;
        const auto refused = build_surface(**make_analytic_flow("strain"), converging.rake, p);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, Error::Code::InvalidArgument);
    }
}

} // namespace wakesurf::core::column_merge_test
