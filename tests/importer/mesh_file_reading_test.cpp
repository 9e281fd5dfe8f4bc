// VTK itself reads the files we write: the judge of the formats, and what ParaView shows of them.
#include "protocol/files/mesh_file.hpp"
#include "tests/support/refined_surface.hpp"
#include "tests/support/small_mesh.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>

namespace wakesurf::protocol::mesh_file_reading_test {

namespace {

template <class Reader>
vtkSmartPointer<Reader> read(const std::string& bytes, const std::string& extension) {
    const auto path = std::filesystem::path(testing::TempDir()) / ("mesh_reading_test" + extension);
    std::ofstream(path, std::ios::binary) << bytes;
    const auto reader = vtkSmartPointer<Reader>::New();
    reader->SetFileName(path.c_str());
    reader->Update();
    std::filesystem::remove(path);
    return reader;
}

vtkSmartPointer<vtkPolyData> read_by_vtk(const std::string& bytes) {
    const auto reader = read<vtkXMLPolyDataReader>(bytes, ".vtp");
    return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

std::string
file(MeshFormat format, const MeshScalars& scalars = {}, GlbCoding glb = GlbCoding::Draco) {
    return mesh_file(format, tests::refined_surface(),
                     {.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {1, 0, 0}}},
                      .dataset = "d",
                      .version = "1"},
                     scalars, glb)
        .value();
}

MeshScalars pressure() {
    MeshScalars out;
    out["p (mean)"].resize(tests::refined_surface().vertices(), 2.5F);
    return out;
}

} // namespace

TEST(MeshVtp, IsReadByVtkWithPolygonsArraysAndMetadata) {
    const auto mesh = tests::small_mesh();
    const auto data =
        read_by_vtk(mesh_file(MeshFormat::Vtp, mesh,
                              {.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {0.1, 0, 1}}},
                               .parameters = {.to = 2},
                               .separation = 0.1,
                               .dataset = "Zyl\xc3\xbc",
                               .version = "1"},
                              {})
                        .value());
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
    const auto data =
        read_by_vtk(mesh_file(MeshFormat::Vtp, {}, {.dataset = "d", .version = "1"}, {}).value());
    ASSERT_TRUE(data);
    EXPECT_EQ(data->GetNumberOfPolys(), 0);
}

TEST(MeshVtp, OfManyBlocksIsReadByVtkToTheBit) {
    core::QuadComplex mesh;
    constexpr std::size_t vertices = 100'000; // 2.4 MB of points, 2^18 bytes a block
    for (std::size_t v = 0; v < vertices; ++v)
        mesh.position.emplace_back(1.0 / double(v + 1), double(v % 977), 1e-9 * double(v));
    mesh.velocity.resize(vertices);
    mesh.s.resize(vertices);
    mesh.t.resize(vertices);
    mesh.component.resize(vertices);
    mesh.approximated.resize(vertices);
    const auto data =
        read_by_vtk(mesh_file(MeshFormat::Vtp, mesh, {.dataset = "d", .version = "1"}, {}).value());
    ASSERT_TRUE(data);
    ASSERT_EQ(data->GetNumberOfPoints(), vtkIdType{vertices});
    for (vtkIdType v = 0; v < vtkIdType{vertices}; ++v)
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_EQ(data->GetPoint(v)[axis], mesh.position[std::size_t(v)][axis]);
}

TEST(MeshPly, IsReadByVtkWithColoursNormalsAndTextureCoordinates) {
    const auto mesh = tests::refined_surface();
    const auto reader = read<vtkPLYReader>(file(MeshFormat::Ply, pressure()), ".ply");
    vtkPolyData* data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfPoints(), vtkIdType(mesh.vertices()));
    EXPECT_GT(data->GetNumberOfPolys(), 0);
    vtkPointData* arrays = data->GetPointData();
    ASSERT_TRUE(arrays->GetNormals() && arrays->GetTCoords() && arrays->GetArray("RGB"));
    for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
        EXPECT_EQ(arrays->GetTCoords()->GetComponent(v, 0), double(float(mesh.s[std::size_t(v)])));
        EXPECT_EQ(arrays->GetTCoords()->GetComponent(v, 1), double(float(mesh.t[std::size_t(v)])));
    }
    EXPECT_EQ(arrays->GetNumberOfArrays(), 3)
        << "VTK shows more of a .ply than it did: say so in protocol/files/README.md";
}

TEST(MeshGlb, WithoutDracoIsReadByVtkWithEveryArray) {
    const auto mesh = tests::refined_surface();
    const auto reader =
        read<vtkGLTFReader>(file(MeshFormat::Glb, pressure(), GlbCoding::Plain), ".glb");
    const auto parts =
        vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    parts->InitTraversal();
    ASSERT_FALSE(parts->IsDoneWithTraversal());
    auto* data = vtkPolyData::SafeDownCast(parts->GetCurrentDataObject());
    ASSERT_TRUE(data);
    ASSERT_EQ(data->GetNumberOfPoints(), vtkIdType(mesh.vertices()));
    EXPECT_GT(data->GetNumberOfPolys(), 0);
    vtkPointData* arrays = data->GetPointData();
    for (const char* name : {"_S", "_T", "_SPEED", "_VELOCITY", "_DEFORMATION", "_COMPONENT",
                             "_APPROXIMATED", "_P__MEAN_"})
        EXPECT_TRUE(arrays->HasArray(name)) << name;
    EXPECT_EQ(arrays->GetArray("_P__MEAN_")->GetTuple1(3), 2.5);
    EXPECT_EQ(arrays->GetArray("_VELOCITY")->GetComponent(5, 1), double(mesh.velocity[5].y));
}

} // namespace wakesurf::protocol::mesh_file_reading_test
