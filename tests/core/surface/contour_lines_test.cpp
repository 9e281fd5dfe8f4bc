#include "core/surface/contour_lines.hpp"
#include "tests/support/flat_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace wakesurf::core::contour_lines_test {

using namespace tests;

namespace {

double length(const ContourLine& line) {
    double sum = line.closed ? glm::length(line.points.front() - line.points.back()) : 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        sum += glm::length(line.points[i] - line.points[i - 1]);
    return sum;
}

/// 6 x 5 cells, some of them cut in four so that nodes hang on their neighbours; s = x / 6, t = y / 5.
QuadComplex hanging() {
    QuadComplex mesh = snapshot(flat_patch(6, 5), {}).mesh;
    const auto middle = [&](VertexId a, VertexId b) {
        mesh.position.push_back(0.5 * (mesh.position[a] + mesh.position[b]));
        mesh.s.push_back(0.5 * (mesh.s[a] + mesh.s[b]));
        mesh.t.push_back(0.5 * (mesh.t[a] + mesh.t[b]));
        mesh.approximated.push_back(0);
        return static_cast<VertexId>(mesh.position.size() - 1);
    };
    for (const std::size_t cut : {0u, 8u, 15u, 22u, 25u, 29u}) {
        const auto corner = mesh.cells[cut].corner;
        std::array<VertexId, 4> mid;
        for (std::size_t k = 0; k < 4; ++k) {
            const VertexId a = corner[k], b = corner[(k + 1) % 4];
            mid[k] = middle(a, b);
            for (Cell& cell : mesh.cells)
                for (std::size_t side = 0; side < 4; ++side)
                    if (cell.corner[side] == b && cell.corner[(side + 1) % 4] == a)
                        cell.mid[side] = mid[k];
        }
        const VertexId centre = middle(mid[0], mid[2]);
        mesh.cells[cut] = {{corner[0], mid[0], centre, mid[3]},
                           {no_vertex, no_vertex, no_vertex, no_vertex}};
        for (std::size_t k = 1; k < 4; ++k)
            mesh.cells.push_back({{mid[k - 1], corner[k], mid[k], centre},
                                  {no_vertex, no_vertex, no_vertex, no_vertex}});
    }
    EXPECT_EQ(mesh.validate(), "");
    return mesh;
}

void expect_points_apart(const ContourLine& line) {
    ASSERT_GE(line.points.size(), 2u);
    for (std::size_t i = 1; i < line.points.size(); ++i)
        EXPECT_NE(line.points[i], line.points[i - 1]);
    if (line.closed) {
        EXPECT_NE(line.points.front(), line.points.back());
    }
}

/// One straight line from border to border along y (of s) or x (of t).
void expect_straight(const QuadComplex& mesh, int axis, double value) {
    const auto lines = contour_lines(mesh, axis == 0 ? mesh.s : mesh.t, std::array{value});
    ASSERT_EQ(lines.size(), 1u) << value;
    const ContourLine& line = lines[0];
    EXPECT_EQ(line.value, value);
    EXPECT_FALSE(line.closed);
    expect_points_apart(line);
    EXPECT_NEAR(length(line), axis == 0 ? 5.0 : 6.0, 1e-12) << value;
    const double across = value * (axis == 0 ? 6.0 : 5.0);
    for (const Vec3& p : line.points)
        EXPECT_NEAR(p[axis], across, 1e-12);
    const auto [low, high] =
        std::minmax(line.points.front()[1 - axis], line.points.back()[1 - axis]);
    EXPECT_EQ(low, 0.0);
    EXPECT_EQ(high, axis == 0 ? 5.0 : 6.0);
}

} // namespace

TEST(ContourLines, AreStraightFromBorderToBorderOfAFlatPatch) {
    const QuadComplex mesh = hanging();
    for (const int axis : {0, 1})
        for (const double value : {0.03, 0.21, 0.37, 0.43, 0.77, 0.99})
            expect_straight(mesh, axis, value);
}

TEST(ContourLines, ThroughVerticesAreStillOneLine) {
    const QuadComplex mesh = hanging();
    for (int column = 1; column < 6; ++column)
        expect_straight(mesh, 0, column / 6.0);
    for (int row = 1; row < 5; ++row)
        expect_straight(mesh, 1, row / 5.0);
    expect_straight(mesh, 0, 0.25); // through hanging nodes
    expect_straight(mesh, 1, 0.5 * (2.0 / 5.0 + 3.0 / 5.0));
}

TEST(ContourLines, ThereIsNoneOutsideTheParametersRange) {
    const QuadComplex mesh = hanging();
    EXPECT_TRUE(contour_lines(mesh, mesh.s, std::array{-0.1, 1.1}).empty());
    EXPECT_TRUE(contour_lines({}, {}, std::array{0.5}).empty());
    EXPECT_TRUE(contour_lines(mesh, mesh.s, {}).empty());
}

TEST(ContourLines, ComeInTheOrderOfTheValues) {
    const QuadComplex mesh = hanging();
    const std::array values{0.9, 0.1, 0.5};
    const auto lines = contour_lines(mesh, mesh.t, values);
    ASSERT_EQ(lines.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(lines[i].value, values[i]);
}

TEST(ContourLines, RoundATubeAreClosed) {
    constexpr int columns = 12;
    const QuadComplex mesh = snapshot(flat_patch(columns, 4, true), {}).mesh;
    const double around = 2.0 * columns * std::sin(std::numbers::pi / columns);
    for (const double value : {0.1, 0.5, 0.6}) { // one of them on a row of vertices
        const auto lines = contour_lines(mesh, mesh.t, std::array{value});
        ASSERT_EQ(lines.size(), 1u) << value;
        EXPECT_TRUE(lines[0].closed);
        expect_points_apart(lines[0]);
        EXPECT_EQ(lines[0].points.size(), std::size_t(columns));
        EXPECT_NEAR(length(lines[0]), around, 1e-12);
    }
}

TEST(ContourLines, AClosedLineRoundAPeakIsFound) {
    QuadComplex mesh = snapshot(flat_patch(8, 8), {}).mesh;
    for (std::size_t i = 0; i < mesh.vertices(); ++i) // a pyramid over the middle
        mesh.t[i] =
            4.0 - std::max(std::abs(mesh.position[i].x - 4.0), std::abs(mesh.position[i].y - 4.0));
    const auto lines = contour_lines(mesh, mesh.t, std::array{2.5});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].closed);
    expect_points_apart(lines[0]);
    // A square of side 3 whose corners are cut where the line passes from side to side of a cell.
    EXPECT_NEAR(length(lines[0]), 8.0 + 4.0 * std::sqrt(0.5), 1e-12);
}

TEST(ContourLines, APatchInTwoPartsHasALineInEach) {
    MovingMesh mesh = flat_patch(6, 5);
    for (TriangleId row = 0; row < 5; ++row)
        for (const TriangleId half : {0u, 1u})
            mesh.triangles.remove(2 * (6 * row + 2) + half);
    const QuadComplex torn = snapshot(mesh, {}).mesh;
    const auto lines = contour_lines(torn, torn.t, std::array{0.5});
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NEAR(length(lines[0]) + length(lines[1]), 5.0, 1e-12);
}

TEST(EvenlySpaced, LeavesBothEndsOut) {
    const std::vector<double> parameter{3.0, -1.0, 2.0};
    EXPECT_EQ(evenly_spaced(parameter, 3), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_TRUE(evenly_spaced(parameter, 0).empty());
    EXPECT_TRUE(evenly_spaced({}, 3).empty());
}

} // namespace wakesurf::core::contour_lines_test
