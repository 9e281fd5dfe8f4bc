// Planes of cells that are given a thickness.
#include "importer/assembly/grid_assembly.hpp"
#include "importer/base/slab_mark.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <set>

namespace wakesurf::importer::plane_slab_test {
namespace {

using namespace tests;
using core::Vec3;

/// A unit square: two triangles of either turn, a quad and a pentagon, on a plane that `place` puts anywhere.
GridPointer square(const std::function<Vec3(double, double)>& place) {
    auto grid = empty_block();
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {0.5, 0.0},
                               {1.0, 0.0},
                               {0.0, 0.5},
                               {0.5, 0.5},
                               {1.0, 0.5},
                               {0.0, 1.0},
                               {0.25, 1.0},
                               {1.0, 1.0}})
        add_point(*grid, place(x, y));
    add_cell(*grid, VTK_TRIANGLE, {0, 1, 4});
    add_cell(*grid, VTK_TRIANGLE, {0, 4, 3}); // the two of the first quarter
    add_cell(*grid, VTK_QUAD, {5, 4, 1, 2});  // turned the other way
    add_cell(*grid, VTK_POLYGON, {3, 4, 7, 6});
    add_cell(*grid, VTK_POLYGON, {4, 5, 8, 7});
    return grid;
}

double volume(const core::CellMesh& mesh) {
    double sum = 0.0;
    for (const auto& [cell, f] : core::boundary_faces(mesh)) {
        const core::CellFace face = core::face(mesh.cells[cell].shape, f);
        const auto at = [&](std::size_t i) {
            return mesh.points[mesh.cells[cell].node[face.node[i]]];
        };
        for (std::size_t k = 2; k < face.count; ++k)
            sum += glm::dot(at(0), glm::cross(at(k - 1), at(k))) / 6.0;
    }
    return sum;
}

TEST(PlaneSlab, HasTheAreaOfThePlaneTimesItsThicknessWhateverTheCellsAndTheirTurn) {
    const Vec3 a = glm::normalize(Vec3(1.0, 2.0, 0.5));
    const Vec3 b = glm::normalize(glm::cross(a, Vec3(0.3, -1.0, 0.2)));
    for (const bool slanting : {false, true}) {
        const auto plane = square([&](double x, double y) {
            return slanting ? Vec3(3.0, 1.0, -2.0) + x * a + y * b : Vec3(x, 0.7, y);
        });
        const auto slab = slab_of(*plane);
        ASSERT_TRUE(slab.has_value());
        const auto normal = marked_slab(**slab);
        ASSERT_TRUE(normal.has_value());
        EXPECT_NEAR(
            std::abs(glm::dot(normal->across, slanting ? glm::cross(a, b) : Vec3(0.0, 1.0, 0.0))),
            1.0, 1e-12);
        const std::vector<vtkSmartPointer<vtkDataSet>> blocks{*slab};
        const auto assembly = assemble_grid(blocks, {});
        ASSERT_TRUE(assembly.has_value()) << assembly.error().message;
        EXPECT_EQ(assembly->note,
                  "a plane flow: its cells are given a thickness, and nothing moves across");
        EXPECT_EQ(assembly->source_cells, 5u);
        const double thickness = std::sqrt(1.0 / 5.0);
        EXPECT_NEAR(volume(std::get<core::CellMesh>(assembly->grid)), thickness, 1e-6);
    }
}

TEST(PlaneSlab, HasTheValuesOfThePlaneOnBothSidesAndTheComponentThatPlanesLack) {
    auto plane = square([](double x, double y) { return Vec3(x, 0.0, y); });
    add_array(*plane, true, "u", 1, [](const Vec3& p, int) { return 1.0 + p.x; });
    add_array(*plane, true, "w", 1, [](const Vec3& p, int) { return 2.0 + p.z; });
    add_array(*plane, true, "Velocity", 2, [](const Vec3& p, int c) { return 10.0 * c + p.x; });
    add_array(*plane, false, "T", 1, [](const Vec3& p, int) { return p.z; });
    const auto slab = slab_of(*plane);
    ASSERT_TRUE(slab.has_value());
    auto& points = *(*slab)->GetPointData();
    ASSERT_NE(points.GetArray("v"), nullptr);
    for (vtkIdType i = 0; i < (*slab)->GetNumberOfPoints(); ++i) {
        const double* p = (*slab)->GetPoint(i);
        const double x = p[0];
        const double z = p[2];
        EXPECT_EQ(points.GetArray("u")->GetTuple1(i), 1.0 + x);
        EXPECT_EQ(points.GetArray("v")->GetTuple1(i), 0.0);
        EXPECT_EQ(points.GetArray("w")->GetTuple1(i), 2.0 + z);
        EXPECT_EQ(points.GetArray("Velocity")->GetComponent(i, 0), x);
        EXPECT_EQ(points.GetArray("Velocity")->GetComponent(i, 1), 0.0);
        EXPECT_EQ(points.GetArray("Velocity")->GetComponent(i, 2), 10.0 + x);
    }
    EXPECT_EQ((*slab)->GetCellData()->GetArray("T")->GetNumberOfTuples(), 5);
}

TEST(PlaneSlab, IsOfTheKindOfTheBlockAcrossAnyAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        std::array<int, 3> nodes{4, 3, 5};
        nodes[static_cast<std::size_t>(axis)] = 1;
        auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
        grid->SetDimensions(nodes.data());
        auto points = vtkSmartPointer<vtkPoints>::New();
        for (int k = 0; k < nodes[2]; ++k)
            for (int j = 0; j < nodes[1]; ++j)
                for (int i = 0; i < nodes[0]; ++i)
                    points->InsertNextPoint(i, j, k);
        grid->SetPoints(points);
        auto number = vtkSmartPointer<vtkDoubleArray>::New();
        number->SetName("n");
        for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
            number->InsertNextValue(static_cast<double>(i));
        grid->GetPointData()->AddArray(number);
        const auto slab = slab_of(*grid);
        ASSERT_TRUE(slab.has_value());
        auto* const thick = vtkStructuredGrid::SafeDownCast(*slab);
        ASSERT_NE(thick, nullptr);
        EXPECT_EQ(thick->GetDimensions()[axis], 2);
        for (vtkIdType i = 0; i < thick->GetNumberOfPoints(); ++i) {
            const auto source =
                static_cast<vtkIdType>(thick->GetPointData()->GetArray("n")->GetTuple1(i));
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(thick->GetPoint(i)[c], points->GetPoint(source)[c],
                            c == axis ? 0.5 + 1e-12 : 1e-12);
        }
        const std::vector<vtkSmartPointer<vtkDataSet>> blocks{*slab};
        EXPECT_TRUE(assemble_grid(blocks, {}).has_value());
    }
}

/// n x m quads between two corners of a plane of constant z.
GridPointer quads(double x0, double x1, double y0, double y1, int n, int m, double z = 0.0) {
    auto grid = empty_block();
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
            add_point(*grid, {x0 + (x1 - x0) * i / n, y0 + (y1 - y0) * j / m, z});
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const vtkIdType at = i + (n + 1) * j;
            add_cell(*grid, VTK_QUAD, {at, at + 1, at + n + 2, at + n + 1});
        }
    return grid;
}

std::vector<vtkSmartPointer<vtkDataSet>> slabs(std::initializer_list<GridPointer> planes) {
    std::vector<vtkSmartPointer<vtkDataSet>> out;
    for (const auto& plane : planes)
        out.push_back(slab_of(*plane).value());
    return out;
}

TEST(PlaneSlab, MeetsThatOfAnotherBlockOfThePlaneWhoseCellsAreOfAnotherWidth) {
    const auto blocks = slabs({quads(0, 2, 0, 1, 2, 2), quads(2, 4, 0, 1, 8, 2)});
    const auto even = even_slabs(blocks);
    ASSERT_TRUE(even.has_value()) << even.error().message;
    const auto assembly = assemble_grid(blocks, {});
    ASSERT_TRUE(assembly.has_value()) << assembly.error().message;
    const auto& mesh = std::get<core::CellMesh>(assembly->grid);
    EXPECT_EQ(mesh.points.size(), 2u * (3 * 3 + 9 * 3 - 3));
    EXPECT_NEAR(volume(mesh), 4.0 * std::sqrt(4.0 / 20.0), 1e-5);
    EXPECT_EQ(assembly->note,
              "a plane flow: its cells are given a thickness, and nothing moves across");
}

TEST(PlaneSlab, OfImagesMeetsAsThoseOfMeshesDo) {
    std::vector<vtkSmartPointer<vtkDataSet>> blocks;
    for (const int cells : {2, 8}) {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(cells + 1, 3, 1);
        image->SetOrigin(cells == 2 ? 0.0 : 2.0, 0.0, 3.0);
        image->SetSpacing(2.0 / cells, 0.5, 1.0);
        blocks.push_back(slab_of(*image).value());
    }
    ASSERT_TRUE(even_slabs(blocks).has_value());
    const auto assembly = assemble_grid(blocks, {});
    ASSERT_TRUE(assembly.has_value()) << assembly.error().message;
    const auto& mesh = std::get<core::CellMesh>(assembly->grid);
    EXPECT_EQ(mesh.points.size(), 2u * (3 * 3 + 9 * 3 - 3));
    EXPECT_NEAR(volume(mesh), 4.0 * std::sqrt(4.0 / 20.0), 1e-5);
}

TEST(PlaneSlab, IsRefusedBesideCellsInSpaceOrOtherPlanes) {
    auto mixed = slabs({quads(0, 1, 0, 1, 2, 2)});
    mixed.emplace_back(brick({0, 0, 0}, 0.5, {2, 2, 2}));
    EXPECT_FALSE(even_slabs(mixed).has_value());
    std::swap(mixed[0], mixed[1]);
    EXPECT_FALSE(even_slabs(mixed).has_value());
    EXPECT_FALSE(
        even_slabs(slabs({quads(0, 1, 0, 1, 2, 2), quads(0, 1, 0, 1, 2, 2, 1.0)})).has_value());
    EXPECT_FALSE(even_slabs(slabs({quads(0, 1, 0, 1, 2, 2),
                                   square([](double x, double y) { return Vec3(x, 0.0, y); })}))
                     .has_value());
    EXPECT_TRUE(even_slabs({brick({0, 0, 0}, 0.5, {2, 2, 2}), brick({1, 0, 0}, 0.5, {2, 2, 2})})
                    .has_value());
}

TEST(PlaneSlab, HasOneThicknessWhateverTheOrderOfTheCells) {
    const auto place = [](double x, double y) { return Vec3(1.1 * x, 0.3 * y + 0.7 * x * x, 0.0); };
    const auto forward = square(place);
    auto backward = empty_block();
    backward->SetPoints(forward->GetPoints());
    for (vtkIdType i = forward->GetNumberOfCells(); i-- > 0;)
        backward->InsertNextCell(forward->GetCellType(i), forward->GetCell(i)->GetPointIds());
    EXPECT_EQ(marked_slab(*slab_of(*forward).value())->thickness,
              marked_slab(*slab_of(*backward).value())->thickness);
}

TEST(PlaneSlab, HasTheThicknessOfTheWholePlaneHoweverItIsCutIntoPieces) {
    const auto thickness = [](std::initializer_list<GridPointer> pieces) {
        const auto blocks = slabs(pieces);
        EXPECT_TRUE(even_slabs(blocks).has_value());
        return marked_slab(*blocks.front())->thickness;
    };
    const auto with_ghosts = [](GridPointer piece, std::set<vtkIdType> ghosts) {
        auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
        marks->SetName(vtkDataSetAttributes::GhostArrayName());
        for (vtkIdType i = 0; i < piece->GetNumberOfCells(); ++i)
            marks->InsertNextValue(ghosts.contains(i) ? vtkDataSetAttributes::DUPLICATECELL : 0);
        piece->GetCellData()->AddArray(marks);
        return piece;
    };
    const double whole = thickness({quads(0, 3, 0, 1, 3, 7)});
    EXPECT_EQ(thickness({quads(0, 1, 0, 1, 1, 7), quads(1, 3, 0, 1, 2, 7)}), whole);
    EXPECT_EQ(thickness({with_ghosts(quads(0, 3, 0, 10.0 / 7, 3, 10),
                                     {21, 22, 23, 24, 25, 26, 27, 28, 29}),
                         with_ghosts(quads(0, 3, 1, 2, 3, 1), {0, 1, 2})}),
              whole);
}

TEST(PlaneSlab, IsMadeOfTheFlatCellsWhereEdgesAndCornersAreCellsToo) {
    auto plane = quads(0, 1, 0, 1, 2, 2);
    auto mixed = empty_block();
    mixed->SetPoints(plane->GetPoints());
    add_cell(*mixed, VTK_VERTEX, {0});
    add_cell(*mixed, VTK_LINE, {0, 1});
    for (vtkIdType i = 0; i < plane->GetNumberOfCells(); ++i)
        mixed->InsertNextCell(VTK_QUAD, plane->GetCell(i)->GetPointIds());
    add_array(*mixed, false, "x", 1, [](const Vec3& p, int) { return p.x; });
    const auto part = fluid_part(*mixed, "flow.vtu");
    ASSERT_TRUE(part.has_value()) << part.error().message;
    ASSERT_EQ((*part)->GetNumberOfCells(), 4);
    EXPECT_EQ((*part)->GetCellData()->GetArray("x")->GetTuple1(0), 0.25);
    EXPECT_EQ((*part)->GetCellData()->GetArray("x")->GetTuple1(1), 0.75);
}

TEST(PlaneSlab, LacksTheCellsThatAStructuredPlaneBlanks) {
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(4, 4, 1);
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (int i = 0; i < 16; ++i)
        points->InsertNextPoint(i % 4, i / 4, 0.0);
    grid->SetPoints(points);
    grid->BlankCell(4);
    const auto slab = slab_of(*grid);
    ASSERT_TRUE(slab.has_value());
    EXPECT_EQ(marked_slab(**slab)->thickness, 1.0);
    const std::vector<vtkSmartPointer<vtkDataSet>> blocks{*slab};
    const auto assembly = assemble_grid(blocks, {});
    ASSERT_TRUE(assembly.has_value()) << assembly.error().message;
    EXPECT_EQ(assembly->source_cells, 8u);
}

TEST(PlaneSlab, IsNotMadeOfWhatIsNoPlane) {
    EXPECT_FALSE(slab_of(*square([](double x, double y) { return Vec3(x, y, 1e-3 * x * y); })));
    EXPECT_FALSE(slab_of(*brick({0, 0, 0}, 1.0, {2, 2, 2})));
    EXPECT_FALSE(slab_of(*square([](double x, double) { return Vec3(x, 0.0, 0.0); })));
    auto curved = empty_block();
    for (int i = 0; i < 6; ++i)
        add_point(*curved, {i % 3, i / 3, 0});
    add_cell(*curved, VTK_QUADRATIC_TRIANGLE, {0, 2, 3, 1, 4, 5});
    EXPECT_FALSE(slab_of(*curved));
}

TEST(PlaneSlab, HasTheThirdOfEachVelocityAmongAThousandScalars) {
    std::vector<core::FieldInfo> scalars;
    const auto add = [&](const std::string& name) {
        scalars.push_back({name, 1, core::FieldInfo::Source::Point, {}, {}});
    };
    for (int i = 0; i < 1000; ++i)
        add("velocity_xyz_123_uvw_" + std::to_string(i));
    add("velocity_x");
    add("velocity_z");
    add("u");
    EXPECT_EQ(third_components(scalars, 1), (std::vector<std::string>{"velocity_y"}));
    EXPECT_TRUE(third_components(scalars, 2).empty());
    add("w");
    EXPECT_EQ(third_components(scalars, 1).size(), 2u);
}

} // namespace
} // namespace wakesurf::importer::plane_slab_test
