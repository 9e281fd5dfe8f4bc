#include "importer/sources/blocks/fluid_blocks.hpp"

#include "importer/sources/blocks/mesh_checks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExtractCells.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

std::optional<std::array<int, 3>> dimensions_of(vtkDataSet& data) {
    std::array<int, 3> out{};
    if (auto* image = vtkImageData::SafeDownCast(&data); image != nullptr)
        image->GetDimensions(out.data());
    else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data); rectilinear != nullptr)
        rectilinear->GetDimensions(out.data());
    else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data); structured != nullptr)
        structured->GetDimensions(out.data());
    else
        return std::nullopt;
    return out;
}

// Ids of the three-dimensional cells.
vtkSmartPointer<vtkIdList> solid_cells(vtkUnstructuredGrid& grid) {
    auto ids = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
        if (cell_dimension(grid.GetCellType(i)) == 3)
            ids->InsertNextId(i);
    return ids;
}

core::Result<vtkSmartPointer<vtkDataSet>> solid_cells_of(vtkUnstructuredGrid& grid,
                                                         const std::string& file) {
    if (auto sound = check_mesh(grid, file); !sound)
        return tl::unexpected(sound.error());
    const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
    const auto solid = [](unsigned char type) { return cell_dimension(type) == 3; };
    const auto count = std::count_if(types, types + grid.GetNumberOfCells(), solid);
    if (count == grid.GetNumberOfCells())
        return vtkSmartPointer<vtkDataSet>(&grid);
    if (count == 0)
        return core::fail(Error::Code::Unsupported,
                          file + " is not three-dimensional: its cells are flat",
                          "extrude it by two cells or more first");
    const auto ids = solid_cells(grid);
    auto extract = vtkSmartPointer<vtkExtractCells>::New();
    extract->SetInputData(&grid);
    extract->SetCellList(ids);
    extract->Update();
    return vtkSmartPointer<vtkDataSet>(extract->GetOutput());
}

std::string unit_in(vtkDataSet& data, const FieldInfo& field) {
    vtkDataSetAttributes* attributes = data.GetPointData();
    if (field.source == FieldInfo::Source::Cell)
        attributes = data.GetCellData();
    vtkDataArray* array = attributes->GetArray(field.name.c_str());
    const bool has =
        array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()) != 0;
    return has ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : "";
}

} // namespace

bool has_solid_cells(vtkDataSet& data) {
    if (const auto dimensions = dimensions_of(data))
        return *std::min_element(dimensions->begin(), dimensions->end()) > 1;
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    if (grid == nullptr)
        return false;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
        if (cell_dimension(grid->GetCellType(i)) == 3)
            return true;
    return false;
}

core::Result<vtkSmartPointer<vtkDataSet>> fluid_part(vtkDataSet& data, const std::string& file) {
    if (const auto dimensions = dimensions_of(data)) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((*dimensions)[axis] < 2)
                return core::fail(Error::Code::Unsupported,
                                  file + " is not three-dimensional: it has " +
                                      std::to_string((*dimensions)[axis]) + " nodes along " +
                                      "xyz"[axis],
                                  "extrude it by two cells or more first");
        if (auto sound = check_grid(data, file); !sound)
            return tl::unexpected(sound.error());
        return vtkSmartPointer<vtkDataSet>(&data);
    }
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data); grid != nullptr)
        return solid_cells_of(*grid, file);
    return core::fail(Error::Code::Unsupported,
                      file + " is a surface, not a grid of cells in space");
}

core::Result<void> check_thickness(const Blocks& blocks, const std::string& file) {
    const auto dimensions = blocks.size() == 1 ? dimensions_of(*blocks.front()) : std::nullopt;
    for (std::size_t axis = 0; dimensions && axis < 3; ++axis)
        if ((*dimensions)[axis] < 3)
            return core::fail(Error::Code::Unsupported,
                              file + " is not three-dimensional: it has one cell along " +
                                  "xyz"[axis],
                              "extrude it by two cells or more first");
    return {};
}

std::vector<FieldInfo> common_fields(const Blocks& blocks) {
    std::vector<FieldInfo> out;
    for (const auto& block : blocks)
        add_fields(*block, out);
    for (const auto& block : blocks) {
        std::vector<FieldInfo> here;
        add_fields(*block, here);
        std::erase_if(out, [&](const FieldInfo& field) {
            return std::none_of(here.begin(), here.end(), [&](const FieldInfo& f) {
                return f.name == field.name && f.source == field.source &&
                       f.components == field.components;
            });
        });
    }
    for (auto& field : out)
        field.unit = unit_in(*blocks.front(), field);
    return out;
}

} // namespace wakesurf::importer
