
#include "importer/base/reading_bounds.hpp"
#include "importer/sources/ensight/ensight_file.hpp"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>

namespace wakesurf::importer {

using core::Error;

namespace {

// Reads structured parts of EnSight Gold geometry: curvilinear, rectilinear and uniform blocks.

vtkSmartPointer<vtkFloatArray> array_of(const std::vector<float>& values) {
    auto out = vtkSmartPointer<vtkFloatArray>::New();
    out->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), out->GetPointer(0));
    return out;
}

core::Result<vtkSmartPointer<vtkDataSet>>
curvilinear(EnsightStream& in, const int* nodes, std::size_t total) {
    auto values = vtkSmartPointer<vtkFloatArray>::New();
    values->SetNumberOfComponents(3);
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = in.numbers(total);
        if (!along)
            return tl::unexpected(along.error());
        values->SetNumberOfTuples(static_cast<vtkIdType>(total));
        for (std::size_t i = 0; i < total; ++i)
            values->SetTypedComponent(static_cast<vtkIdType>(i), axis, (*along)[i]);
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(values);
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(nodes);
    grid->SetPoints(points);
    return vtkSmartPointer<vtkDataSet>(grid);
}

core::Result<vtkSmartPointer<vtkDataSet>> rectilinear(EnsightStream& in, const int* nodes) {
    std::array<vtkSmartPointer<vtkFloatArray>, 3> axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = in.numbers(static_cast<std::size_t>(nodes[axis]));
        if (!along)
            return tl::unexpected(along.error());
        axes[axis] = array_of(*along);
    }
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(nodes);
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    return vtkSmartPointer<vtkDataSet>(grid);
}

core::Result<vtkSmartPointer<vtkDataSet>> uniform(EnsightStream& in, const int* nodes) {
    const auto origin = in.numbers(3);
    const auto spacing = origin ? in.numbers(3) : origin;
    if (!spacing)
        return tl::unexpected(spacing.error());
    auto grid = vtkSmartPointer<vtkImageData>::New();
    grid->SetDimensions(nodes);
    grid->SetOrigin((*origin)[0], (*origin)[1], (*origin)[2]);
    grid->SetSpacing((*spacing)[0], (*spacing)[1], (*spacing)[2]);
    return vtkSmartPointer<vtkDataSet>(grid);
}

// Reads what follows the line `shape` ("block", "block rectilinear iblanked" ...). Points blanked out carry
// vtkGhostType.
// Error: Corrupt, Unsupported (parts of blocks, ghosts).
core::Result<vtkSmartPointer<vtkDataSet>> read_ensight_block(EnsightStream& in,
                                                             const std::string& shape) {
    const auto says = [&](const char* word) { return shape.find(word) != std::string::npos; };
    if (says("range") || says("ghost"))
        return core::fail(Error::Code::Unsupported,
                          "a part is a '" + shape + "', which cannot be read",
                          "write whole blocks without ghost cells");
    const auto nodes = in.integers(3);
    if (!nodes)
        return tl::unexpected(nodes.error());
    constexpr std::size_t most = std::size_t{1} << 40;
    std::size_t total = 1;
    for (const auto along : *nodes) {
        if (along < 1 || static_cast<std::size_t>(along) > most / total)
            return in.damaged("a block has " + std::to_string(along) + " nodes along one side");
        total *= static_cast<std::size_t>(along);
    }
    auto grid = says("uniform")       ? uniform(in, nodes->data())
                : says("rectilinear") ? rectilinear(in, nodes->data())
                                      : curvilinear(in, nodes->data(), total);
    if (!grid || !says("iblanked"))
        return grid;
    const auto marks = in.integers(total);
    if (!marks)
        return tl::unexpected(marks.error());
    auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(static_cast<vtkIdType>(total));
    for (std::size_t i = 0; i < total; ++i)
        ghosts->SetValue(static_cast<vtkIdType>(i),
                         (*marks)[i] == 0 ? vtkDataSetAttributes::HIDDENPOINT : 0);
    (*grid)->GetPointData()->AddArray(ghosts);
    return grid;
}

struct Kind {
    const char* name;
    int vtk;
    std::size_t nodes; ///< 0: each element has its own number
    int dimension;
};

constexpr std::array<Kind, 11> kinds{{{"point", VTK_VERTEX, 1, 0},
                                      {"bar2", VTK_LINE, 2, 1},
                                      {"bar3", VTK_LINE, 3, 1},
                                      {"tria3", VTK_TRIANGLE, 3, 2},
                                      {"quad4", VTK_QUAD, 4, 2},
                                      {"nsided", VTK_POLYGON, 0, 2},
                                      {"tetra4", VTK_TETRA, 4, 3},
                                      {"pyramid5", VTK_PYRAMID, 5, 3},
                                      {"penta6", VTK_WEDGE, 6, 3},
                                      {"hexa8", VTK_HEXAHEDRON, 8, 3},
                                      {"nfaced", VTK_POLYHEDRON, 0, 3}}};

const Kind* kind_of(const std::string& type) {
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const Kind& kind) { return type == kind.name; });
    return found == kinds.end() ? nullptr : found;
}

class GeometryReader {
  public:
    GeometryReader(EnsightStream& in, const std::string& name) : in_(in), name_(name) {}

    core::Result<EnsightGeometry> read() {
        EnsightGeometry out;
        out.encoding = in_.detect();
        for (int description = 0; description < 2; ++description)
            if (auto text = in_.line(); !text)
                return tl::unexpected(text.error());
        const auto nodes = has_numbers("node id");
        const auto elements = nodes ? has_numbers("element id") : nodes;
        if (!elements)
            return tl::unexpected(elements.error());
        node_numbers_ = *nodes;
        element_numbers_ = *elements;
        while (!in_.at_end()) {
            const auto word = in_.line();
            if (!word)
                return tl::unexpected(word.error());
            if (*word == "extents") {
                if (auto skipped = in_.numbers(6); !skipped)
                    return tl::unexpected(skipped.error());
                continue;
            }
            if (*word != "part")
                return in_.damaged("'" + *word + "' stands where a part should begin");
            const auto number = in_.count();
            if (!number)
                return tl::unexpected(number.error());
            auto part = read_part();
            if (!part)
                return tl::unexpected(part.error());
            if (!out.parts.emplace(*number, std::move(*part)).second)
                return in_.damaged("part " + std::to_string(*number) + " appears twice");
        }
        out.swapped = in_.swapped();
        choose_dimension(out);
        return out;
    }

  private:
    // Flat blocks beside cells in space are left out; without those, flat cells are a plane's.
    static void choose_dimension(EnsightGeometry& all) {
        const auto solid = [](const EnsightSection& section) { return section.dimension == 3; };
        all.plane = std::ranges::none_of(all.parts, [&](const auto& part) {
            return std::ranges::any_of(part.second.sections, solid);
        });
        for (auto& [number, part] : all.parts) {
            if (all.plane && part.faces != nullptr) {
                auto flat = vtkSmartPointer<vtkUnstructuredGrid>::New();
                flat->SetPoints(part.faces->GetPoints());
                flat->Allocate(part.faces->GetNumberOfCells());
                for (vtkIdType i = 0; i < part.faces->GetNumberOfCells(); ++i)
                    flat->InsertNextCell(part.faces->GetCellType(i),
                                         part.faces->GetCell(i)->GetPointIds());
                part.volume = flat;
                part.faces = nullptr;
            }
            for (auto& section : part.sections) {
                if (section.dimension != 2)
                    continue;
                if (all.plane)
                    section.dimension = 3;
                else if (section.type == "block") {
                    section.dimension = 0;
                    part.volume = nullptr;
                }
            }
        }
    }

    core::Result<bool> has_numbers(const std::string& what) {
        const auto text = in_.line();
        if (!text)
            return tl::unexpected(text.error());
        if (!text->starts_with(what))
            return in_.damaged("it has no line '" + what + "'");
        return text->ends_with("given") || text->ends_with("ignore");
    }

    core::Result<EnsightPart> read_part() {
        EnsightPart part;
        const auto name = in_.line();
        const auto shape = name ? in_.line() : name;
        if (!shape)
            return tl::unexpected(shape.error());
        part.name = *name;
        if (shape->starts_with("block")) {
            auto block = read_ensight_block(in_, *shape);
            if (!block)
                return tl::unexpected(block.error());
            part.nodes = static_cast<std::size_t>((*block)->GetNumberOfPoints());
            const int dimension = (*block)->GetCell(0)->GetCellDimension();
            part.sections = {
                {"block", static_cast<std::size_t>((*block)->GetNumberOfCells()), dimension}};
            if (dimension >= 2)
                part.volume = *block;
            return part;
        }
        if (*shape != "coordinates")
            return in_.damaged("'" + *shape + "' stands where coordinates should begin");
        auto points = read_points();
        if (!points)
            return tl::unexpected(points.error());
        part.nodes = static_cast<std::size_t>((*points)->GetNumberOfPoints());
        auto volume = vtkSmartPointer<vtkUnstructuredGrid>::New();
        volume->SetPoints(*points);
        volume->Allocate();
        auto faces = vtkSmartPointer<vtkPolyData>::New();
        faces->SetPoints(*points);
        faces->AllocateEstimate(1, 4);
        while (!in_.at_end()) {
            const auto type = in_.line();
            if (!type)
                return tl::unexpected(type.error());
            if (*type == "part") {
                in_.unread_line();
                break;
            }
            auto section = read_section(*type, part.nodes, *volume, *faces);
            if (!section)
                return tl::unexpected(section.error());
            part.sections.push_back(std::move(*section));
        }
        if (volume->GetNumberOfCells() > 0)
            part.volume = volume;
        if (faces->GetNumberOfCells() > 0)
            part.faces = faces;
        return part;
    }

    core::Result<vtkSmartPointer<vtkPoints>> read_points() {
        const auto count = in_.count();
        if (!count)
            return tl::unexpected(count.error());
        if (node_numbers_)
            if (auto skipped = in_.integers(*count); !skipped)
                return tl::unexpected(skipped.error());
        auto values = vtkSmartPointer<vtkFloatArray>::New();
        values->SetNumberOfComponents(3);
        for (int axis = 0; axis < 3; ++axis) {
            const auto along = in_.numbers(*count);
            if (!along)
                return tl::unexpected(along.error());
            values->SetNumberOfTuples(static_cast<vtkIdType>(*count));
            for (std::size_t i = 0; i < *count; ++i)
                values->SetTypedComponent(static_cast<vtkIdType>(i), axis, (*along)[i]);
        }
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetData(values);
        return points;
    }

    core::Result<EnsightSection> read_section(const std::string& type,
                                              std::size_t nodes,
                                              vtkUnstructuredGrid& volume,
                                              vtkPolyData& faces) {
        const bool ghost = type.starts_with("g_");
        const Kind* kind = kind_of(ghost ? type.substr(2) : type);
        if (kind == nullptr && !type.empty() &&
            std::isdigit(static_cast<unsigned char>(type.back())) != 0)
            return core::fail(Error::Code::Unsupported,
                              name_ + " has elements of the type " + type +
                                  ", which cannot be read",
                              "write linear elements");
        if (kind == nullptr)
            return in_.damaged("'" + type + "' is not a type of element");
        const auto count = in_.count();
        if (!count)
            return tl::unexpected(count.error());
        if (*count > in_.size())
            return in_.damaged("it has fewer elements than it declares");
        if (element_numbers_)
            if (auto skipped = in_.integers(*count); !skipped)
                return tl::unexpected(skipped.error());
        std::vector<std::int32_t> faces_of(*count, 1);
        if (kind->vtk == VTK_POLYHEDRON)
            if (auto read = list(*count, faces_of); !read)
                return tl::unexpected(read.error());
        std::size_t loops = 0;
        for (const auto number : faces_of)
            loops += static_cast<std::size_t>(number);
        if (loops > in_.size())
            return in_.damaged("it has fewer faces than it declares");
        std::vector<std::int32_t> sizes(kind->nodes == 0 ? 0 : loops,
                                        static_cast<std::int32_t>(kind->nodes));
        if (kind->nodes == 0)
            if (auto read = list(loops, sizes); !read)
                return tl::unexpected(read.error());
        std::size_t total = 0;
        for (const auto size : sizes)
            total += static_cast<std::size_t>(size);
        const auto numbers = in_.integers(total);
        if (!numbers)
            return tl::unexpected(numbers.error());
        for (const auto node : *numbers)
            if (node < 1 || static_cast<std::size_t>(node) > nodes)
                return in_.damaged("an element names node " + std::to_string(node) + " of " +
                                   std::to_string(nodes));
        if (!ghost)
            insert(*kind, faces_of, sizes, *numbers, volume, faces);
        return EnsightSection{type, *count, ghost ? 0 : kind->dimension};
    }

    // Reads counts that are at least 1.
    core::Result<void> list(std::size_t count, std::vector<std::int32_t>& out) {
        auto found = in_.integers(count);
        if (!found)
            return tl::unexpected(found.error());
        out = std::move(*found);
        if (std::any_of(out.begin(), out.end(), [](std::int32_t one) { return one < 1; }))
            return in_.damaged("an element has no faces or nodes");
        return {};
    }

    static void insert(const Kind& kind,
                       const std::vector<std::int32_t>& faces_of,
                       const std::vector<std::int32_t>& sizes,
                       const std::vector<std::int32_t>& numbers,
                       vtkUnstructuredGrid& volume,
                       vtkPolyData& faces) {
        if (kind.dimension < 2)
            return;
        std::size_t loop = 0;
        std::size_t at = 0;
        std::vector<vtkIdType> ids;
        for (const auto count : faces_of) {
            ids.clear();
            for (std::int32_t f = 0; f < count; ++f, ++loop) {
                if (kind.vtk == VTK_POLYHEDRON)
                    ids.push_back(sizes[loop]);
                for (std::int32_t n = 0; n < sizes[loop]; ++n)
                    ids.push_back(numbers[at++] - 1);
            }
            if (kind.vtk == VTK_WEDGE) { // EnSight counts its triangles the other way round
                std::swap(ids[1], ids[2]);
                std::swap(ids[4], ids[5]);
            }
            const auto size = static_cast<vtkIdType>(ids.size());
            if (kind.dimension == 2)
                faces.InsertNextCell(kind.vtk, static_cast<int>(size), ids.data());
            else if (kind.vtk == VTK_POLYHEDRON)
                volume.InsertNextCell(VTK_POLYHEDRON, count, ids.data());
            else
                volume.InsertNextCell(kind.vtk, size, ids.data());
        }
    }

    EnsightStream& in_;
    const std::string& name_;
    bool node_numbers_ = false;
    bool element_numbers_ = false;
};

bool same_values(vtkDataArray* one, vtkDataArray* other) {
    if (one == nullptr || other == nullptr)
        return one == other;
    if (one->GetNumberOfValues() != other->GetNumberOfValues() ||
        one->GetDataType() != other->GetDataType())
        return false;
    const auto bytes = static_cast<std::size_t>(one->GetNumberOfValues()) *
                       static_cast<std::size_t>(one->GetDataTypeSize());
    return std::equal(static_cast<const char*>(one->GetVoidPointer(0)),
                      static_cast<const char*>(one->GetVoidPointer(0)) + bytes,
                      static_cast<const char*>(other->GetVoidPointer(0)));
}

bool same_cells(vtkCellArray* one, vtkCellArray* other) {
    return same_values(one->GetOffsetsArray(), other->GetOffsetsArray()) &&
           same_values(one->GetConnectivityArray(), other->GetConnectivityArray());
}

bool same_data(vtkDataSet* one, vtkDataSet* other) {
    if (one == nullptr || other == nullptr)
        return one == other;
    if (one->GetNumberOfPoints() != other->GetNumberOfPoints() ||
        one->GetNumberOfCells() != other->GetNumberOfCells())
        return false;
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(one)) {
        auto* next = vtkUnstructuredGrid::SafeDownCast(other);
        return next != nullptr &&
               same_values(grid->GetPoints()->GetData(), next->GetPoints()->GetData()) &&
               same_cells(grid->GetCells(), next->GetCells()) &&
               same_values(grid->GetFaces(), next->GetFaces());
    }
    if (auto* faces = vtkPolyData::SafeDownCast(one)) {
        auto* next = vtkPolyData::SafeDownCast(other);
        return next != nullptr &&
               same_values(faces->GetPoints()->GetData(), next->GetPoints()->GetData()) &&
               same_cells(faces->GetPolys(), next->GetPolys());
    }
    for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i) {
        std::array<double, 3> a{};
        std::array<double, 3> b{};
        one->GetPoint(i, a.data());
        other->GetPoint(i, b.data());
        if (a != b)
            return false;
    }
    return true;
}

} // namespace

core::Result<EnsightGeometry> read_ensight_geometry(const NamedFile& file) {
    auto in = EnsightStream::open(file);
    if (!in)
        return tl::unexpected(in.error());
    return within_memory(file.name, [&] { return GeometryReader(*in, file.name).read(); });
}

bool same_geometry(const EnsightGeometry& one, const EnsightGeometry& other) {
    return std::equal(one.parts.begin(), one.parts.end(), other.parts.begin(), other.parts.end(),
                      [](const auto& a, const auto& b) {
                          return a.first == b.first && a.second.nodes == b.second.nodes &&
                                 same_data(a.second.volume, b.second.volume) &&
                                 same_data(a.second.faces, b.second.faces);
                      });
}

} // namespace wakesurf::importer
