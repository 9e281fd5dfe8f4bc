#include "importer/assembly/node_values.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>
#include <vtkCellDataToPointData.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <cmath>

namespace wakesurf::importer::node_values_test {
namespace {

using namespace tests;
using core::FieldInfo;
using core::Vec3;
using Pointers = std::vector<vtkSmartPointer<vtkDataSet>>;

const FieldParts cell_velocity{{{"U", 3, FieldInfo::Source::Cell, {}, {}}}, {}, 3};
const FieldParts point_velocity{{{"U", 3, FieldInfo::Source::Point, {}, {}}}, {}, 3};

double wavy(const Vec3& p, int c) {
    return std::sin(3 * p.x + c) + p.y * p.z - c;
}

std::vector<float>
values(const Pointers& blocks, const FieldParts& field, std::span<const std::uint32_t> still = {}) {
    const auto assembly = assemble_grid(blocks);
    EXPECT_TRUE(assembly.has_value());
    const auto out = node_values(*assembly, blocks, field, still);
    EXPECT_TRUE(out.has_value()) << out.error().message;
    return out.value_or(std::vector<float>());
}

// All nodes are points in these blocks, in their order.
void expect_vtk_average(vtkDataSet& data) {
    add_array(data, false, "U", 3, wavy);
    auto filter = vtkSmartPointer<vtkCellDataToPointData>::New();
    filter->SetInputData(&data);
    filter->Update();
    vtkDataArray* wanted = filter->GetOutput()->GetPointData()->GetArray("U");
    const auto got = values({&data}, cell_velocity);
    ASSERT_EQ(got.size(), static_cast<std::size_t>(3 * wanted->GetNumberOfTuples()));
    for (vtkIdType i = 0; i < wanted->GetNumberOfTuples(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(got[static_cast<std::size_t>(3 * i + c)], wanted->GetComponent(i, c), 1e-6)
                << data.GetClassName() << " point "
                << i; // two roundings to float of values up to 4
}

TEST(NodeValues, AverageCellsAsVtkDoesInEveryKindOfBlock) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(4, 5, 6);
    image->SetSpacing(0.1, 0.2, 0.3);
    expect_vtk_average(*image);
    auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
    auto axis = vtkSmartPointer<vtkDoubleArray>::New();
    for (const double x : {0.0, 0.3, 0.4, 1.0})
        axis->InsertNextValue(x);
    rectilinear->SetDimensions(4, 4, 4);
    rectilinear->SetXCoordinates(axis);
    rectilinear->SetYCoordinates(axis);
    rectilinear->SetZCoordinates(axis);
    expect_vtk_average(*rectilinear);
    auto structured = vtkSmartPointer<vtkStructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 5; ++i)
                points->InsertNextPoint(i + 0.1 * j, j + 0.2 * k, k);
    structured->SetDimensions(5, 4, 3);
    structured->SetPoints(points);
    expect_vtk_average(*structured);
    expect_vtk_average(*brick({0, 0, 0}, 0.5, {3, 2, 4}));
}

TEST(NodeValues, CountAPolyhedronOnceHoweverItIsCut) {
    auto grid = refined_block();
    add_array(*grid, false, "U", 3, wavy);
    auto filter = vtkSmartPointer<vtkCellDataToPointData>::New();
    filter->SetInputData(grid);
    filter->Update();
    vtkDataArray* wanted = filter->GetOutput()->GetPointData()->GetArray("U");
    const auto got = values({grid}, cell_velocity);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(got[static_cast<std::size_t>(3 * i + c)], wanted->GetComponent(i, c), 1e-6);
}

TEST(NodeValues, AverageAcrossBlocksAsIfTheyWereOne) {
    auto left = brick({0, 0, 0}, 1.0, {2, 1, 1});
    auto right = brick({2, 0, 0}, 1.0, {1, 1, 1});
    add_array(*left, false, "U", 3, [](const Vec3& p, int) { return p.x; });
    add_array(*right, false, "U", 3, [](const Vec3& p, int) { return p.x; });
    const auto got = values({left, right}, cell_velocity);
    EXPECT_FLOAT_EQ(got[3 * 2], 2.0f); // cells at 1.5 and 2.5 meet there
    EXPECT_FLOAT_EQ(got[3 * 1], 1.0f);
}

TEST(NodeValues, CopyPointsAndInterpolateWhatWasAdded) {
    auto grid = refined_block();
    const auto linear = [](const Vec3& p, int c) { return 1.0 + p.x - 2.0 * p.y + (c + 1) * p.z; };
    add_array(*grid, true, "U", 3, linear);
    const Pointers blocks{grid};
    const auto assembly = assemble_grid(blocks);
    const auto got = node_values(*assembly, blocks, point_velocity);
    const auto& points = std::get<core::CellMesh>(assembly->grid).points;
    ASSERT_GT(assembly->added.size(), 4u);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR((*got)[3 * i + static_cast<std::size_t>(c)], linear(points[i], c), 2e-6);
}

TEST(NodeValues, AreZeroOnWallsBeforeAddedNodesAreInterpolated) {
    auto grid = refined_block();
    add_array(*grid, true, "U", 3, [](const Vec3&, int) { return 1.0; });
    std::vector<std::uint32_t> still;
    const Pointers blocks{grid};
    const auto assembly = assemble_grid(blocks);
    for (std::uint32_t i = 0; i < assembly->source_nodes; ++i)
        still.push_back(i);
    const auto got = node_values(*assembly, blocks, point_velocity, still);
    EXPECT_TRUE(std::all_of(got->begin(), got->end(), [](float v) { return v == 0.0f; }));
}

TEST(NodeValues, OfAWedgeAreTurnedToWhereTheNodesAre) {
    auto grid = brick({0, 0, -0.5}, 1.0, {2, 2, 1});
    add_array(*grid, false, "U", 3, [](const Vec3&, int c) {
        return c == 0 ? 4.0 : c == 1 ? 2.0 : 0.5;
    });
    const Pointers blocks{grid};
    auto assembly = assemble_mesh(blocks, {}).value();
    auto& mesh = std::get<core::CellMesh>(assembly.grid);
    mesh.axis = core::SymmetryAxis{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.points[0].z = 0.0; // on the axis
    const auto got = node_values(assembly, blocks, cell_velocity).value();
    EXPECT_FLOAT_EQ(got[0], 4.0f);
    EXPECT_FLOAT_EQ(got[1], 0.0f);
    EXPECT_FLOAT_EQ(got[2], 0.0f);
    for (std::size_t i = 1; i < mesh.points.size(); ++i) {
        const Vec3& p = mesh.points[i];
        const double radius = std::hypot(p.y, p.z);
        const Vec3 v(got[3 * i], got[3 * i + 1], got[3 * i + 2]);
        EXPECT_NEAR(v.x, 4.0, 1e-6);
        EXPECT_NEAR((v.y * p.y + v.z * p.z) / radius, 2.0, 1e-6) << "away from the axis";
        EXPECT_NEAR((v.z * p.y - v.y * p.z) / radius, 0.5, 1e-6) << "round it";
    }
}

TEST(NodeValues, DivideAMomentumAndJoinComponents) {
    auto grid = brick({0, 0, 0}, 1.0, {1, 1, 1});
    add_array(*grid, true, "Momentum", 3,
              [](const Vec3& p, int c) { return (2.0 + p.x) * (c + 1); });
    add_array(*grid, true, "Density", 1, [](const Vec3& p, int) { return 2.0 + p.x; });
    for (const auto& [name, value] : {std::pair{"u", 1.0}, {"v", 2.0}, {"w", 3.0}})
        add_array(*grid, true, name, 1, [value = value](const Vec3&, int) { return value; });
    const auto point = [](const char* name, int components) {
        return FieldInfo{name, components, FieldInfo::Source::Point, {}, {}};
    };
    const auto divided = values({grid}, {{point("Momentum", 3)}, {point("Density", 1)}, 3});
    const auto joined = values({grid}, {{point("u", 1), point("v", 1), point("w", 1)}, {}, 3});
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_FLOAT_EQ(divided[i], static_cast<float>(i % 3 + 1));
        EXPECT_FLOAT_EQ(joined[i], static_cast<float>(i % 3 + 1));
    }
}

TEST(NodeValues, AreNoNumberWhereTheSourceHasNoneThatFits) {
    auto grid = brick({0, 0, 0}, 1.0, {1, 1, 1});
    add_array(*grid, true, "U", 3, [](const Vec3& p, int) {
        return p.x > 0.5 ? 1e300 : p.y > 0.5 ? std::nan("") : p.z;
    });
    const auto got = values({grid}, point_velocity);
    EXPECT_TRUE(std::isnan(got[3 * 1]));
    EXPECT_TRUE(std::isnan(got[3 * 2]));
    EXPECT_EQ(got[3 * 4], 1.0f);
}

} // namespace
} // namespace wakesurf::importer::node_values_test
