// Small VTK blocks for tests of the conversion: bricks of hexahedra, cells given one by one.
#pragma once

#include "core/base/vec3.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace wakesurf::tests {

using GridPointer = vtkSmartPointer<vtkUnstructuredGrid>;

inline GridPointer empty_block() {
    auto grid = GridPointer::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    grid->SetPoints(points);
    return grid;
}

inline vtkIdType add_point(vtkUnstructuredGrid& grid, const core::Vec3& p) {
    return grid.GetPoints()->InsertNextPoint(p.x, p.y, p.z);
}

inline void add_cell(vtkUnstructuredGrid& grid, int type, const std::vector<vtkIdType>& points) {
    grid.InsertNextCell(type, static_cast<vtkIdType>(points.size()), points.data());
}

inline void add_polyhedron(vtkUnstructuredGrid& grid,
                           const std::vector<std::vector<vtkIdType>>& faces) {
    auto stream = vtkSmartPointer<vtkIdList>::New();
    stream->InsertNextId(static_cast<vtkIdType>(faces.size()));
    for (const auto& face : faces) {
        stream->InsertNextId(static_cast<vtkIdType>(face.size()));
        for (const vtkIdType point : face)
            stream->InsertNextId(point);
    }
    grid.InsertNextCell(VTK_POLYHEDRON, stream);
}

/// Returns hexahedra of side `h` from `lo`, n of them along each axis, x fastest; as polyhedra on request.
inline GridPointer
brick(const core::Vec3& lo, double h, std::array<int, 3> n, bool polyhedra = false) {
    auto grid = empty_block();
    for (int k = 0; k <= n[2]; ++k)
        for (int j = 0; j <= n[1]; ++j)
            for (int i = 0; i <= n[0]; ++i)
                add_point(*grid, lo + h * core::Vec3(i, j, k));
    const auto at = [&](int i, int j, int k) {
        return vtkIdType{i + (n[0] + 1) * (j + (n[1] + 1) * k)};
    };
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i) {
                const std::array<vtkIdType, 8> p{at(i, j, k),
                                                 at(i + 1, j, k),
                                                 at(i + 1, j + 1, k),
                                                 at(i, j + 1, k),
                                                 at(i, j, k + 1),
                                                 at(i + 1, j, k + 1),
                                                 at(i + 1, j + 1, k + 1),
                                                 at(i, j + 1, k + 1)};
                if (polyhedra)
                    add_polyhedron(*grid, {{p[0], p[3], p[2], p[1]},
                                           {p[4], p[5], p[6], p[7]},
                                           {p[0], p[1], p[5], p[4]},
                                           {p[1], p[2], p[6], p[5]},
                                           {p[2], p[3], p[7], p[6]},
                                           {p[3], p[0], p[4], p[7]}});
                else
                    add_cell(*grid, VTK_HEXAHEDRON, {p.begin(), p.end()});
            }
    return grid;
}

/// Returns one block of two sizes of cells: 2 x 2 x 1 cells of side 1 below 4 x 4 x 2 of side 1/2, all of
/// them polyhedra, like snappyHexMesh's: the large cells have four faces on top, and sides of five corners.
inline GridPointer refined_block() {
    auto grid = brick({0, 0, 1}, 0.5, {4, 4, 2}, true);
    const auto fine = [](int i, int j) { return vtkIdType{i + 5 * j}; };
    std::array<std::array<vtkIdType, 3>, 3> floor{};
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            floor[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
                add_point(*grid, core::Vec3(i, j, 0));
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const auto low = [&](int di, int dj) {
                return floor[static_cast<std::size_t>(j + dj)][static_cast<std::size_t>(i + di)];
            };
            const auto top = [&](int di, int dj) { return fine(2 * i + di, 2 * j + dj); };
            std::vector<std::vector<vtkIdType>> faces{{low(0, 0), low(0, 1), low(1, 1), low(1, 0)}};
            for (int dj = 0; dj < 2; ++dj)
                for (int di = 0; di < 2; ++di)
                    faces.push_back(
                        {top(di, dj), top(di + 1, dj), top(di + 1, dj + 1), top(di, dj + 1)});
            faces.push_back({low(0, 0), low(1, 0), top(2, 0), top(1, 0), top(0, 0)});
            faces.push_back({low(1, 0), low(1, 1), top(2, 2), top(2, 1), top(2, 0)});
            faces.push_back({low(1, 1), low(0, 1), top(0, 2), top(1, 2), top(2, 2)});
            faces.push_back({low(0, 1), low(0, 0), top(0, 0), top(0, 1), top(0, 2)});
            add_polyhedron(*grid, faces);
        }
    return grid;
}

/// Adds a point or cell array; `value` is given the place of the point or the mean of the cell's points.
inline void add_array(vtkDataSet& data,
                      bool of_points,
                      const std::string& name,
                      int components,
                      const std::function<double(const core::Vec3&, int)>& value) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    const auto place = [](const double* p) { return core::Vec3(p[0], p[1], p[2]); };
    const vtkIdType count = of_points ? data.GetNumberOfPoints() : data.GetNumberOfCells();
    auto ids = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < count; ++i) {
        core::Vec3 p(0.0);
        if (of_points) {
            p = place(data.GetPoint(i));
        } else {
            data.GetCellPoints(i, ids);
            for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
                p += place(data.GetPoint(ids->GetId(k))) /
                     static_cast<double>(ids->GetNumberOfIds());
        }
        for (int c = 0; c < components; ++c)
            array->InsertNextValue(value(p, c));
    }
    if (of_points)
        data.GetPointData()->AddArray(array);
    else
        data.GetCellData()->AddArray(array);
}

} // namespace wakesurf::tests
