#include "importer/sources/blocks/plane_slab.hpp"

#include "importer/base/slab_mark.hpp"
#include "store/velocity_names.hpp"

#include <vtkBoundingBox.h>
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

struct Plane {
    Vec3 normal;
    double place = 0.0; ///< along the normal
    double thickness = 0.0;
};

// Rounds a thickness, so that it does not depend on the order of the cells: that may change from one time-step to the
// next, of the same mesh.
double rounded(double thickness) {
    constexpr double digits = 0x1p20;
    int power = 0;
    const double part = std::frexp(thickness, &power);
    return std::ldexp(std::round(part * digits) / digits, power);
}

// Returns nothing if the points are not in a plane, to a millionth of their extent.
std::optional<Plane> plane_of(vtkDataSet& data) {
    if (vtkPointSet::SafeDownCast(&data) == nullptr) { // an image or rectilinear grid: along axes
        std::array<double, 6> box{};
        data.GetBounds(box.data());
        Plane out{Vec3(0.0)};
        double area = 1.0;
        for (int k = 0; k < 3; ++k) {
            const auto low = static_cast<std::size_t>(2 * k);
            const double side = box[low + 1] - box[low];
            if (side > 0.0) {
                area *= side;
            } else {
                out.normal[k] = 1.0;
                out.place = box[low];
            }
        }
        out.thickness = rounded(std::sqrt(area / static_cast<double>(data.GetNumberOfCells())));
        return glm::length(out.normal) == 1.0 ? std::optional(out) : std::nullopt;
    }
    Vec3 normal(0.0);
    double area = 0.0;
    std::size_t cells = 0;
    const auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        if (data.GetCellType(i) == VTK_EMPTY_CELL) // of a structured grid, a blanked one
            continue;
        corners_of(data, i, *nodes);
        if (nodes->GetNumberOfIds() < 3)
            return std::nullopt;
        ++cells;
        Vec3 one = area_of(data, *nodes);
        area += glm::length(one);
        normal += glm::dot(one, normal) < 0.0 ? -one : one;
    }
    if (!(area > 0.0) || !(glm::length(normal) > 0.0))
        return std::nullopt;
    normal = glm::normalize(normal);
    for (int k = 0; k < 3; ++k)
        if (std::abs(normal[k]) > 1.0 - 1e-9) {
            normal = Vec3(0.0);
            normal[k] = 1.0;
        }
    std::array<double, 6> box{};
    data.GetBounds(box.data());
    const double size = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
    std::optional<Vec3> first;
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        corners_of(data, i, *nodes);
        for (const vtkIdType node : *nodes) { // no others: points may be left over
            const Vec3 p = point_of(data, node);
            first = first.value_or(p);
            if (std::abs(glm::dot(p - *first, normal)) > 1e-6 * size)
                return std::nullopt;
        }
    }
    return Plane{normal, glm::dot(*first, normal),
                 rounded(std::sqrt(area / static_cast<double>(cells)))};
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
slab_points(vtkDataSet& data, vtkIdType count, const Plane& plane, const Source& source) {
    auto out = vtkSmartPointer<vtkPoints>::New();
    out->SetDataTypeToDouble();
    out->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i) {
        const auto [number, side] = source(i);
        const Vec3 p = point_of(data, number) + side * 0.5 * plane.thickness * plane.normal;
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

vtkSmartPointer<vtkDataSet> slab_of_cells(vtkDataSet& data, const Plane& plane) {
    auto out = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const vtkIdType points = data.GetNumberOfPoints();
    out->SetPoints(slab_points(data, 2 * points, plane, [points](vtkIdType i) {
        return std::pair(i % points, i < points ? -1.0 : 1.0);
    }));
    out->Allocate(data.GetNumberOfCells());
    const auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        corners_of(data, i, *nodes);
        if (glm::dot(area_of(data, *nodes), plane.normal) < 0.0)
            std::reverse(nodes->begin(), nodes->end());
        insert_prism(*out, *nodes, points);
    }
    return out;
}

// Puts the sides of a slab where `to` has them. REQUIRES: both are of one plane.
void set_sides(vtkDataSet& block, const Slab& from, const Slab& to) {
    const auto axis =
        static_cast<int>(std::find(&to.across[0], &to.across[0] + 3, 1.0) - &to.across[0]);
    const double half = 0.5 * to.thickness;
    if (auto* image = vtkImageData::SafeDownCast(&block); image != nullptr && axis < 3) {
        std::array<double, 3> origin{};
        std::array<double, 3> spacing{};
        image->GetOrigin(origin.data());
        image->GetSpacing(spacing.data());
        origin[static_cast<std::size_t>(axis)] = to.place - half;
        spacing[static_cast<std::size_t>(axis)] = to.thickness;
        image->SetOrigin(origin.data());
        image->SetSpacing(spacing.data());
    } else if (auto* grid = vtkRectilinearGrid::SafeDownCast(&block); grid != nullptr && axis < 3) {
        const std::array<vtkDataArray*, 3> axes{grid->GetXCoordinates(), grid->GetYCoordinates(),
                                                grid->GetZCoordinates()};
        auto* const sides = axes[static_cast<std::size_t>(axis)];
        sides->SetTuple1(0, to.place - half);
        sides->SetTuple1(1, to.place + half);
    } else if (auto* set = vtkPointSet::SafeDownCast(&block)) {
        for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i) {
            Vec3 p = point_of(block, i);
            const double along = glm::dot(p, to.across);
            const double side =
                along < from.place * glm::dot(from.across, to.across) ? -half : half;
            p += (to.place + side) * to.across - along * to.across;
            set->GetPoints()->SetPoint(i, p.x, p.y, p.z);
        }
    }
    block.Modified();
    mark_slab(block, to);
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
    for (const auto& velocity : store::velocity_components(with, core::FieldInfo::Source::Point))
        for (const auto& component : velocity)
            if (thirds.contains(component.name))
                out.push_back(component.name);
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
        copy_arrays(*data.GetPointData(), *out->GetPointData(), 2 * points, plane->normal,
                    without_axis(nodes, *axis));
    else
        copy_arrays(*data.GetPointData(), *out->GetPointData(), 2 * points, plane->normal,
                    [points](vtkIdType i) { return i % points; });
    copy_arrays(*data.GetCellData(), *out->GetCellData(), data.GetNumberOfCells(), plane->normal,
                [](vtkIdType i) { return i; });
    add_third_component(*out->GetPointData(), plane->normal);
    add_third_component(*out->GetCellData(), plane->normal);
    mark_slab(*out, {plane->normal, plane->place, plane->thickness});
    return out;
}

core::Result<void> even_slabs(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks) {
    const auto marked = static_cast<std::size_t>(std::ranges::count_if(
        blocks, [](const auto& block) { return marked_slab(*block).has_value(); }));
    if (marked == 0 || blocks.size() == 1)
        return {};
    Slab whole = marked == blocks.size() ? *marked_slab(*blocks.front()) : Slab{};
    vtkBoundingBox box;
    double area = 0.0;
    double cells = 0.0;
    for (const auto& block : blocks) {
        box.AddBounds(block->GetBounds());
        const Slab here = marked_slab(*block).value_or(whole);
        const auto count = static_cast<double>(block->GetNumberOfCells());
        area += here.thickness * here.thickness * count;
        cells += count;
    }
    whole.thickness = rounded(std::sqrt(area / cells));
    const bool one =
        marked == blocks.size() && std::ranges::all_of(blocks, [&](const auto& block) {
            const Slab here = *marked_slab(*block);
            const double along = glm::dot(here.across, whole.across);
            return glm::length(glm::cross(here.across, whole.across)) < 1e-6 &&
                   std::abs(here.place * along - whole.place) <= 1e-6 * box.GetDiagonalLength();
        });
    if (!one)
        return core::fail(core::Error::Code::Unsupported,
                          "has flat parts that do not lie in one plane, or beside cells in space",
                          "give the plane or the cells in space alone");
    for (const auto& block : blocks)
        set_sides(*block, *marked_slab(*block), whole);
    return {};
}

} // namespace wakesurf::importer
