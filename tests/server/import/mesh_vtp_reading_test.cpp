// VTK itself reads what mesh_vtp writes: the judge of the format.
#include "protocol/mesh_vtp.hpp"
#include "tests/support/small_mesh.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>

namespace wakesurf::protocol {

namespace {

vtkSmartPointer<vtkPolyData> read_by_vtk(const std::string& bytes) {
    const auto path = std::filesystem::path(testing::TempDir()) / "mesh_vtp_reading_test.vtp";
    std::ofstream(path, std::ios::binary) << bytes;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    std::filesystem::remove(path);
    return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

} // namespace

TEST(MeshVtp, IsReadByVtkWithPolygonsArraysAndMetadata) {
    const auto mesh = tests::small_mesh();
    const auto data = read_by_vtk(mesh_vtp(mesh, {.rake = {{0, 0, 0}, {0.1, 0, 1}},
                                                  .to = 2,
                                                  .separation = 0.1,
                                                  .dataset = "Zyl\xc3\xbc",
                                                  .version = "1"}));
    ASSERT_TRUE(data);
    ASSERT_EQ(data->GetNumberOfPoints(), 8);
    ASSERT_EQ(data->GetNumberOfPolys(), 3);
    EXPECT_EQ(data->GetPolys()->GetCellSize(0), 5);
    EXPECT_EQ(data->GetPoint(6)[2], 1.0 / 3);
    for (const auto* name :
         {"s", "t", "speed", "velocity", "deformation", "component", "approximated"})
        EXPECT_TRUE(data->GetPointData()->HasArray(name)) << name;
    EXPECT_EQ(data->GetPointData()->GetArray("speed")->GetTuple1(3), 5.0);
    EXPECT_EQ(data->GetFieldData()->GetArray("separation")->GetTuple1(0), 0.1);
    EXPECT_EQ(data->GetFieldData()->GetArray("rake")->GetTuple3(1)[0], 0.1);
    auto* dataset = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("dataset"));
    ASSERT_TRUE(dataset);
    EXPECT_EQ(dataset->GetValue(0), "Zyl\xc3\xbc");
}

TEST(MeshVtp, IsReadByVtkWhenTheSurfaceIsEmpty) {
    const auto data = read_by_vtk(mesh_vtp({}, {.dataset = "d", .version = "1"}));
    ASSERT_TRUE(data);
    EXPECT_EQ(data->GetNumberOfPolys(), 0);
}

} // namespace wakesurf::protocol
