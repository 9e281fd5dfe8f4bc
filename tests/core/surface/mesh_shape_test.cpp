// The measures that judge the shape of surfaces, on meshes drawn by hand.
#include "tests/support/mesh_shape.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace wakesurf::core::mesh_shape_test {

namespace {

using namespace tests;

constexpr VertexId n = no_vertex;

QuadComplex mesh_of(std::initializer_list<Vec3> points, std::vector<Cell> cells) {
    QuadComplex mesh;
    for (const Vec3& p : points) {
        mesh.position.push_back(p);
        mesh.s.push_back(p.x);
        mesh.t.push_back(p.y);
        mesh.approximated.push_back(0);
    }
    mesh.cells = std::move(cells);
    EXPECT_EQ(mesh.validate(), "");
    return mesh;
}

QuadComplex one_cell(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return mesh_of({a, b, c, d}, {{{0, 1, 2, 3}, {n, n, n, n}}});
}

CellOutline outline_of(const QuadComplex& mesh, std::size_t cell = 0) {
    return {mesh, mesh.cells[cell]};
}

/// Squares of side 1, but for those that are left out.
QuadComplex grid(std::uint32_t columns, std::uint32_t rows, std::vector<std::uint32_t> without) {
    QuadComplex mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column) {
            mesh.position.emplace_back(column, row, 0);
            mesh.s.push_back(column);
            mesh.t.push_back(row);
            mesh.approximated.push_back(0);
        }
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
        if (std::count(without.begin(), without.end(), i) != 0)
            continue;
        const VertexId v = i / columns * (columns + 1) + i % columns;
        mesh.cells.push_back({{v, v + 1, v + columns + 2, v + columns + 1}, {n, n, n, n}});
    }
    return mesh;
}

} // namespace

TEST(MeshShape, ASquareHasRightAnglesAndTheSlendernessOne) {
    const CellOutline square = outline_of(one_cell({0, 0, 3}, {2, 0, 3}, {2, 2, 3}, {0, 2, 3}));
    EXPECT_NEAR(smallest_corner(square), 90.0, 1e-9);
    EXPECT_NEAR(slenderness(square), 1.0, 1e-12);
    EXPECT_NEAR(narrowest_width(square), 2.0, 1e-12);
}

TEST(MeshShape, ARhombusIsMeasuredByItsSmallerAngleAndItsHeight) {
    const double slant = std::numbers::pi / 6.0;
    const Vec3 lean(std::cos(slant), std::sin(slant), 0.0);
    const CellOutline rhombus =
        outline_of(one_cell({0, 0, 0}, {1, 0, 0}, Vec3(1, 0, 0) + lean, lean));
    EXPECT_NEAR(smallest_corner(rhombus), 30.0, 1e-9);
    EXPECT_NEAR(slenderness(rhombus), 2.0, 1e-12);
    EXPECT_NEAR(narrowest_width(rhombus), 0.5, 1e-12);
}

TEST(MeshShape, AHangingNodeChangesNeitherAnglesNorSlendernessNorWidth) {
    const QuadComplex mesh =
        mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 0.04, 0}, {0, 0.04, 0}, {0.5, 0, 0}, {0.3, 0.04, 0}},
                {{{0, 1, 2, 3}, {4, n, 5, n}}});
    const CellOutline strip = outline_of(mesh);
    EXPECT_EQ(strip.count, 6u);
    EXPECT_NEAR(smallest_corner(strip), 90.0, 1e-9);
    EXPECT_NEAR(slenderness(strip), 25.0, 1e-9);
    EXPECT_NEAR(narrowest_width(strip), 0.04, 1e-12);
    EXPECT_EQ(shape_of(mesh).slivers, 1.0);
    EXPECT_EQ(shape_of(mesh).longest_edge, 0.7);
}

TEST(MeshShape, AHangingNodeThatLiesOffItsSideCountsInTheArea) {
    const QuadComplex mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, -0.5, 0}},
                                     {{{0, 1, 2, 3}, {4, n, n, n}}});
    EXPECT_NEAR(slenderness(outline_of(mesh)), 1.0 / 1.25, 1e-12);
    EXPECT_NEAR(smallest_corner(outline_of(mesh)), 90.0, 1e-9); // at the upper side
}

TEST(MeshShape, AQuadWithAStraightCornerIsTheTriangleItLooksLike) {
    const double height = std::sqrt(0.75);
    const CellOutline even =
        outline_of(one_cell({0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0.5, height, 0}));
    EXPECT_NEAR(smallest_corner(even), 60.0, 1e-9);
    EXPECT_NEAR(slenderness(even), 2.0 / height, 1e-9);
    EXPECT_NEAR(narrowest_width(even), height, 1e-9);

    // Half of its longest side alone would give 5.6.
    const CellOutline flat =
        outline_of(one_cell({0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0.5, 0.09, 0}));
    EXPECT_GT(slenderness(flat), most_slender);
}

TEST(MeshShape, ACornerThatPointsInwardIsNotASmallOne) {
    const CellOutline dart = outline_of(one_cell({0, 0, 0}, {2, -2, 0}, {0.5, 0, 0}, {2, 2, 0}));
    const double half = std::atan2(2.0, 1.5) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(dart.angle(2), 360.0 - 2.0 * half, 1e-9);
    EXPECT_NEAR(smallest_corner(dart), half - 45.0, 1e-9);
}

TEST(MeshShape, CellsWithoutAreaAreSlivers) {
    const CellOutline line = outline_of(one_cell({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 0, 0}));
    EXPECT_GT(slenderness(line), most_slender);
    EXPECT_EQ(smallest_corner(line), 0.0);
    EXPECT_EQ(narrowest_width(line), 0.0);
    const CellOutline crossed = outline_of(one_cell({0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_GT(slenderness(crossed), most_slender);
}

TEST(MeshShape, SharesAndPercentilesAreThoseOfAllCells) {
    QuadComplex mesh = grid(10, 10, {});
    const MeshShape even = shape_of(mesh);
    EXPECT_EQ(even.quads, 100u);
    EXPECT_EQ(even.slivers, 0.0);
    EXPECT_NEAR(even.angle5, 90.0, 1e-9);
    EXPECT_NEAR(even.median, 90.0, 1e-9);
    EXPECT_EQ(even.longest_edge, 1.0);

    for (Vec3& p : mesh.position) // the last row becomes thin, and all lean
        p = {p.x + p.y, p.y > 9.5 ? 9.01 : p.y, 0.0};
    const MeshShape leaning = shape_of(mesh);
    EXPECT_NEAR(leaning.slivers, 0.1, 1e-12);
    EXPECT_LT(leaning.angle5, 1.0);
    EXPECT_NEAR(leaning.median, 45.0, 1e-9);
}

TEST(MeshShape, ASheetHasOneLoopATubeTwoAndAHoleOneMore) {
    EXPECT_EQ(shape_of(grid(5, 5, {})).loops, 1u);
    EXPECT_EQ(shape_of(grid(5, 5, {})).holes(), 0);
    EXPECT_EQ(shape_of(grid(5, 5, {12})).holes(), 1);
    EXPECT_EQ(shape_of(grid(5, 5, {6, 18})).holes(), 2);
    EXPECT_EQ(shape_of(grid(5, 5, {22})).holes(), 0); // at the border it is a notch
    QuadComplex tube = grid(5, 3, {});
    for (Cell& cell : tube.cells)
        for (VertexId& v : cell.corner)
            v -= v % 6 == 5 ? 5 : 0;
    EXPECT_EQ(shape_of(tube).loops, 2u);
    EXPECT_EQ(shape_of(tube).components, 1u);
}

TEST(MeshShape, PartsAndHolesThatTouchAtAVertexAreCountedApart) {
    const MeshShape squares = shape_of(grid(2, 2, {1, 2}));
    EXPECT_EQ(squares.components, 2u);
    EXPECT_EQ(squares.loops, 2u);
    const MeshShape holes = shape_of(grid(6, 6, {14, 21}));
    EXPECT_EQ(holes.components, 1u);
    EXPECT_EQ(holes.loops, 2u); // the outer one, and one round both, whose rings meet at a vertex
    EXPECT_EQ(shape_of(grid(6, 6, {7})).holes(), 1);
    EXPECT_EQ(shape_of(grid(6, 6, {0, 7})).holes(),
              0); // the border runs through the missing corner
}

TEST(MeshShape, PartsOfUnderTwelveQuadsAreSpecks) {
    QuadComplex mesh = grid(12, 5, {});
    std::erase_if(mesh.cells, [](const Cell& cell) {
        const VertexId row = cell.corner[0] / 13, column = cell.corner[0] % 13;
        return row == 1 || (row == 4 && column == 11) || (row == 3);
    });
    const MeshShape shape = shape_of(mesh);
    EXPECT_EQ(shape.components, 3u); // 12, 12 and 11 quads
    EXPECT_EQ(shape.specks, 1u);
}

TEST(MeshShape, AHangingNodeJoinsTheCellsOnBothOfItsSides) {
    const QuadComplex mesh = mesh_of(
        {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 0}, {1, 2, 0}},
        {{{0, 1, 2, 3}, {n, n, 6, n}}, {{3, 6, 7, 4}, {n, n, n, n}}, {{6, 2, 5, 7}, {n, n, n, n}}});
    EXPECT_EQ(shape_of(mesh).components, 1u);
    EXPECT_EQ(shape_of(mesh).loops, 1u);
    EXPECT_EQ(border_edges(mesh).size(), 7u);
}

TEST(MeshShape, AnEmptySurfaceHasNoShape) {
    const MeshShape shape = shape_of({});
    EXPECT_EQ(shape.quads, 0u);
    EXPECT_EQ(shape.components, 0u);
    EXPECT_EQ(shape.loops, 0u);
    EXPECT_EQ(shape.slivers, 0.0);
}

} // namespace wakesurf::core::mesh_shape_test
