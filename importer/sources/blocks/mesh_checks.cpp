#include "importer/sources/blocks/mesh_checks.hpp"

#include <vtkCellArray.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace wakesurf::importer {

using core::Error;

namespace {

// Nodes of the cell types that have a fixed number of them.
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

// {faces, {nodes, id, id, ...}, ...} of every polyhedron, as VTK keeps them.
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

// Offsets rise from 0 to the length of the connectivity: looking a cell up is safe.
bool sound_offsets(vtkCellArray& cells) {
    const vtkIdType last = cells.GetConnectivityArray()->GetNumberOfTuples();
    return cells.IsStorage64Bit() ? rise(*cells.GetOffsetsArray64(), last)
                                  : rise(*cells.GetOffsetsArray32(), last);
}

// The first cell that is none, and why. Straight through VTK's arrays: asking cell by cell costs as much as reading.
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
    constexpr double largest = 1e100; // of a length whose square is a number too
    for (int axis = 0; axis < 3; ++axis)
        if (!(image.GetSpacing()[axis] >= 1.0 / largest) ||
            !(std::abs(image.GetBounds()[2 * axis]) <= largest) ||
            !(std::abs(image.GetBounds()[2 * axis + 1]) <= largest))
            return core::fail(Error::Code::Corrupt,
                              file + ": the grid's origin or spacing is not usable");
    return {};
}

} // namespace

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

} // namespace wakesurf::importer
