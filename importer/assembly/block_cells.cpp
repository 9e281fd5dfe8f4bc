#include "importer/assembly/block_cells.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <optional>
#include <string>

namespace wakesurf::importer {

using core::CellShape;
using core::Error;
using Form = BlockCell::Form;

namespace {

vtkDataArray* marks_of(vtkDataSetAttributes& attributes) {
    return attributes.GetArray(vtkDataSetAttributes::GhostArrayName());
}

bool marked(vtkDataArray* marks, std::size_t index, int flags) {
    return marks != nullptr &&
           (static_cast<int>(marks->GetTuple1(static_cast<vtkIdType>(index))) & flags) != 0;
}

std::optional<CellShape> shape_of(int type) {
    switch (type) {
    case VTK_TETRA:
        return CellShape::Tetrahedron;
    case VTK_PYRAMID:
        return CellShape::Pyramid;
    case VTK_WEDGE:
        return CellShape::Wedge;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
        return CellShape::Hexahedron;
    default:
        return std::nullopt;
    }
}

// Returns the type of the cell with straight edges that a cell of any order is if it has its corners only;
// else `type`.
int straight_type(int type, vtkIdType nodes) {
    switch (type) {
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
        return nodes == 4 ? VTK_TETRA : type;
    case VTK_LAGRANGE_PYRAMID:
    case VTK_BEZIER_PYRAMID:
        return nodes == 5 ? VTK_PYRAMID : type;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
        return nodes == 6 ? VTK_WEDGE : type;
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
        return nodes == 8 ? VTK_HEXAHEDRON : type;
    default:
        return type;
    }
}

bool is_flat(int type) {
    switch (type) {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_QUADRATIC_EDGE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_POLYGON:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_CURVE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_QUADRILATERAL:
        return true;
    default:
        return false;
    }
}

std::array<std::size_t, 3> nodes_of(vtkDataSet& data) {
    int nodes[3] = {0, 0, 0};
    if (auto* image = vtkImageData::SafeDownCast(&data))
        image->GetDimensions(nodes);
    else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data))
        rectilinear->GetDimensions(nodes);
    else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data))
        structured->GetDimensions(nodes);
    std::array<std::size_t, 3> out{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        out[axis] = static_cast<std::size_t>(std::max(nodes[axis], 0));
    return out;
}

tl::unexpected<Error> damaged(std::size_t index, const char* what) {
    return core::fail(Error::Code::Corrupt, "cell " + std::to_string(index) + " " + what);
}

} // namespace

std::vector<std::vector<std::uint32_t>> faces_of(const BlockCell& cell) {
    if (cell.form == Form::Polyhedron)
        return cell.faces;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; cell.form == Form::Standard && f < core::face_count(cell.shape); ++f) {
        const core::CellFace corners = core::face(cell.shape, f);
        faces.emplace_back();
        for (std::size_t i = 0; i < corners.count; ++i)
            faces.back().push_back(cell.point[corners.node[i]]);
    }
    return faces;
}

BlockCells::BlockCells(vtkDataSet& data)
    : grid_(vtkUnstructuredGrid::SafeDownCast(&data)),
      points_(static_cast<std::size_t>(data.GetNumberOfPoints())),
      cell_marks_(marks_of(*data.GetCellData())), point_marks_(marks_of(*data.GetPointData())) {
    if (grid_ != nullptr) {
        size_ = static_cast<std::size_t>(grid_->GetNumberOfCells());
        return;
    }
    nodes_ = nodes_of(data);
    if (std::all_of(nodes_.begin(), nodes_.end(), [](std::size_t n) { return n > 1; }))
        size_ = (nodes_[0] - 1) * (nodes_[1] - 1) * (nodes_[2] - 1);
}

core::Result<void> BlockCells::read(std::size_t index, BlockCell& cell) {
    cell.form = Form::None;
    if (blanked(index))
        return {};
    if (grid_ == nullptr)
        read_structured(index, cell);
    else if (auto read = read_unstructured(index, cell); !read)
        return read;
    if (point_marks_ != nullptr && touches_hidden_point(cell))
        cell.form = Form::None;
    return {};
}

bool BlockCells::blanked(std::size_t index) const {
    return marked(cell_marks_, index,
                  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL |
                      vtkDataSetAttributes::REFINEDCELL);
}

bool BlockCells::touches_hidden_point(const BlockCell& cell) const {
    const auto hidden = [&](std::uint32_t point) {
        return marked(point_marks_, point, vtkDataSetAttributes::HIDDENPOINT);
    };
    if (cell.form == Form::Standard)
        return std::any_of(
            cell.point.begin(),
            cell.point.begin() + static_cast<std::ptrdiff_t>(core::node_count(cell.shape)), hidden);
    return cell.form == Form::Polyhedron &&
           std::any_of(cell.faces.begin(), cell.faces.end(), [&](const auto& face) {
               return std::any_of(face.begin(), face.end(), hidden);
           });
}

void BlockCells::read_structured(std::size_t index, BlockCell& cell) const {
    const std::size_t i = index % (nodes_[0] - 1);
    const std::size_t j = index / (nodes_[0] - 1) % (nodes_[1] - 1);
    const std::size_t k = index / (nodes_[0] - 1) / (nodes_[1] - 1);
    const std::size_t row = nodes_[0];
    const std::size_t layer = row * nodes_[1];
    const std::size_t first = i + row * j + layer * k;
    const std::array<std::size_t, 8> corner{0,     1,         row + 1,         row,
                                            layer, layer + 1, layer + row + 1, layer + row};
    for (std::size_t c = 0; c < 8; ++c)
        cell.point[c] = static_cast<std::uint32_t>(first + corner[c]);
    cell.shape = CellShape::Hexahedron;
    cell.form = Form::Standard;
}

core::Result<void> BlockCells::read_unstructured(std::size_t index, BlockCell& cell) {
    const int type = grid_->GetCellType(static_cast<vtkIdType>(index));
    if (shape_of(type))
        return read_standard(index, type, cell);
    if (type == VTK_POLYHEDRON)
        return read_polyhedron(index, cell);
    if (type == VTK_PENTAGONAL_PRISM || type == VTK_HEXAGONAL_PRISM)
        return read_prism(index, cell);
    if (is_flat(type))
        return {};
    if (const int straight =
            straight_type(type, grid_->GetCells()->GetCellSize(static_cast<vtkIdType>(index)));
        straight != type && grid_->GetPointData()->GetRationalWeights() == nullptr)
        return read_standard(index, straight, cell);
    const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
    return core::fail(Error::Code::Unsupported,
                      "cell " + std::to_string(index) + " is a " +
                          (name == nullptr ? "cell of an unknown type" : name) +
                          ", which would have to be approximated",
                      "write the mesh with linear cells or polyhedra");
}

core::Result<void> BlockCells::read_standard(std::size_t index, int type, BlockCell& cell) {
    cell.shape = *shape_of(type);
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid_->GetCells()->GetCellAtId(static_cast<vtkIdType>(index), count, ids);
    if (static_cast<std::size_t>(count) != core::node_count(cell.shape))
        return damaged(index, "does not have as many points as its type requires");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (ids[i] < 0 || static_cast<std::size_t>(ids[i]) >= points_)
            return damaged(index, "names points that do not exist");
        cell.point[i] = static_cast<std::uint32_t>(ids[i]);
    }
    if (type == VTK_VOXEL) {
        std::swap(cell.point[2], cell.point[3]);
        std::swap(cell.point[6], cell.point[7]);
    }
    cell.form = Form::Standard;
    return {};
}

core::Result<void> BlockCells::read_polyhedron(std::size_t index, BlockCell& cell) {
    vtkIdType count = 0;
    const vtkIdType* stream = nullptr;
    grid_->GetFaceStream(static_cast<vtkIdType>(index), count, stream);
    if (stream == nullptr || count < 4)
        return damaged(index, "is a polyhedron without faces");
    cell.faces.resize(static_cast<std::size_t>(count));
    for (auto& face : cell.faces) {
        const vtkIdType corners = *stream++;
        if (corners < 3)
            return damaged(index, "has a face of less than 3 points");
        face.clear();
        for (vtkIdType i = 0; i < corners; ++i, ++stream) {
            if (*stream < 0 || static_cast<std::size_t>(*stream) >= points_)
                return damaged(index, "names points that do not exist");
            face.push_back(static_cast<std::uint32_t>(*stream));
        }
    }
    cell.form = Form::Polyhedron;
    return {};
}

core::Result<void> BlockCells::read_prism(std::size_t index, BlockCell& cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid_->GetCells()->GetCellAtId(static_cast<vtkIdType>(index), count, ids);
    const bool sound =
        (count == 10 || count == 12) && std::all_of(ids, ids + count, [&](vtkIdType id) {
            return id >= 0 && static_cast<std::size_t>(id) < points_;
        });
    if (!sound)
        return damaged(index, "names points that do not exist");
    const auto sides = static_cast<std::size_t>(count) / 2;
    const auto point = [&](std::size_t i) { return static_cast<std::uint32_t>(ids[i]); };
    cell.faces.assign(2, {});
    for (std::size_t i = 0; i < sides; ++i) {
        const std::size_t next = (i + 1) % sides;
        cell.faces[0].push_back(point(i));
        cell.faces[1].push_back(point(2 * sides - 1 - i));
        cell.faces.push_back({point(next), point(i), point(sides + i), point(sides + next)});
    }
    cell.form = Form::Polyhedron;
    return {};
}

} // namespace wakesurf::importer
