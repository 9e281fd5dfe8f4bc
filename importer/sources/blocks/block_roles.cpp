#include "importer/sources/blocks/block_roles.hpp"

#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>

namespace wakesurf::importer {

bool is_named_wall(const std::string& patch) {
    return lower_case(patch.substr(patch.rfind('/') + 1)).find("wall") != std::string::npos;
}

bool is_still(vtkDataSet& patch, const std::vector<core::FieldInfo>& fields) {
    bool found = false;
    for (const auto& field : fields) {
        if (field.components != 3)
            continue;
        vtkDataArray* array = field.source == core::FieldInfo::Source::Point
                                  ? patch.GetPointData()->GetArray(field.name.c_str())
                                  : patch.GetCellData()->GetArray(field.name.c_str());
        if (array == nullptr || array->GetNumberOfComponents() != 3)
            continue;
        found = true;
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
            for (int c = 0; c < 3; ++c)
                if (array->GetComponent(i, c) != 0.0)
                    return false;
    }
    return found;
}

bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields) {
    const auto velocity =
        std::find_if(fields.begin(), fields.end(),
                     [](const core::FieldInfo& field) { return field.components == 3; });
    return velocity != fields.end() && is_still(faces, {*velocity});
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

core::Result<vtkSmartPointer<vtkPolyData>> surface_of(vtkDataSet& patch, const std::string& file) {
    auto out = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    if (auto* set = vtkPointSet::SafeDownCast(&patch);
        set != nullptr && set->GetPoints() != nullptr) {
        points = set->GetPoints();
    } else {
        points->SetDataTypeToDouble();
        for (vtkIdType i = 0; i < patch.GetNumberOfPoints(); ++i)
            points->InsertNextPoint(patch.GetPoint(i));
    }
    auto polygons = vtkSmartPointer<vtkCellArray>::New();
    auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < patch.GetNumberOfCells(); ++i) {
        const int type = patch.GetCellType(i);
        if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_POLYGON && type != VTK_PIXEL)
            continue;
        patch.GetCellPoints(i, nodes);
        for (vtkIdType n = 0; n < nodes->GetNumberOfIds(); ++n)
            if (nodes->GetId(n) < 0 || nodes->GetId(n) >= points->GetNumberOfPoints())
                return core::fail(core::Error::Code::Corrupt, file + " has a damaged cell: cell " +
                                                                  std::to_string(i) +
                                                                  " has a node that is not there");
        if (type == VTK_PIXEL) { // x fastest, not round
            const vtkIdType third = nodes->GetId(2);
            nodes->SetId(2, nodes->GetId(3));
            nodes->SetId(3, third);
        }
        polygons->InsertNextCell(nodes);
    }
    out->SetPoints(points);
    out->SetPolys(polygons);
    return out;
}

vtkSmartPointer<vtkPolyData> boundary_of(vtkDataSet& block) {
    auto filter = vtkSmartPointer<vtkDataSetSurfaceFilter>::New();
    filter->SetInputData(&block);
    filter->Update();
    vtkSmartPointer<vtkPolyData> out = filter->GetOutput();
    keep_only(*out, {});
    return out;
}

using core::FieldInfo;

namespace {

using Fields = std::vector<FieldInfo>;

bool has_names_of(const Fields& here, const Fields& wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const FieldInfo& field) {
        return std::any_of(here.begin(), here.end(),
                           [&](const FieldInfo& other) { return other.name == field.name; });
    });
}

bool has_vector(const Fields& here) {
    return std::any_of(here.begin(), here.end(),
                       [](const FieldInfo& field) { return field.components == 3; });
}

std::vector<bool>
find_fluid(const std::vector<Fields>& of_blocks, const Fields& all, const std::string& wish) {
    std::vector<bool> out;
    const auto velocity = choose_velocity(all, wish);
    for (const auto& here : of_blocks)
        out.push_back(velocity ? has_names_of(here, velocity->parts.arrays) : has_vector(here));
    if (std::find(out.begin(), out.end(), true) == out.end())
        out.assign(of_blocks.size(), true);
    return out;
}

} // namespace

BlockRoles block_roles(const Blocks& blocks, const std::string& velocity) {
    Fields all;
    std::vector<Fields> of_blocks(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        add_fields(*blocks[i], of_blocks[i]);
        add_fields(*blocks[i], all);
    }
    BlockRoles out{find_fluid(of_blocks, all, velocity), {}, {}};
    Blocks fluid;
    std::vector<std::string> left_out;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (out.fluid[i])
            fluid.push_back(blocks[i]);
    out.fields = common_fields(fluid);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (const FieldInfo& field : of_blocks[i])
            if (out.fluid[i] && !has_names_of(out.fields, {field}) &&
                std::find(left_out.begin(), left_out.end(), field.name) == left_out.end())
                left_out.push_back(field.name);
    out.note = only_on_some_parts(left_out);
    return out;
}

std::string only_on_some_parts(const std::vector<std::string>& names) {
    std::string out;
    for (const auto& name : names)
        out += (out.empty() ? "left out, as only some parts have them: " : ", ") + name;
    return out;
}

} // namespace wakesurf::importer
