#include "core/dataset/cell_neighbours.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/assembly/polyhedron_cutter.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <map>

namespace wakesurf::importer::grid_assembly_test {
namespace {

using namespace tests;
using core::CellMesh;
using core::CellShape;
using core::Vec3;

using Pointers = std::vector<vtkSmartPointer<vtkDataSet>>;

GridAssembly assemble(const Pointers& blocks, const AssemblyRequest& request = {}) {
    auto assembly = assemble_grid(blocks, request);
    EXPECT_TRUE(assembly.has_value()) << assembly.error().message;
    return assembly ? std::move(*assembly) : GridAssembly();
}

const CellMesh& mesh_of(const GridAssembly& assembly) {
    return std::get<CellMesh>(assembly.grid);
}

double volume(const CellMesh& mesh) {
    double sum = 0.0;
    for (const auto& cell : mesh.cells)
        sum += cell_volume(cell, mesh.points);
    return sum;
}

std::size_t count(const CellMesh& mesh, CellShape shape) {
    return static_cast<std::size_t>(
        std::count_if(mesh.cells.begin(), mesh.cells.end(),
                      [&](const auto& cell) { return cell.shape == shape; }));
}

// Of the faces nothing lies beyond.
double boundary_area(const CellMesh& mesh) {
    double sum = 0.0;
    for (const auto& [number, f] : core::boundary_faces(mesh)) {
        const auto& cell = mesh.cells[number];
        const auto face = core::face(cell.shape, f);
        const auto corner = [&](std::size_t i) { return mesh.points[cell.node[face.node[i]]]; };
        for (std::size_t i = 2; i < face.count; ++i)
            sum += 0.5 * glm::length(glm::cross(corner(i - 1) - corner(0), corner(i) - corner(0)));
    }
    return sum;
}

std::size_t walls(const CellMesh& mesh) {
    std::size_t found = 0;
    for (const auto& [cell, face] : core::boundary_faces(mesh))
        found += mesh.cells[cell].beyond[face] == core::beyond_wall ? 1 : 0;
    return found;
}

void mark(vtkDataSet& data, bool points, vtkIdType which, unsigned char flag) {
    auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(points ? data.GetNumberOfPoints() : data.GetNumberOfCells());
    marks->Fill(0);
    marks->SetValue(which, flag);
    if (points)
        data.GetPointData()->AddArray(marks);
    else
        data.GetCellData()->AddArray(marks);
}

TEST(GridAssembly, KeepsAnImageAndARectilinearGridWhatTheyAre) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetExtent(2, 4, 0, 3, -1, 3);
    image->SetOrigin(1, 2, 3);
    image->SetSpacing(0.5, 1, 2);
    const auto uniform = std::get<core::UniformGrid>(assemble({image}).grid);
    EXPECT_EQ(uniform.dimensions, (std::array<std::uint32_t, 3>{3, 4, 5}));
    EXPECT_EQ(uniform.origin, Vec3(2, 2, 1));
    auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
    auto axis = vtkSmartPointer<vtkDoubleArray>::New();
    for (const double x : {0.0, 1.0, 4.0})
        axis->InsertNextValue(x);
    rectilinear->SetDimensions(3, 3, 3);
    rectilinear->SetXCoordinates(axis);
    rectilinear->SetYCoordinates(axis);
    rectilinear->SetZCoordinates(axis);
    const auto grid = std::get<core::RectilinearGrid>(assemble({rectilinear}).grid);
    EXPECT_EQ(grid.coordinates[2], (std::vector<double>{0, 1, 4}));
    // Where cells of it are blanked, it has a shape of its own.
    mark(*image, false, 0, vtkDataSetAttributes::HIDDENCELL);
    const auto holey = assemble({image});
    EXPECT_TRUE(holey.curvilinear);
    EXPECT_EQ(mesh_of(holey).cells.size(), 2u * 3 * 4 - 1);
}

TEST(GridAssembly, CutsPolyhedraConforminglyWhereCellsOfTwoSizesMeet) {
    const auto assembly = assemble({refined_block()});
    const CellMesh& mesh = mesh_of(assembly);
    EXPECT_EQ(assembly.source_cells, 32u + 4u);
    EXPECT_EQ(count(mesh, CellShape::Hexahedron), 32u);
    EXPECT_EQ(count(mesh, CellShape::Pyramid), 4u * 5); // below, and four on top
    EXPECT_EQ(count(mesh, CellShape::Tetrahedron), 4u * 4 * 5);
    EXPECT_NEAR(volume(mesh), 8.0, 1e-13);
    // Every face inside has a cell on both sides: what is left over is the surface of the box, once.
    EXPECT_NEAR(boundary_area(mesh), 24.0, 1e-12);
    for (const auto& cell : mesh.cells)
        EXPECT_GT(cell_volume(cell, mesh.points), 0.0);
    EXPECT_NE(assembly.note.find("4 polyhedra were cut"), std::string::npos) << assembly.note;
}

TEST(GridAssembly, SeesThatAPolyhedronIsOneOfTheFourShapes) {
    auto grid = brick({0, 0, 0}, 1.0, {1, 1, 1});
    grid->GetCells()->Reset();
    auto block = empty_block();
    block->SetPoints(grid->GetPoints());
    const auto apex = add_point(*block, {0.5, 0.5, 2.0});
    add_polyhedron(
        *block,
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}});
    add_polyhedron(*block, {{4, 6, 7, 5}, {4, 5, apex}, {5, 7, apex}, {7, 6, apex}, {6, 4, apex}});
    auto shapes = empty_block();
    for (const Vec3 p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1),
                         Vec3(0, 1, 1), Vec3(3, 3, 3)})
        add_point(*shapes, p);
    add_polyhedron(*shapes, {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
    add_polyhedron(*shapes, {{3, 4, 5}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
    const auto first = assemble({block});
    EXPECT_EQ(count(mesh_of(first), CellShape::Hexahedron), 1u);
    EXPECT_EQ(count(mesh_of(first), CellShape::Pyramid), 1u);
    EXPECT_NEAR(volume(mesh_of(first)), 1.0 + 1.0 / 3.0, 1e-14);
    const auto second = assemble({shapes});
    EXPECT_EQ(count(mesh_of(second), CellShape::Wedge), 1u);
    EXPECT_EQ(count(mesh_of(second), CellShape::Tetrahedron), 1u);
    EXPECT_EQ(mesh_of(second).points.size(), 7u);
}

TEST(GridAssembly, CutsAPolyhedronThatItsMeanDoesNotSeeRoundItsCentreOfVolume) {
    // A slab with a beak, and a crowd of points at its tip: their mean lies above the slab.
    auto block = empty_block();
    std::vector<std::pair<double, double>> outline{{0, 0}, {4, 0}};
    for (int i = 0; i <= 60; ++i)
        outline.emplace_back(5.0 - 0.1 * i / 60.0, 1.06 + 0.04 * i / 60.0);
    outline.insert(outline.end(), {{3.9, 1.0}, {0, 1.0}});
    const auto n = static_cast<vtkIdType>(outline.size());
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : outline)
            add_point(*block, {x, y, z});
    std::vector<std::vector<vtkIdType>> faces(2);
    double area = 0.0;
    for (vtkIdType i = 0; i < n; ++i) {
        const vtkIdType next = (i + 1) % n;
        faces[0].insert(faces[0].begin(), i);
        faces[1].push_back(n + i);
        faces.push_back({i, next, n + next, n + i});
        const auto& [ax, ay] = outline[static_cast<std::size_t>(i)];
        const auto& [bx, by] = outline[static_cast<std::size_t>(next)];
        area += 0.5 * (ax * by - bx * ay);
    }
    add_polyhedron(*block, faces);
    const auto assembly = assemble({block});
    EXPECT_NEAR(volume(mesh_of(assembly)), area, 1e-12) << assembly.note;
    EXPECT_EQ(assembly.note.find("overlap"), std::string::npos) << assembly.note;
    // An added node lies where its weights say, so that linear fields are exact there too.
    const auto& added = assembly.added;
    for (std::size_t i = 0; i < added.size(); ++i) {
        Vec3 at(0.0);
        for (std::size_t part = added.first[i]; part < added.first[i + 1]; ++part)
            at += added.weight[part] * mesh_of(assembly).points[added.node[part]];
        EXPECT_LT(glm::distance(at, mesh_of(assembly).points[assembly.source_nodes + i]), 1e-12);
    }
}

TEST(GridAssembly, JoinsBlocksThatShareAFace) {
    const auto assembly =
        assemble({brick({0, 0, 0}, 0.1, {3, 2, 2}), brick({0.1 * 3, 0, 0}, 0.1, {2, 2, 2})});
    EXPECT_EQ(mesh_of(assembly).points.size(), 6u * 3 * 3);
    EXPECT_NEAR(boundary_area(mesh_of(assembly)), 2 * (0.5 * 0.2 * 2 + 0.2 * 0.2), 1e-12);
    EXPECT_EQ(assembly.source_cells, 20u);
}

// A sheet of two sides at z = 1 that ends at y = 1, where both halves have the same points.
GridPointer with_baffle(double x) {
    auto lower = brick({x, 0, 0}, 1.0, {1, 1, 1});
    auto grid = brick({x, 0, 1}, 1.0, {1, 1, 1});
    std::vector<vtkIdType> cell;
    for (vtkIdType i = 0; i < 8; ++i)
        add_point(*grid, {lower->GetPoint(i)[0], lower->GetPoint(i)[1], lower->GetPoint(i)[2]});
    for (const vtkIdType i : {0, 1, 3, 2, 4, 5, 7, 6})
        cell.push_back(i < 6 ? 8 + i : i - 4);
    add_cell(*grid, VTK_HEXAHEDRON, cell);
    return grid;
}

TEST(GridAssembly, KeepsTheTwoSidesOfABaffleApart) {
    const auto one = assemble({with_baffle(0)});
    EXPECT_EQ(mesh_of(one).points.size(), 14u);
    EXPECT_NEAR(boundary_area(mesh_of(one)), 12.0, 1e-12);
    // Also where it crosses from one block to the next.
    const auto two = assemble({with_baffle(0), with_baffle(1)});
    EXPECT_EQ(mesh_of(two).points.size(), 21u);
    EXPECT_NEAR(boundary_area(mesh_of(two)), 2 * 10.0, 1e-12);
}

TEST(GridAssembly, TakesACellOnceThatTwoBlocksHold) {
    const auto assembly =
        assemble({brick({0, 0, 0}, 1.0, {3, 1, 1}), brick({2, 0, 0}, 1.0, {3, 1, 1})});
    EXPECT_EQ(assembly.source_cells, 5u);
    EXPECT_NEAR(volume(mesh_of(assembly)), 5.0, 1e-13);
    EXPECT_NE(assembly.note.find("stored once"), std::string::npos) << assembly.note;
}

TEST(GridAssembly, LeavesOutBlankedCellsAndPointsNobodyUses) {
    for (const unsigned char flag :
         {vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL}) {
        auto grid = brick({0, 0, 0}, 1.0, {3, 1, 1});
        mark(*grid, false, 2, flag);
        const auto assembly = assemble({grid});
        EXPECT_EQ(mesh_of(assembly).cells.size(), 2u);
        EXPECT_EQ(mesh_of(assembly).points.size(), 12u);
        EXPECT_EQ(assembly.blocks[0].node_of_point[3], no_node);
    }
    auto grid = brick({0, 0, 0}, 1.0, {3, 1, 1});
    mark(*grid, true, 3, vtkDataSetAttributes::HIDDENPOINT);
    EXPECT_EQ(mesh_of(assemble({grid})).cells.size(), 2u);
}

TEST(GridAssembly, TurnsCellsOutsideOutAndLeavesFlatOnesOut) {
    auto grid = brick({0, 0, 0}, 1.0, {1, 1, 1});
    auto block = empty_block();
    block->SetPoints(grid->GetPoints());
    add_cell(*block, VTK_HEXAHEDRON, {4, 5, 7, 6, 0, 1, 3, 2});
    add_cell(*block, VTK_TETRA, {0, 1, 3, 2}); // in one plane
    const auto assembly = assemble({block});
    EXPECT_EQ(mesh_of(assembly).cells.size(), 1u);
    EXPECT_NEAR(volume(mesh_of(assembly)), 1.0, 1e-14);
    EXPECT_NE(assembly.note.find("1 cell without volume"), std::string::npos) << assembly.note;
}

TEST(GridAssembly, ReadsAVoxelAsTheHexahedronItIs) {
    auto block = empty_block();
    block->SetPoints(brick({0, 0, 0}, 1.0, {1, 1, 1})->GetPoints());
    add_cell(*block, VTK_VOXEL, {0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_NEAR(volume(mesh_of(assemble({block}))), 1.0, 1e-14);
}

TEST(GridAssembly, ReadsCellsOfAnyOrderThatHaveTheirCornersOnlyAsWhatTheyAre) {
    const auto corners = brick({0, 0, 0}, 1.0, {1, 1, 1});
    const std::vector<vtkIdType> hexahedron{0, 1, 3, 2, 4, 5, 7, 6};

    const struct {
        std::vector<int> types;
        std::vector<vtkIdType> points;
        double volume;
    } cells[]{{{VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_HEXAHEDRON}, hexahedron, 1.0},
              {{VTK_LAGRANGE_WEDGE, VTK_BEZIER_WEDGE}, {0, 1, 2, 4, 5, 6}, 0.5},
              {{VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID}, {0, 1, 3, 2, 4}, 1.0 / 3.0},
              {{VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON}, {0, 1, 2, 4}, 1.0 / 6.0}};

    for (const auto& cell : cells)
        for (const int type : cell.types) {
            auto block = empty_block();
            block->SetPoints(corners->GetPoints());
            add_cell(*block, type, cell.points);
            add_cell(*block, VTK_LAGRANGE_QUADRILATERAL, {0, 1, 3, 2});
            add_cell(*block, VTK_BEZIER_TRIANGLE, {0, 1, 2});
            EXPECT_NEAR(volume(mesh_of(assemble({block}))), cell.volume, 1e-14) << type;
        }
    auto weighted = empty_block();
    weighted->SetPoints(corners->GetPoints());
    add_cell(*weighted, VTK_BEZIER_HEXAHEDRON, hexahedron);
    auto weights = vtkSmartPointer<vtkDoubleArray>::New();
    weights->SetNumberOfValues(8);
    weights->Fill(1.0);
    weighted->GetPointData()->SetRationalWeights(weights);
    EXPECT_FALSE(assemble_grid(Pointers{weighted}).has_value()) << "its values are no polynomials";
}

TEST(GridAssembly, RefusesWhatWouldHaveToBeApproximatedAndPlanes) {
    auto curved = empty_block();
    std::vector<vtkIdType> points;
    for (int i = 0; i < 10; ++i)
        points.push_back(add_point(*curved, Vec3(i, i * i, i * i * i)));
    add_cell(*curved, VTK_QUADRATIC_TETRA, points);
    const auto refused = assemble_grid(Pointers{curved});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, core::Error::Code::Unsupported);
    EXPECT_NE(refused.error().message.find("vtkQuadraticTetra"), std::string::npos)
        << refused.error().message;
    auto plane = empty_block();
    for (const Vec3 p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
        add_point(*plane, p);
    add_cell(*plane, VTK_TRIANGLE, {0, 1, 2});
    const auto flat = assemble_grid(Pointers{plane});
    ASSERT_FALSE(flat.has_value());
    EXPECT_NE(flat.error().message.find("no three-dimensional cells"), std::string::npos);
}

TEST(GridAssembly, MakesWallsOfTheFacesThatSolidCellsLeave) {
    AssemblyRequest request;
    request.solid = {std::vector<bool>(27, false)};
    request.solid[0][13] = true; // the middle one
    const auto assembly = assemble({brick({0, 0, 0}, 1.0, {3, 3, 3})}, request);
    EXPECT_EQ(assembly.source_cells, 26u);
    EXPECT_EQ(walls(mesh_of(assembly)), 6u);
    EXPECT_EQ(core::boundary_faces(mesh_of(assembly)).size(), 6u + 54u);
}

} // namespace
} // namespace wakesurf::importer::grid_assembly_test
