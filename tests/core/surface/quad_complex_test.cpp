#include "core/surface/quad_complex.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wakesurf::core::quad_complex_test {

namespace {

/// Two cells over one wide cell whose old side they share: vertex 6 hangs on it.
QuadComplex two_over_one() {
    QuadComplex mesh;
    mesh.position = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0},
                     {0, 2, 0}, {2, 2, 0}, {1, 1, 0}, {1, 2, 0}};
    for (const Vec3& p : mesh.position) {
        mesh.s.push_back(p.x);
        mesh.t.push_back(p.y);
        mesh.approximated.push_back(0);
    }
    constexpr VertexId n = no_vertex;
    mesh.cells = {
        {{0, 1, 2, 3}, {n, n, 6, n}}, {{3, 6, 7, 4}, {n, n, n, n}}, {{6, 2, 5, 7}, {n, n, n, n}}};
    return mesh;
}

} // namespace

TEST(QuadComplex, AHangingNodeKeepsTheSurfaceWatertight) {
    const QuadComplex mesh = two_over_one();
    EXPECT_EQ(mesh.validate(), "");
    EXPECT_EQ(wakesurf::tests::euler_characteristic(mesh), 1);
    EXPECT_EQ(wakesurf::tests::boundary_loops(mesh), 1);
    EXPECT_EQ(polygon(mesh.cells[0]).count, 5u);
}

TEST(QuadComplex, ValidateFindsACrackAFlippedCellARepeatedAndAMissingVertex) {
    QuadComplex flipped = two_over_one();
    std::swap(flipped.cells[1].corner[1], flipped.cells[1].corner[3]);
    EXPECT_NE(flipped.validate(), "");

    QuadComplex repeated = two_over_one();
    repeated.cells[0].corner[1] = 0;
    EXPECT_NE(repeated.validate(), "");

    QuadComplex missing = two_over_one();
    missing.cells[0].mid[0] = 99;
    EXPECT_NE(missing.validate(), "");

    QuadComplex twin = two_over_one(); // the crack of a duplicated point
    twin.s[7] = twin.s[6];
    twin.t[7] = twin.t[6];
    EXPECT_NE(twin.validate(), "");
}

TEST(QuadComplex, LongestEdgeCutsSidesAtTheirMidNodes) {
    EXPECT_EQ(longest_edge(two_over_one()), 2.0);
    QuadComplex only_upper = two_over_one();
    only_upper.cells.erase(only_upper.cells.begin());
    EXPECT_EQ(longest_edge(only_upper), 1.0);
}

TEST(QuadComplex, ComponentsAreNumberedLargestFirst) {
    QuadComplex mesh = two_over_one();
    label_components(mesh);
    EXPECT_EQ(mesh.component, std::vector<std::uint32_t>(8, 0));

    for (int i = 0; i < 4; ++i) { // a lone cell, listed before the others
        mesh.position.emplace_back(10 + i % 2, i / 2, 0);
        mesh.s.push_back(10 + i);
        mesh.t.push_back(0);
        mesh.approximated.push_back(0);
    }
    mesh.cells.insert(mesh.cells.begin(),
                      Cell{{8, 9, 11, 10}, {no_vertex, no_vertex, no_vertex, no_vertex}});
    label_components(mesh);
    EXPECT_EQ(mesh.component[0], 0u);
    EXPECT_EQ(mesh.component[8], 1u);
}

/// Quads of a band, whose vertices are numbered in no order that has to do with where they are.
void add_band(QuadComplex& mesh, VertexId columns, VertexId rows) {
    const auto first = static_cast<VertexId>(mesh.vertices());
    const VertexId count = (columns + 1) * (rows + 1);
    const auto at = [&](VertexId column, VertexId row) {
        return first + (row * (columns + 1) + column) * 1009 % count;
    };
    mesh.position.resize(first + count);
    for (VertexId row = 0; row < rows; ++row)
        for (VertexId column = 0; column < columns; ++column)
            mesh.cells.push_back(Cell{{at(column, row), at(column + 1, row),
                                       at(column + 1, row + 1), at(column, row + 1)},
                                      {no_vertex, no_vertex, no_vertex, no_vertex}});
}

TEST(QuadComplex, WhatHangsTogetherIsOneComponentHoweverItsVerticesAreNumbered) {
    QuadComplex mesh;
    add_band(mesh, 3, 60);
    const std::size_t smaller = mesh.vertices();
    add_band(mesh, 40, 30);
    mesh.position.emplace_back(); // of no cell
    label_components(mesh);
    std::vector<std::uint32_t> wanted(mesh.vertices(), 0);
    std::fill_n(wanted.begin(), smaller, 1u);
    wanted.back() = 2;
    EXPECT_EQ(mesh.component, wanted);
}

} // namespace wakesurf::core::quad_complex_test
