#include "importer/sources/blocks/wall_faces.hpp"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <algorithm>

namespace wakesurf::importer {

bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields) {
    const auto velocity =
        std::find_if(fields.begin(), fields.end(),
                     [](const core::FieldInfo& field) { return field.components == 3; });
    if (velocity == fields.end())
        return false;
    const bool at_cells = velocity->source == core::FieldInfo::Source::Cell;
    vtkDataArray* values = at_cells ? faces.GetCellData()->GetArray(velocity->name.c_str())
                                    : faces.GetPointData()->GetArray(velocity->name.c_str());
    if (values == nullptr || values->GetNumberOfComponents() != 3)
        return false;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
        for (int c = 0; c < 3; ++c)
            if (values->GetComponent(i, c) != 0.0)
                return false;
    return true;
}

vtkSmartPointer<vtkPolyData> faces_of(vtkDataSet& grid) {
    auto out = vtkSmartPointer<vtkPolyData>::New();
    auto* points = vtkPointSet::SafeDownCast(&grid);
    if (points == nullptr)
        return out;
    out->SetPoints(points->GetPoints());
    out->GetPointData()->ShallowCopy(grid.GetPointData());
    out->AllocateEstimate(grid.GetNumberOfCells(), 4);
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
        if (vtkCell* cell = grid.GetCell(i); cell->GetCellDimension() == 2)
            out->InsertNextCell(cell->GetCellType(), cell->GetPointIds());
    return out;
}

} // namespace wakesurf::importer
