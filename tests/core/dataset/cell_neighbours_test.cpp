#include "core/dataset/cell_neighbours.hpp"
#include "tests/support/cell_meshes.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <set>

namespace wakesurf::core::cell_neighbours_test {

using namespace tests;

namespace {

CellMesh refined() {
    return TwoToOne(
               6,
               [](const Vec3& c) {
                   return glm::length(c - 0.5) < 0.3 ? TwoToOne::Kind::Fine
                                                     : TwoToOne::Kind::Coarse;
               },
               wavy)
        .take();
}

/// Two tetrahedra on either side of a triangle of nodes 0, 1, 2, as many times as asked for.
CellMesh fins(std::uint32_t count) {
    CellMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.points.push_back({0, 0, 1.0 + i});
        add_cell(mesh, CellShape::Tetrahedron, {0, 1, 2, 3 + i});
    }
    connect_cells(mesh);
    return mesh;
}

} // namespace

TEST(CellNeighbours, EveryNeighboursNeighbourIsTheCellThroughTheSameNodes) {
    const CellMesh mesh = refined();
    std::size_t inner = 0;
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t f = 0; f < face_count(mesh.cells[i].shape); ++f) {
            const std::uint32_t other = mesh.cells[i].beyond[f];
            if (other >= beyond_wall)
                continue;
            ++inner;
            const MeshCell& cell = mesh.cells[other];
            bool back = false;
            for (std::size_t g = 0; g < face_count(cell.shape); ++g)
                back = back ||
                       (cell.beyond[g] == i && face_nodes(cell, g) == face_nodes(mesh.cells[i], f));
            EXPECT_TRUE(back) << i << " " << f;
        }
    EXPECT_GT(inner, 4 * mesh.cells.size() / 2);
}

TEST(CellNeighbours, BoundaryOfARefinedCubeIsTheCubesSides) {
    const CellMesh mesh = refined();
    double area = 0.0;
    for (const BoundaryFace& each : boundary_faces(mesh)) {
        const CellFace corners = face(mesh.cells[each.cell].shape, each.face);
        Vec3 twice(0.0);
        const auto p = [&](std::size_t i) {
            return mesh.points[mesh.cells[each.cell].node[corners.node[i]]];
        };
        for (std::size_t i = 2; i < corners.count; ++i)
            twice += glm::cross(p(i - 1) - p(0), p(i) - p(0));
        area += 0.5 * glm::length(twice);
    }
    EXPECT_NEAR(area, 6.0, 1e-12); // wavy() leaves the sides plane: no other face is open
}

TEST(CellNeighbours, OfFacesOfThreeCellsTheFirstTwoAreNeighbours) {
    const CellMesh mesh = fins(3);
    constexpr std::size_t base = 3; // nodes 0, 2, 1
    EXPECT_EQ(mesh.cells[0].beyond[base], 1u);
    EXPECT_EQ(mesh.cells[1].beyond[base], 0u);
    EXPECT_EQ(mesh.cells[2].beyond[base], beyond_domain);
    EXPECT_EQ(boundary_faces(mesh).size(), 10u);
}

TEST(CellNeighbours, AHexahedronCollapsedToAWedgeMeetsItsNeighbours) {
    CellMesh mesh;
    for (int z = 0; z < 2; ++z)
        for (const Vec3& p : {Vec3(0, 0, z), Vec3(1, 0, z), Vec3(0, 1, z), Vec3(0.3, 0.3, 1.0 - z)})
            mesh.points.push_back(p);
    mesh.points[3] = {0.3, 0.3, -1};
    add_cell(mesh, CellShape::Hexahedron, {0, 1, 2, 2, 4, 5, 6, 6});
    add_cell(mesh, CellShape::Tetrahedron, {0, 2, 1, 3}); // below
    connect_cells(mesh);
    EXPECT_EQ(mesh.cells[0].beyond[4], 1u);
    EXPECT_EQ(mesh.cells[1].beyond[3], 0u);
    for (const BoundaryFace& face : boundary_faces(mesh)) // the side that is a line is no face
        EXPECT_FALSE(face.cell == 0 && face.face == 3);
}

TEST(CellNeighbours, DoNotDependOnTheNumberOfThreads) {
    CellMesh mesh = refined();
    const std::vector<MeshCell> cells = mesh.cells;
    for (const std::size_t threads : {1u, 2u, 3u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        connect_cells(mesh);
        for (std::size_t i = 0; i < cells.size(); ++i)
            ASSERT_EQ(mesh.cells[i].beyond, cells[i].beyond);
    }
}

TEST(CellNeighbours, ANodeWithoutAPointIsRefused) {
    CellMesh mesh = fins(1);
    mesh.cells[0].node[2] = 99;
    EXPECT_THROW(connect_cells(mesh), std::out_of_range);
}

TEST(CellFaces, AreSeenFromOutsideCounterclockwise) {
    // Of the wedge VTK wants the normal of nodes 0, 1, 2 to point outward: its parametric coordinates are left-handed.
    const std::vector<std::pair<CellShape, std::vector<Vec3>>> shapes = {
        {CellShape::Tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {CellShape::Pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
        {CellShape::Wedge, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}}},
        {CellShape::Hexahedron,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}};
    for (const auto& [shape, points] : shapes) {
        ASSERT_EQ(points.size(), node_count(shape));
        Vec3 centre(0.0);
        for (const Vec3& p : points)
            centre += p / static_cast<double>(points.size());
        for (std::size_t f = 0; f < face_count(shape); ++f) {
            const CellFace each = face(shape, f);
            const Vec3 a = points[each.node[0]];
            const Vec3 normal = glm::cross(points[each.node[1]] - a, points[each.node[2]] - a);
            EXPECT_GT(glm::dot(normal, a - centre), 0.0) << int(shape) << " " << f;
        }
    }
}

} // namespace wakesurf::core::cell_neighbours_test
