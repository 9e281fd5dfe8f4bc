#include "tests/bench/vtk/cell_field.hpp"

#include "tests/bench/support/interleaved.hpp"

#include <vtkCellType.h>
#include <vtkPoints.h>

namespace wakesurf::bench {

VtkCellField::VtkCellField(const core::CellMesh& mesh, std::span<const float> velocity)
    : grid_(vtkSmartPointer<vtkUnstructuredGrid>::New()),
      locator_(vtkSmartPointer<vtkStaticCellLocator>::New()),
      cell_(vtkSmartPointer<vtkGenericCell>::New()), velocity_(velocity) {
    const auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (const core::Vec3& p : mesh.points)
        points->InsertNextPoint(p.x, p.y, p.z);
    grid_->SetPoints(points);
    grid_->Allocate(static_cast<vtkIdType>(mesh.cells.size()));
    constexpr int type[] = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON};
    for (const core::MeshCell& cell : mesh.cells) {
        const std::array<vtkIdType, 8> nodes = [&] {
            std::array<vtkIdType, 8> all{};
            for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
                all[i] = cell.node[i];
            return all;
        }();
        grid_->InsertNextCell(type[static_cast<std::size_t>(cell.shape)],
                              static_cast<vtkIdType>(core::node_count(cell.shape)), nodes.data());
    }
    locator_->SetDataSet(grid_);
    build_seconds_ = seconds_of([&] { locator_->BuildLocator(); });
}

bool VtkCellField::find(const core::Vec3& p) {
    double x[3] = {p.x, p.y, p.z};
    double pcoords[3];
    has_cell_ = locator_->FindCell(x, 0.0, cell_, pcoords, weight_.data()) >= 0;
    return has_cell_;
}

bool VtkCellField::velocity(const core::Vec3& p, core::Vec3& v) {
    ++asked;
    const double x[3] = {p.x, p.y, p.z};
    double pcoords[3];
    double distance2 = 0.0;
    int sub_id = 0;
    if (has_cell_ &&
        cell_->EvaluatePosition(x, nullptr, sub_id, pcoords, distance2, weight_.data()) == 1)
        ++in_last_cell;
    else if (!find(p))
        return false;
    v = core::Vec3(0.0);
    for (vtkIdType i = 0; i < cell_->GetNumberOfPoints(); ++i) {
        const float* at = velocity_.data() + 3 * cell_->GetPointId(static_cast<int>(i));
        v += weight_[static_cast<std::size_t>(i)] * core::Vec3(at[0], at[1], at[2]);
    }
    return true;
}

} // namespace wakesurf::bench
