#include "protocol/files/mesh_triangles.hpp"
#include "tests/support/mesh_measures.hpp"
#include "tests/support/refined_surface.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

namespace wakesurf::protocol::mesh_triangles_test {

namespace {

using core::no_vertex;

/// A unit square with a node in the middle of each side that `sides` names, bit by bit.
core::QuadComplex square(unsigned sides) {
    core::QuadComplex mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    core::Cell cell{{0, 1, 2, 3}, {no_vertex, no_vertex, no_vertex, no_vertex}};
    for (std::size_t side = 0; side < 4; ++side)
        if ((sides >> side & 1) != 0) {
            cell.mid[side] = static_cast<core::VertexId>(mesh.position.size());
            mesh.position.push_back(0.5 * (mesh.position[side] + mesh.position[(side + 1) % 4]));
        }
    mesh.cells = {cell};
    return mesh;
}

double area_of(const core::QuadComplex& mesh, const Triangle& t) {
    const auto a = mesh.position[t[0]];
    return 0.5 * glm::cross(mesh.position[t[1]] - a, mesh.position[t[2]] - a).z;
}

/// Directed edges and how often triangles use each.
std::map<std::pair<std::uint32_t, std::uint32_t>, int>
directed(const std::vector<Triangle>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& each : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++uses[{each[i], each[(i + 1) % 3]}];
    return uses;
}

} // namespace

TEST(MeshTriangles, CoverASquareWhateverHangsOnItsSides) {
    for (unsigned sides = 0; sides < 16; ++sides) {
        const auto mesh = square(sides);
        const auto triangles = triangles_of(mesh);
        EXPECT_EQ(triangles.size(), mesh.vertices() - 2);
        double sum = 0.0;
        for (const Triangle& each : triangles) {
            EXPECT_GT(area_of(mesh, each), 0.05)
                << sides << ": a sliver, or one the wrong way round";
            sum += area_of(mesh, each);
        }
        EXPECT_DOUBLE_EQ(sum, 1.0);
    }
}

TEST(MeshTriangles, CutAKiteAcrossItsShortDiagonal) {
    core::QuadComplex mesh;
    mesh.position = {{-5, 0, 0}, {0, -1, 0}, {5, 0, 0}, {0, 1, 0}};
    mesh.cells = {{{0, 1, 2, 3}, {no_vertex, no_vertex, no_vertex, no_vertex}}};
    const auto uses = directed(triangles_of(mesh));
    EXPECT_TRUE(uses.contains({1, 3}) && uses.contains({3, 1}));
}

TEST(MeshTriangles, AreAsWatertightAsTheSurface) {
    const auto mesh = tests::refined_surface();
    std::size_t hanging = 0;
    for (const core::Cell& cell : mesh.cells)
        hanging += core::polygon(cell).count > 4 ? 1 : 0;
    ASSERT_GT(hanging, 20u) << "of " << mesh.cells.size();
    const auto uses = directed(triangles_of(mesh));
    std::set<std::pair<std::uint32_t, std::uint32_t>> border;
    for (const auto& [edge, count] : uses) {
        EXPECT_EQ(count, 1) << "an edge used twice in one direction";
        if (!uses.contains({edge.second, edge.first}))
            border.insert({std::min(edge.first, edge.second), std::max(edge.first, edge.second)});
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (const auto& [edge, count] : tests::edge_uses(mesh))
        if (count == 1)
            expected.insert(edge);
    EXPECT_EQ(border, expected);
}

TEST(MeshTriangles, OfFlatAndBrokenCellsAreStillAllThere) {
    auto mesh = square(15);
    for (auto& p : mesh.position)
        p = {1, 2, 3};
    EXPECT_EQ(triangles_of(mesh).size(), 6u);
    mesh.position[0].x = std::numeric_limits<double>::quiet_NaN();
    mesh.position[1].x = std::numeric_limits<double>::infinity();
    const auto triangles = triangles_of(mesh);
    EXPECT_EQ(triangles.size(), 6u);
    for (const auto& [edge, count] : directed(triangles))
        EXPECT_EQ(count, 1);
}

} // namespace wakesurf::protocol::mesh_triangles_test
