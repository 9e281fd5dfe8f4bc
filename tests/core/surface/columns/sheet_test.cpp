#include "core/field/analytic_flow.hpp"
#include "core/surface/columns/sheet.hpp"
#include "core/surface/columns/sheet_mesh.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::sheet_test {

using namespace tests;

namespace {

SheetOptions options(double duration, double separation, std::uint64_t max_quads = 1'000'000) {
    SheetOptions o;
    o.trace = {.frozen = true, .tolerance = 1e-6, .longest_step = 0.2, .stagnation_speed = 1e-6};
    o.release = 0.0;
    o.duration = duration;
    o.separation = separation;
    o.max_quads = max_quads;
    return o;
}

const Rake across_strain{Rake::Kind::Line, {{-1, 4, 0}, {1, 4, 0}}, 2};

} // namespace

TEST(Sheet, DivergenceInsertsColumnsAtDyadicSeedsTracedFromTheRake) {
    const auto strain = *make_analytic_flow("strain");
    Sheet sheet(*strain, SeedingCurve(across_strain), options(3.0, 0.5));
    ASSERT_TRUE(sheet.build({0.0, 0.25, 0.5, 0.75, 1.0}, SteadyClock{}, {}));
    std::size_t inserted = 0;
    for (const SeededCurve* column : sheet.columns()) {
        EXPECT_NEAR(column->curve.seed.x, -1.0 + 2.0 * column->s, 1e-12);
        const double scaled = column->s * 1024.0;
        EXPECT_EQ(scaled, std::floor(scaled));
        inserted += column->s * 4.0 != std::floor(column->s * 4.0);
    }
    // The rake's width grows by e^1.5: 2 becomes 8.96, which takes at least 18 fronts of 0.5.
    EXPECT_GE(inserted + 5, 18u);
}

TEST(Sheet, IsGivenUpAsSoonAsItHasMoreQuadsThanItMay) {
    const auto strain = *make_analytic_flow("strain");
    Sheet sheet(*strain, SeedingCurve(across_strain), options(3.0, 0.05, 100));
    const auto built = sheet.build({0.0, 0.5, 1.0}, SteadyClock{}, {});
    ASSERT_TRUE(built);
    EXPECT_FALSE(*built);
}

TEST(Sheet, AStripThatDivergesAtTheRakeGainsASeedThere) {
    const auto uniform = *make_analytic_flow("uniform");
    const Rake rake{Rake::Kind::Line, {{0, 0, 0}, {0, 1, 0}}, 2};
    Sheet sheet(*uniform, SeedingCurve(rake), options(1.0, 0.3));
    ASSERT_TRUE(sheet.build({0.0, 1.0}, SteadyClock{}, {}));
    EXPECT_EQ(sheet.seeds(), (std::set<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(SheetMesh, AClosedRakesLastStripEndsAtItsFirstColumn) {
    const auto uniform = *make_analytic_flow("uniform?u=0,w=1");
    const Rake rake{Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 24};
    Sheet sheet(*uniform, SeedingCurve(rake), options(2.0, 0.3));
    std::set<double> seeds;
    for (int i = 0; i < 24; ++i)
        seeds.insert(i / 24.0);
    ASSERT_TRUE(sheet.build(seeds, SteadyClock{}, {}));
    SheetMesh mesh;
    append_sheet(mesh, sheet);
    EXPECT_EQ(mesh.complex.validate(), "");
    EXPECT_EQ(euler_characteristic(mesh.complex), 0);
    EXPECT_NEAR(area(mesh.complex), 24 * 2.0 * std::sin(3.14159265358979 / 24) * 2.0, 1e-3);
}

TEST(SheetMesh, HoldsOnlyVerticesThatCellsUse) {
    const auto sphere = *make_analytic_flow("sphere");
    const Rake rake{Rake::Kind::Line, {{-3, -1, 0}, {-3, 1, 0}}, 2};
    Sheet sheet(*sphere, SeedingCurve(rake), options(8.0, 0.1));
    std::set<double> seeds;
    for (int i = 0; i <= 20; ++i)
        seeds.insert(i / 20.0);
    ASSERT_TRUE(sheet.build(seeds, SteadyClock{}, {}));
    SheetMesh mesh;
    append_sheet(mesh, sheet);
    std::vector<bool> used(mesh.complex.vertices());
    for (const Cell& cell : mesh.complex.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            used[outline.vertex[i]] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    EXPECT_EQ(mesh.stretch.size(), mesh.complex.vertices());
}

} // namespace wakesurf::core::sheet_test
