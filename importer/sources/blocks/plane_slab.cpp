#include "importer/sources/blocks/plane_slab.hpp"

#include "importer/base/slab_mark.hpp"
#include "store/velocity_names.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Vec3;

namespace {

Vec3 point_of(vtkDataSet& data, vtkIdType i) {
    std::array<double, 3> p{};
    data.GetPoint(i, p.data());
    return {p[0], p[1], p[2]};
}

Vec3 area_of(vtkDataSet& data, vtkIdList& nodes) {
    Vec3 area(0.0);
    const Vec3 first = point_of(data, nodes.GetId(0));
    for (vtkIdType k = 2; k < nodes.GetNumberOfIds(); ++k)
        area += 0.5 * glm::cross(point_of(data, nodes.GetId(k - 1)) - first,
                                 point_of(data, nodes.GetId(k)) - first);
    return area;
}

// The nodes of a flat cell in order round it; none if it is not a flat one with straight edges.
void corners_of(vtkDataSet& data, vtkIdType cell, vtkIdList& nodes) {
    data.GetCellPoints(cell, &nodes);
    const int type = data.GetCellType(cell);
    if (type == VTK_PIXEL) { // x fastest, not round
        const vtkIdType third = nodes.GetId(2);
        nodes.SetId(2, nodes.GetId(3));
        nodes.SetId(3, third);
    } else if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_POLYGON) {
        nodes.Reset();
    }
}

// Says whether a cell is another piece's, which has it as well.
bool is_ghost(vtkDataSet& data, vtkIdType cell) {
    auto* const marks = data.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
    return marks != nullptr && marks->GetNumberOfTuples() > cell &&
           (static_cast<int>(marks->GetTuple1(cell)) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

// Returns nothing if the points are not in a plane, beyond rounding.
std::optional<Slab> plane_of(vtkDataSet& data) {
    if (vtkPointSet::SafeDownCast(&data) == nullptr) { // an image or rectilinear grid: along axes
        std::array<double, 6> box{};
        data.GetBounds(box.data());
        Slab out;
        out.area = 1.0;
        for (int k = 0; k < 3; ++k) {
            const auto low = static_cast<std::size_t>(2 * k);
            const double side = box[low + 1] - box[low];
            if (side > 0.0) {
                out.area *= side;
            } else {
                out.across[k] = 1.0;
                out.place = box[low];
            }
        }
        out.cells = static_cast<double>(data.GetNumberOfCells());
        out.thickness = thickness_of(out.area, out.cells);
        return glm::length(out.across) == 1.0 ? std::optional(out) : std::nullopt;
    }
    Vec3 normal(0.0);
    Slab own;
    Slab all;
    const auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        if (data.GetCellType(i) == VTK_EMPTY_CELL) // of a structured grid, a blanked one
            continue;
        corners_of(data, i, *nodes);
        if (nodes->GetNumberOfIds() < 3)
            return std::nullopt;
        const Vec3 one = area_of(data, *nodes);
        all.area += glm::length(one);
        all.cells += 1.0;
        if (!is_ghost(data, i)) {
            own.area += glm::length(one);
            own.cells += 1.0;
        }
        normal += glm::dot(one, normal) < 0.0 ? -one : one;
    }
    if (!(glm::length(normal) > 0.0))
        return std::nullopt;
    normal = glm::normalize(normal);
    for (int k = 0; k < 3; ++k)
        if (std::abs(normal[k]) > 1.0 - 1e-9) {
            normal = Vec3(0.0);
            normal[k] = 1.0;
        }
    std::array<double, 6> box{};
    data.GetBounds(box.data());
    std::optional<Vec3> first;
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        corners_of(data, i, *nodes);
        for (const vtkIdType node : *nodes) { // no others: points may be left over
            const Vec3 p = point_of(data, node);
            first = first.value_or(p);
            if (std::abs(glm::dot(p - *first, normal)) > off_plane(box))
                return std::nullopt;
        }
    }
    const Slab& counted = own.area > 0.0 ? own : all;
    return Slab{normal, glm::dot(*first, normal), thickness_of(counted.area, counted.cells),
                own.area, own.cells};
}

// Copies arrays; point `i` of the slab has the values of `source(i)`. Vectors of two components get a third.
template <class Source>
void copy_arrays(vtkDataSetAttributes& from,
                 vtkDataSetAttributes& to,
                 vtkIdType count,
                 const Vec3& normal,
                 const Source& source) {
    int across = -1;
    for (int k = 0; k < 3; ++k)
        if (normal[k] == 1.0)
            across = k;
    for (int a = 0; a < from.GetNumberOfArrays(); ++a) {
        vtkDataArray* const array = from.GetArray(a);
        if (array == nullptr)
            continue;
        const bool extend =
            array->GetNumberOfComponents() == 2 && across >= 0 &&
            (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
        const auto out = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
        out->SetName(array->GetName());
        out->SetNumberOfComponents(extend ? 3 : array->GetNumberOfComponents());
        out->SetNumberOfTuples(count);
        if (array->HasInformation())
            out->CopyInformation(array->GetInformation());
        for (vtkIdType i = 0; i < count; ++i) {
            if (!extend) {
                out->SetTuple(i, source(i), array);
                continue;
            }
            for (int k = 0, c = 0; k < 3; ++k)
                out->SetComponent(i, k, k == across ? 0.0 : array->GetComponent(source(i), c++));
        }
        to.AddArray(out);
    }
}

// Returns the names of the other component in the plane and of the one across it, if the letter of `name` at a place is
// that of one in the plane: v and w for u.
std::optional<std::pair<std::string, std::string>>
others_of(const std::string& name, std::size_t place, int across) {
    constexpr std::array<std::string_view, 5> letters{"xyz", "XYZ", "uvw", "UVW", "123"};
    for (const auto three : letters)
        if (const auto own = three.find(name[place]);
            own != std::string_view::npos && own != static_cast<std::size_t>(across)) {
            std::pair out{name, name};
            out.first[place] = three[3 - own - static_cast<std::size_t>(across)];
            out.second[place] = three[static_cast<std::size_t>(across)];
            return out;
        }
    return std::nullopt;
}

// Adds the third of a velocity's components, where two scalars with the names of the others are there.
void add_third_component(vtkDataSetAttributes& arrays, const Vec3& normal) {
    const auto across = std::find(&normal[0], &normal[0] + 3, 1.0) - &normal[0];
    std::vector<core::FieldInfo> scalars;
    for (int a = 0; a < arrays.GetNumberOfArrays() && across < 3; ++a)
        if (vtkDataArray* const array = arrays.GetArray(a);
            array != nullptr && array->GetName() != nullptr && array->GetNumberOfComponents() == 1)
            scalars.push_back({array->GetName(), 1, core::FieldInfo::Source::Point, {}, {}});
    for (const auto& name : third_components(scalars, static_cast<int>(across))) {
        const auto zero = vtkSmartPointer<vtkFloatArray>::New();
        zero->SetName(name.c_str());
        zero->SetNumberOfTuples(arrays.GetArray(scalars.front().name.c_str())->GetNumberOfTuples());
        zero->Fill(0.0);
        arrays.AddArray(zero);
    }
}

std::optional<int> thin_axis(const std::array<int, 3>& nodes) {
    std::optional<int> out;
    for (int k = 0; k < 3; ++k) {
        if (nodes[static_cast<std::size_t>(k)] > 1)
            continue;
        if (out)
            return std::nullopt; // a line
        out = k;
    }
    return out;
}

// The number in a structured plane of a point of its slab: both have x fastest.
auto without_axis(std::array<int, 3> nodes, int axis) {
    nodes[static_cast<std::size_t>(axis)] = 2;
    return [nodes, axis](vtkIdType i) {
        std::array<vtkIdType, 3> at{i % nodes[0], i / nodes[0] % nodes[1], i / nodes[0] / nodes[1]};
        at[static_cast<std::size_t>(axis)] = 0;
        const vtkIdType nx = axis == 0 ? 1 : nodes[0];
        const vtkIdType ny = axis == 1 ? 1 : nodes[1];
        return at[0] + nx * (at[1] + ny * at[2]);
    };
}

vtkSmartPointer<vtkDataSet> slab_of_image(vtkImageData& image, int axis, double thickness) {
    auto out = vtkSmartPointer<vtkImageData>::New();
    std::array<int, 6> extent{};
    image.GetExtent(extent.data());
    std::array<double, 3> origin{};
    std::array<double, 3> spacing{};
    image.GetOrigin(origin.data());
    image.GetSpacing(spacing.data());
    const auto k = static_cast<std::size_t>(axis);
    const double plane = origin[k] + extent[2 * k] * spacing[k];
    extent[2 * k] = 0;
    extent[2 * k + 1] = 1;
    origin[k] = plane - 0.5 * thickness;
    spacing[k] = thickness;
    out->SetExtent(extent.data());
    out->SetOrigin(origin.data());
    out->SetSpacing(spacing.data());
    return out;
}

vtkSmartPointer<vtkDataSet>
slab_of_rectilinear(vtkRectilinearGrid& grid, int axis, double thickness) {
    auto out = vtkSmartPointer<vtkRectilinearGrid>::New();
    std::array<int, 3> nodes{};
    grid.GetDimensions(nodes.data());
    nodes[static_cast<std::size_t>(axis)] = 2;
    out->SetDimensions(nodes.data());
    std::array<vtkSmartPointer<vtkDataArray>, 3> axes{
        grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates()};
    const auto sides = vtkSmartPointer<vtkDoubleArray>::New();
    const double plane = axes[static_cast<std::size_t>(axis)]->GetTuple1(0);
    sides->InsertNextValue(plane - 0.5 * thickness);
    sides->InsertNextValue(plane + 0.5 * thickness);
    axes[static_cast<std::size_t>(axis)] = sides;
    out->SetXCoordinates(axes[0]);
    out->SetYCoordinates(axes[1]);
    out->SetZCoordinates(axes[2]);
    return out;
}

template <class Source>
vtkSmartPointer<vtkPoints>
slab_points(vtkDataSet& data, vtkIdType count, const Slab& plane, const Source& source) {
    auto out = vtkSmartPointer<vtkPoints>::New();
    out->SetDataTypeToDouble();
    out->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i) {
        const auto [number, side] = source(i);
        Vec3 p = point_of(data, number);
        p +=
            (plane.place - glm::dot(p, plane.across) + side * 0.5 * plane.thickness) * plane.across;
        out->SetPoint(i, p.x, p.y, p.z);
    }
    return out;
}

// Each flat cell between its nodes below and, `points` numbers further on, above.
void insert_prism(vtkUnstructuredGrid& out, vtkIdList& nodes, vtkIdType points) {
    const vtkIdType count = nodes.GetNumberOfIds();
    std::vector<vtkIdType> ids(nodes.begin(), nodes.end());
    if (count == 3) { // the first triangle of VTK's wedge is seen counterclockwise from outside
        for (vtkIdType& id : ids)
            id += points;
        ids.insert(ids.end(), nodes.begin(), nodes.end());
        out.InsertNextCell(VTK_WEDGE, 6, ids.data());
        return;
    }
    for (vtkIdType k = 0; k < count; ++k)
        ids.push_back(nodes.GetId(k) + points);
    if (count == 4) {
        out.InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
        return;
    }
    const auto faces = vtkSmartPointer<vtkIdList>::New();
    faces->InsertNextId(count + 2);
    faces->InsertNextId(count);
    for (vtkIdType k = count; k-- > 0;)
        faces->InsertNextId(nodes.GetId(k));
    faces->InsertNextId(count);
    for (vtkIdType k = 0; k < count; ++k)
        faces->InsertNextId(nodes.GetId(k) + points);
    for (vtkIdType k = 0; k < count; ++k) {
        const vtkIdType a = nodes.GetId(k);
        const vtkIdType b = nodes.GetId((k + 1) % count);
        for (const vtkIdType id : {vtkIdType{4}, a, b, b + points, a + points})
            faces->InsertNextId(id);
    }
    out.InsertNextCell(VTK_POLYHEDRON, faces);
}

vtkSmartPointer<vtkDataSet> slab_of_cells(vtkDataSet& data, const Slab& plane) {
    auto out = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const vtkIdType points = data.GetNumberOfPoints();
    out->SetPoints(slab_points(data, 2 * points, plane, [points](vtkIdType i) {
        return std::pair(i % points, i < points ? -1.0 : 1.0);
    }));
    out->Allocate(data.GetNumberOfCells());
    const auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        corners_of(data, i, *nodes);
        if (glm::dot(area_of(data, *nodes), plane.across) < 0.0)
            std::reverse(nodes->begin(), nodes->end());
        insert_prism(*out, *nodes, points);
    }
    return out;
}

} // namespace

std::vector<std::string> third_components(const std::vector<core::FieldInfo>& scalars, int across) {
    std::set<std::string> names;
    for (const auto& scalar : scalars)
        names.insert(scalar.name);
    std::set<std::string> thirds;
    for (const auto& name : names)
        for (std::size_t place = 0; place < name.size(); ++place)
            if (const auto others = others_of(name, place, across);
                others && names.contains(others->first) && !names.contains(others->second))
                thirds.insert(others->second);
    auto with = scalars;
    for (const auto& third : thirds)
        with.push_back({third, 1, core::FieldInfo::Source::Point, {}, {}});
    std::vector<std::string> out;
    const auto add = [&](const auto& vectors) {
        for (const auto& vector : vectors)
            for (const auto& component : vector)
                if (thirds.contains(component.name))
                    out.push_back(component.name);
    };
    add(store::velocity_components(with, core::FieldInfo::Source::Point));
    add(store::momentum_components(with, core::FieldInfo::Source::Point));
    return out;
}

std::vector<core::FieldInfo> slab_fields(std::vector<core::FieldInfo> plane, int across) {
    for (const auto source : {core::FieldInfo::Source::Point, core::FieldInfo::Source::Cell}) {
        std::vector<core::FieldInfo> scalars;
        for (auto& field : plane) {
            field.components = field.components == 2 ? 3 : field.components;
            if (field.components == 1 && field.source == source)
                scalars.push_back({field.name, 1, core::FieldInfo::Source::Point, {}, {}});
        }
        for (const auto& third : third_components(scalars, across))
            plane.push_back({third, 1, source, {}, {}});
    }
    return plane;
}

std::optional<vtkSmartPointer<vtkDataSet>> slab_of(vtkDataSet& data) {
    if (data.GetNumberOfCells() == 0)
        return std::nullopt;
    const auto plane = plane_of(data);
    if (!plane)
        return std::nullopt;
    vtkSmartPointer<vtkDataSet> out;
    std::array<int, 3> nodes{0, 0, 0};
    if (auto* image = vtkImageData::SafeDownCast(&data))
        image->GetDimensions(nodes.data());
    else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data))
        rectilinear->GetDimensions(nodes.data());
    else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data))
        structured->GetDimensions(nodes.data());
    const bool in_order = nodes[0] > 0;
    const auto axis = thin_axis(nodes);
    if (in_order && !axis)
        return std::nullopt;
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        out = slab_of_image(*image, *axis, plane->thickness);
    } else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
        out = slab_of_rectilinear(*rectilinear, *axis, plane->thickness);
    } else if (in_order) {
        auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
        auto two = nodes;
        two[static_cast<std::size_t>(*axis)] = 2;
        grid->SetDimensions(two.data());
        vtkIdType below = 1;
        for (int k = 0; k < *axis; ++k)
            below *= two[static_cast<std::size_t>(k)];
        grid->SetPoints(slab_points(data, 2 * data.GetNumberOfPoints(), *plane, [&](vtkIdType i) {
            return std::pair(without_axis(nodes, *axis)(i), i / below % 2 == 0 ? -1.0 : 1.0);
        }));
        out = grid;
    } else {
        out = slab_of_cells(data, *plane);
    }
    const vtkIdType points = data.GetNumberOfPoints();
    if (in_order)
        copy_arrays(*data.GetPointData(), *out->GetPointData(), 2 * points, plane->across,
                    without_axis(nodes, *axis));
    else
        copy_arrays(*data.GetPointData(), *out->GetPointData(), 2 * points, plane->across,
                    [points](vtkIdType i) { return i % points; });
    copy_arrays(*data.GetCellData(), *out->GetCellData(), data.GetNumberOfCells(), plane->across,
                [](vtkIdType i) { return i; });
    add_third_component(*out->GetPointData(), plane->across);
    add_third_component(*out->GetCellData(), plane->across);
    mark_slab(*out, *plane);
    return out;
}

} // namespace wakesurf::importer
