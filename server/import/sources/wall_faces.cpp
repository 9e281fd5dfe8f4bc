#include "server/import/sources/wall_faces.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

namespace wakesurf::server {

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

} // namespace wakesurf::server
