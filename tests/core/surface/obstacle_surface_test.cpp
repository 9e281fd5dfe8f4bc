#include "core/surface/obstacle_surface.hpp"
#include "tests/support/mask_bytes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <utility>

namespace wakesurf::core::obstacle_surface_test {

namespace {

const UniformGrid grid{{1.0, 2.0, 3.0}, {0.5, 0.25, 1.0}, {7, 8, 6}};

SolidMask mask_of(const std::function<bool(int, int, int)>& solid) {
    SolidMask mask;
    for (int k = 0; k < 6; ++k)
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 7; ++i)
                mask.fluid.push_back(solid(i, j, k) ? 0 : 1);
    return mask;
}

bool in_box(int i, int j, int k) {
    return i >= 2 && i <= 4 && j >= 3 && j <= 5 && k >= 2 && k <= 3;
}

/// Directed edges of all cells, each with how often it occurs.
std::map<std::pair<VertexId, VertexId>, int> edges(const QuadComplex& mesh) {
    std::map<std::pair<VertexId, VertexId>, int> out;
    for (const Cell& cell : mesh.cells)
        for (std::size_t i = 0; i < 4; ++i)
            ++out[{cell.corner[i], cell.corner[(i + 1) % 4]}];
    return out;
}

/// By the divergence theorem; positive when the cells are counter-clockwise seen from outside.
double volume(const QuadComplex& mesh) {
    double sum = 0.0;
    for (const Cell& cell : mesh.cells) {
        const auto& p = mesh.position;
        const Vec3 a = p[cell.corner[0]];
        const Vec3 b = p[cell.corner[1]];
        const Vec3 c = p[cell.corner[2]];
        const Vec3 d = p[cell.corner[3]];
        sum += glm::dot(a, glm::cross(b, c)) / 6.0 + glm::dot(a, glm::cross(c, d)) / 6.0;
    }
    return sum;
}

} // namespace

TEST(ObstacleSurface, IsTheSameOfAMaskInBricks) {
    const auto corner = [](int i, int j, int k) { return in_box(i, j, k) || i + j + k < 4; };
    const auto all = [](int, int, int) { return true; };
    const auto none = [](int, int, int) { return false; };
    for (const std::function<bool(int, int, int)>& solid :
         {std::function<bool(int, int, int)>(in_box), {corner}, {all}, {none}})
        for (const std::uint32_t cells : {1u, 2u, 4u, 8u}) {
            const SolidMask whole = mask_of(solid);
            const QuadComplex wanted = obstacle_surface(grid, whole);
            const QuadComplex mesh = obstacle_surface(
                grid, tests::mask_in_bricks(whole, BrickLayout(grid.dimensions, cells)));
            EXPECT_EQ(mesh.position, wanted.position) << cells;
            ASSERT_EQ(mesh.cells.size(), wanted.cells.size()) << cells;
            for (std::size_t i = 0; i < mesh.cells.size(); ++i)
                EXPECT_EQ(mesh.cells[i].corner, wanted.cells[i].corner) << cells;
        }
}

TEST(ObstacleSurface, OfAnObstacleInsideTheDomainIsClosedAndFacesTheFluid) {
    const QuadComplex mesh = obstacle_surface(grid, mask_of(in_box));
    EXPECT_EQ(mesh.cells.size(), 2u * (3 * 3 + 3 * 2 + 3 * 2));
    const auto all = edges(mesh);
    for (const auto& [edge, count] : all) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(all.contains({edge.second, edge.first})) << "an open side";
    }
    // The wall lies half a spacing outside the solid nodes.
    EXPECT_NEAR(volume(mesh), 3 * 0.5 * 3 * 0.25 * 2 * 1.0, 1e-12);
    for (const Vec3& p : mesh.position)
        EXPECT_TRUE(grid.bounds().contains(p));
}

TEST(ObstacleSurface, IsCappedWhereTheObstacleMeetsTheDomainsBorder) {
    const QuadComplex mesh =
        obstacle_surface(grid, mask_of([](int i, int j, int) {
                             return i >= 2 && i <= 4 && j >= 3 && j <= 5; // all along z
                         }));
    EXPECT_EQ(mesh.cells.size(), 4u * 3 * 6 + 2u * 3 * 3);
    const auto all = edges(mesh);
    for (const auto& [edge, count] : all) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(all.contains({edge.second, edge.first})) << "an open side";
    }
    EXPECT_NEAR(volume(mesh), 3 * 0.5 * 3 * 0.25 * 5.0, 1e-12);
}

TEST(ObstacleSurface, LiesMidwayBetweenTheNodesOfARectilinearGrid) {
    RectilinearGrid even;
    RectilinearGrid uneven;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < grid.dimensions[axis]; ++i) {
            even.coordinates[axis].push_back(grid.origin[static_cast<int>(axis)] +
                                             i * grid.spacing[static_cast<int>(axis)]);
            uneven.coordinates[axis].push_back(i * i);
        }
    const QuadComplex mesh = obstacle_surface(Grid(grid), mask_of(in_box));
    const QuadComplex twin = obstacle_surface(Grid(even), mask_of(in_box));
    EXPECT_EQ(twin.position, mesh.position);
    ASSERT_EQ(twin.cells.size(), mesh.cells.size());
    // Nodes 2 to 4, 3 to 5 and 2 to 3 at their squares.
    const auto side = [](double first, double last) {
        const auto middle = [](double a) { return 0.5 * (a * a + (a + 1.0) * (a + 1.0)); };
        return middle(last) - middle(first - 1.0);
    };
    EXPECT_NEAR(volume(obstacle_surface(uneven, mask_of(in_box))),
                side(2, 4) * side(3, 5) * side(2, 3), 1e-9);
}

TEST(ObstacleSurface, OfNothingIsNothingAndOfEverythingTheDomain) {
    EXPECT_TRUE(obstacle_surface(grid, {}).cells.empty());
    EXPECT_TRUE(obstacle_surface(grid, mask_of([](int, int, int) { return false; })).cells.empty());
    EXPECT_NEAR(volume(obstacle_surface(grid, mask_of([](int, int, int) { return true; }))),
                3.0 * 1.75 * 5.0, 1e-12);
}

} // namespace wakesurf::core::obstacle_surface_test
