#include "importer/sources/blocks/fluid_blocks.hpp"

#include "core/base/result.hpp"
#include "importer/base/slab_mark.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkExtractCells.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

// Checks a grid: VTK's readers accept much of a damaged file that its algorithms then fail on.

// Returns the number of nodes of a cell type that has a fixed one.
int nodes_of(int type) {
    switch (type) {
    case VTK_TETRA:
        return 4;
    case VTK_PYRAMID:
        return 5;
    case VTK_WEDGE:
        return 6;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
        return 8;
    case VTK_PENTAGONAL_PRISM:
        return 10;
    case VTK_HEXAGONAL_PRISM:
        return 12;
    case VTK_TRIANGLE:
        return 3;
    case VTK_QUAD:
    case VTK_PIXEL:
        return 4;
    default:
        return 0;
    }
}

// Returns 3 for VTK's solid cells of any order, 2 for flat ones and so on; -1 for types that VTK does not
// have.
int cell_dimension(int type) {
    static const std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensions = [] {
        std::array<int, VTK_NUMBER_OF_CELL_TYPES> out{};
        for (int i = 0; i < VTK_NUMBER_OF_CELL_TYPES; ++i) {
            const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(i));
            out[static_cast<std::size_t>(i)] = cell ? cell->GetCellDimension() : -1;
        }
        out[VTK_EMPTY_CELL] = 0;
        out[VTK_POLYHEDRON] = 3;
        return out;
    }();
    return type < 0 || type >= VTK_NUMBER_OF_CELL_TYPES
               ? -1
               : dimensions[static_cast<std::size_t>(type)];
}

template <class Array>
bool all_finite_in(Array& values) {
    const auto* begin = values.GetPointer(0);
    return std::all_of(begin, begin + values.GetNumberOfValues(),
                       [](auto value) { return std::isfinite(value); });
}

bool all_finite(vtkDataArray* values) {
    if (auto* floats = vtkFloatArray::FastDownCast(values); floats != nullptr)
        return all_finite_in(*floats);
    if (auto* doubles = vtkDoubleArray::FastDownCast(values); doubles != nullptr)
        return all_finite_in(*doubles);
    for (vtkIdType i = 0; values != nullptr && i < values->GetNumberOfTuples(); ++i)
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
            if (!std::isfinite(values->GetComponent(i, c)))
                return false;
    return true;
}

core::Result<void> check_points(vtkPoints* points, vtkIdType wanted, const std::string& file) {
    if (points == nullptr || points->GetNumberOfPoints() != wanted)
        return core::fail(Error::Code::Corrupt, file + " does not have the nodes that it declares");
    if (!all_finite(points->GetData()))
        return core::fail(Error::Code::Corrupt,
                          file + " has a node whose coordinates are not finite numbers");
    return {};
}

// Checks {faces, {nodes, id, id, ...}, ...} of every polyhedron, as VTK stores them.
bool sound_faces(vtkUnstructuredGrid& grid, vtkIdType cell, vtkIdType points) {
    vtkIdTypeArray* faces = grid.GetFaces();
    vtkIdTypeArray* locations = grid.GetFaceLocations();
    if (faces == nullptr || locations == nullptr || cell >= locations->GetNumberOfValues())
        return false;
    const vtkIdType size = faces->GetNumberOfValues();
    vtkIdType at = locations->GetValue(cell);
    if (at < 0 || at >= size)
        return false;
    vtkIdType count = faces->GetValue(at++);
    if (count < 4)
        return false;
    for (; count > 0; --count) {
        if (at >= size)
            return false;
        const vtkIdType nodes = faces->GetValue(at++);
        if (nodes < 3 || nodes > size - at)
            return false;
        for (vtkIdType i = 0; i < nodes; ++i, ++at)
            if (faces->GetValue(at) < 0 || faces->GetValue(at) >= points)
                return false;
    }
    return true;
}

template <class Array>
bool rise(Array& offsets, vtkIdType last) {
    const auto* begin = offsets.GetPointer(0);
    const auto* end = begin + offsets.GetNumberOfValues();
    return begin == end ? last == 0
                        : *begin == 0 && *(end - 1) == last && std::is_sorted(begin, end);
}

// Returns true if offsets rise from 0 to the length of the connectivity: looking a cell up is safe.
bool sound_offsets(vtkCellArray& cells) {
    const vtkIdType last = cells.GetConnectivityArray()->GetNumberOfTuples();
    return cells.IsStorage64Bit() ? rise(*cells.GetOffsetsArray64(), last)
                                  : rise(*cells.GetOffsetsArray32(), last);
}

// Reports the first invalid cell, and why. It reads VTK's arrays directly: asking cell by cell costs as much
// as reading.
template <class Array>
std::optional<std::string>
fault_of_cells(vtkUnstructuredGrid& grid, Array& offsets, Array& connectivity) {
    const vtkIdType points = grid.GetNumberOfPoints();
    const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
    const auto* begin = offsets.GetPointer(0);
    const auto* nodes = connectivity.GetPointer(0);
    std::array<int, 256> dimension{};
    std::array<int, 256> wanted{};
    for (int type = 0; type < 256; ++type) {
        dimension[static_cast<std::size_t>(type)] = cell_dimension(type);
        wanted[static_cast<std::size_t>(type)] = nodes_of(type);
    }
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
        const auto type = types[i];
        const vtkIdType count = begin[i + 1] - begin[i];
        const auto name = [&] { return "cell " + std::to_string(i); };
        if (dimension[type] < 0)
            return name() + " is of the unknown type " + std::to_string(type);
        if (wanted[type] != 0 && count != wanted[type])
            return name() + " has " + std::to_string(count) + " nodes";
        for (auto n = begin[i]; n < begin[i + 1]; ++n)
            if (nodes[n] < 0 || nodes[n] >= points)
                return name() + " has a node that is not there";
        if (type == VTK_POLYHEDRON && !sound_faces(grid, i, points))
            return name() + " has damaged faces";
    }
    return std::nullopt;
}

core::Result<void> check_axis(vtkDataArray* axis, char name, int nodes, const std::string& file) {
    if (axis == nullptr || axis->GetNumberOfTuples() != nodes || !all_finite(axis))
        return core::fail(Error::Code::Corrupt,
                          file + " has damaged coordinates along " + std::string(1, name));
    for (vtkIdType i = 1; i < axis->GetNumberOfTuples(); ++i)
        if (!(axis->GetTuple1(i - 1) < axis->GetTuple1(i)))
            return core::fail(Error::Code::Corrupt,
                              file + " has coordinates along " + std::string(1, name) +
                                  " that do not increase at node " + std::to_string(i));
    return {};
}

core::Result<void> check_image(vtkImageData& image, const std::string& file) {
    const double* direction = image.GetDirectionMatrix()->GetData();
    for (int i = 0; i < 9; ++i)
        if (direction[i] != (i % 4 == 0 ? 1.0 : 0.0))
            return core::fail(Error::Code::Unsupported,
                              file + " is rotated: its Direction is not the identity",
                              "resample it to an axis-aligned grid first");
    constexpr double largest = 1e100; // the square of such a length is finite too
    for (int axis = 0; axis < 3; ++axis)
        if (!(image.GetSpacing()[axis] >= 1.0 / largest) ||
            !(std::abs(image.GetBounds()[2 * axis]) <= largest) ||
            !(std::abs(image.GetBounds()[2 * axis + 1]) <= largest))
            return core::fail(Error::Code::Corrupt,
                              file + ": the grid's origin or spacing is not usable");
    return {};
}

// Checks an unstructured grid: coordinates finite, cells of known types with as many nodes as their type has,
// all there, and so of the faces of polyhedra. Error: Corrupt, naming `file` and the first cell at fault.
core::Result<void> check_mesh(vtkUnstructuredGrid& grid, const std::string& file) {
    const vtkIdType cells = grid.GetNumberOfCells();
    if (cells == 0)
        return core::fail(Error::Code::Corrupt, file + " has no cells");
    const vtkIdType points = grid.GetNumberOfPoints();
    if (auto sound = check_points(grid.GetPoints(), points, file); !sound)
        return sound;
    if (grid.GetCellTypesArray() == nullptr ||
        grid.GetCellTypesArray()->GetNumberOfValues() != cells ||
        grid.GetCells()->GetNumberOfCells() != cells || !sound_offsets(*grid.GetCells()))
        return core::fail(Error::Code::Corrupt, file + " has a damaged list of cells");
    const auto fault = grid.GetCells()->IsStorage64Bit()
                           ? fault_of_cells(grid, *grid.GetCells()->GetOffsetsArray64(),
                                            *grid.GetCells()->GetConnectivityArray64())
                           : fault_of_cells(grid, *grid.GetCells()->GetOffsetsArray32(),
                                            *grid.GetCells()->GetConnectivityArray32());
    if (fault)
        return core::fail(Error::Code::Corrupt, file + " has a damaged cell: " + *fault);
    return {};
}

// Checks a structured grid with at least two nodes along every axis: coordinates finite; spacings and the
// axes of rectilinear grids positive. Error: Corrupt; Unsupported (a rotated image).
core::Result<void> check_grid(vtkDataSet& grid, const std::string& file) {
    if (auto* image = vtkImageData::SafeDownCast(&grid); image != nullptr)
        return check_image(*image, file);
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&grid); rectilinear != nullptr) {
        const std::array axes{rectilinear->GetXCoordinates(), rectilinear->GetYCoordinates(),
                              rectilinear->GetZCoordinates()};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (auto sound =
                    check_axis(axes[axis], "xyz"[axis], rectilinear -> GetDimensions()[axis], file);
                !sound)
                return sound;
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(&grid); structured != nullptr) {
        std::array<int, 3> n{};
        structured->GetDimensions(n.data());
        return check_points(structured->GetPoints(), vtkIdType{n[0]} * n[1] * n[2], file);
    }
    return {};
}

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

// Returns the cells of a dimension, the grid itself if it has no others; null if it has none. REQUIRES: check_mesh.
vtkSmartPointer<vtkUnstructuredGrid> cells_of(vtkUnstructuredGrid& grid, int dimension) {
    const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
        if (cell_dimension(types[i]) == dimension)
            ids->InsertNextId(i);
    if (ids->GetNumberOfIds() == 0)
        return nullptr;
    if (ids->GetNumberOfIds() == grid.GetNumberOfCells())
        return &grid;
    auto extract = vtkSmartPointer<vtkExtractCells>::New();
    extract->SetInputData(&grid);
    extract->SetCellList(ids);
    extract->Update();
    return extract->GetOutput();
}

core::Result<vtkSmartPointer<vtkDataSet>> solid_cells_of(vtkUnstructuredGrid& grid,
                                                         const std::string& file) {
    if (auto sound = check_mesh(grid, file); !sound)
        return tl::unexpected(sound.error());
    if (const auto solid = cells_of(grid, 3))
        return vtkSmartPointer<vtkDataSet>(solid);
    // Meshes of a plane often have its edges and corners as cells too.
    if (const auto flat = cells_of(grid, 2))
        if (auto slab = slab_of(*flat))
            return std::move(*slab);
    return core::fail(Error::Code::Unsupported,
                      file +
                          " has no cells in space, and its flat ones do not lie in one plane, or "
                          "are curved",
                      "write the cells between the surfaces as well");
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
    data.GetFieldData()->RemoveArray(slab_name); // a file's own would be taken for slab_of's
    if (const auto dimensions = dimensions_of(data)) {
        if (auto sound = check_grid(data, file); !sound)
            return tl::unexpected(sound.error());
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((*dimensions)[axis] < 2) {
                if (auto slab = slab_of(data))
                    return std::move(*slab);
                return core::fail(Error::Code::Unsupported,
                                  file + " has " + std::to_string((*dimensions)[axis]) +
                                      " nodes along " + "xyz"[axis] + ", and is not a plane",
                                  "write it with two nodes or more along two axes at least");
            }
        return vtkSmartPointer<vtkDataSet>(&data);
    }
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data); grid != nullptr)
        return solid_cells_of(*grid, file);
    return core::fail(Error::Code::Unsupported,
                      file + " is a surface, not a grid of cells in space");
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
