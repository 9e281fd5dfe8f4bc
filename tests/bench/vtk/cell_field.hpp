// The peer on meshes of cells: vtkStaticCellLocator behind a cache of the last cell, as VTK's interpolated
// velocity fields use it, without their overhead.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <vtkGenericCell.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstddef>
#include <span>

namespace wakesurf::bench {

class VtkCellField {
  public:
    /// Builds the locator. @param velocity  float3 a node; kept by reference
    VtkCellField(const core::CellMesh& mesh, std::span<const float> velocity);

    /// Returns false outside.
    bool velocity(const core::Vec3& p, core::Vec3& v);

    /// Finds a cell by the locator alone.
    bool find(const core::Vec3& p);

    double build_seconds() const { return build_seconds_; }

    std::size_t asked = 0;
    std::size_t in_last_cell = 0;

  private:
    vtkSmartPointer<vtkUnstructuredGrid> grid_;
    vtkSmartPointer<vtkStaticCellLocator> locator_;
    vtkSmartPointer<vtkGenericCell> cell_;
    std::span<const float> velocity_;
    bool has_cell_ = false;
    std::array<double, 8> weight_{};
    double build_seconds_ = 0.0;
};

} // namespace wakesurf::bench
