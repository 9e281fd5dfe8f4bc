#include "importer/filter/polygonal_data.hpp"

#include "protocol/files/mesh_vtp.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

#include <cstring>
#include <string_view>

namespace wakesurf::importer {

namespace {

vtkSmartPointer<vtkDataArray> array_for(double) {
    return vtkSmartPointer<vtkDoubleArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(float) {
    return vtkSmartPointer<vtkFloatArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(const core::Vec3f&) {
    return vtkSmartPointer<vtkFloatArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(const core::Vec3&) {
    return vtkSmartPointer<vtkDoubleArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(std::uint32_t) {
    return vtkSmartPointer<vtkUnsignedIntArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(std::uint8_t) {
    return vtkSmartPointer<vtkUnsignedCharArray>::New();
}

vtkSmartPointer<vtkDataArray> array_for(std::int64_t) {
    return vtkSmartPointer<vtkTypeInt64Array>::New();
}

template <class T>
vtkSmartPointer<vtkDataArray> copied(const std::vector<T>& values, int components = 1) {
    auto array = array_for(T{});
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    if (!values.empty())
        std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(T));
    return array;
}

} // namespace

std::vector<core::Vec3> rake_points(vtkPolyData& rake) {
    vtkNew<vtkIdList> line;
    if (rake.GetNumberOfLines() > 0)
        rake.GetLines()->GetCellAtId(0, line);
    else
        for (vtkIdType i = 0; i < rake.GetNumberOfPoints(); ++i)
            line->InsertNextId(i);
    std::vector<core::Vec3> points;
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i) {
        core::Vec3 point;
        rake.GetPoint(line->GetId(i), &point.x);
        points.push_back(point);
    }
    return points;
}

void fill(vtkPolyData& output, const core::QuadComplex& mesh) {
    output.Initialize();
    vtkNew<vtkPoints> points;
    points->SetData(copied(mesh.position, 3));
    output.SetPoints(points);
    const auto polygons = protocol::vtk_polygons(mesh);
    std::vector<std::int64_t> offsets{0};
    offsets.insert(offsets.end(), polygons.offsets.begin(), polygons.offsets.end());
    vtkNew<vtkCellArray> cells;
    cells->SetData(copied(offsets), copied(polygons.connectivity));
    output.SetPolys(cells);
    protocol::each_vtk_array(
        mesh, [&]<class T>(std::string_view name, const std::vector<T>& values, int components) {
            auto array = copied(values, components);
            array->SetName(std::string(name).c_str());
            output.GetPointData()->AddArray(array);
        });
    output.GetPointData()->SetActiveScalars("speed");
    output.GetPointData()->SetActiveVectors("velocity");
}

} // namespace wakesurf::importer
