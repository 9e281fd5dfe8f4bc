#include "importer/assembly/grid_assembly.hpp"

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "importer/assembly/mesh_assembly.hpp"
#include "importer/base/slab_mark.hpp"
#include "importer/base/text.hpp"
#include "store/store_grid.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wakesurf::importer {

using core::Error;

namespace {

// Makes a core::Grid of one VTK image or rectilinear grid.

core::Result<void> check_thickness(const int nodes[3]) {
    for (int axis = 0; axis < 3; ++axis)
        if (nodes[axis] < 2)
            return core::fail(Error::Code::Unsupported,
                              "is not three-dimensional: it has " + std::to_string(nodes[axis]) +
                                  " nodes along " + "xyz"[axis],
                              "extrude it by one cell first");
    return {};
}

bool any_marked(vtkDataSetAttributes& attributes, int flags) {
    vtkDataArray* marks = attributes.GetArray(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; marks != nullptr && i < marks->GetNumberOfTuples(); ++i)
        if ((static_cast<int>(marks->GetTuple1(i)) & flags) != 0)
            return true;
    return false;
}

// Error: Unsupported (fewer than two nodes along an axis), Corrupt. REQUIRES: the image is not rotated.
core::Result<core::UniformGrid> uniform_grid(vtkImageData& image) {
    int nodes[3];
    int extent[6];
    image.GetDimensions(nodes);
    image.GetExtent(extent);
    if (auto thick = check_thickness(nodes); !thick)
        return tl::unexpected(thick.error());
    core::UniformGrid grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.dimensions[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(nodes[axis]);
        grid.spacing[axis] = image.GetSpacing()[axis];
        grid.origin[axis] = image.GetOrigin()[axis] + extent[2 * axis] * image.GetSpacing()[axis];
    }
    if (auto size = store::check_grid(store::stored_grid(grid)); !size)
        return core::fail(size.error().code, size.error().message);
    return grid;
}

core::Result<core::RectilinearGrid> rectilinear_grid(vtkRectilinearGrid& data) {
    int nodes[3];
    data.GetDimensions(nodes);
    if (auto thick = check_thickness(nodes); !thick)
        return tl::unexpected(thick.error());
    core::RectilinearGrid grid;
    const std::array<vtkDataArray*, 3> axes{data.GetXCoordinates(), data.GetYCoordinates(),
                                            data.GetZCoordinates()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& along = grid.coordinates[axis];
        for (vtkIdType i = 0; i < nodes[axis]; ++i)
            along.push_back(axes[axis]->GetComponent(i, 0));
        const bool rising =
            std::all_of(along.begin(), along.end(), [](double x) { return std::isfinite(x); }) &&
            std::adjacent_find(along.begin(), along.end(),
                               [](double a, double b) { return !(a < b); }) == along.end();
        if (!rising)
            return core::fail(Error::Code::Corrupt, std::string("has coordinates along ") +
                                                        "xyz"[axis] + " that do not increase");
    }
    return grid;
}

bool is_rotated(vtkImageData& image) {
    return !image.GetDirectionMatrix()->IsIdentity();
}

// Says whether cells or points of a data set are marked as hidden or as another piece's.
bool has_blanks(vtkDataSet& data) {
    using Marks = vtkDataSetAttributes;
    return any_marked(*data.GetCellData(),
                      Marks::HIDDENCELL | Marks::DUPLICATECELL | Marks::REFINEDCELL) ||
           any_marked(*data.GetPointData(), Marks::HIDDENPOINT);
}

GridAssembly of_grid(core::Grid grid) {
    GridAssembly out;
    out.grid = std::move(grid);
    out.source_cells = core::cell_count(out.grid);
    out.source_nodes = core::node_count(out.grid);
    return out;
}

core::Result<GridAssembly> assemble_blocks(BlockList blocks, const AssemblyRequest& request) {
    const bool solid = std::any_of(request.solid.begin(), request.solid.end(),
                                   [](const auto& block) { return !block.empty(); });
    if (solid || !is_grid(blocks))
        return assemble_mesh(blocks, request);
    if (auto* image = vtkImageData::SafeDownCast(blocks.front()))
        return uniform_grid(*image).map([](const auto& grid) { return of_grid(grid); });
    return rectilinear_grid(*vtkRectilinearGrid::SafeDownCast(blocks.front()))
        .map([](const auto& grid) { return of_grid(grid); });
}

} // namespace

bool is_grid(BlockList blocks) {
    if (blocks.size() != 1 || has_blanks(*blocks.front()))
        return false;
    auto* image = vtkImageData::SafeDownCast(blocks.front());
    return (image != nullptr && !is_rotated(*image)) ||
           vtkRectilinearGrid::SafeDownCast(blocks.front()) != nullptr;
}

core::Result<GridAssembly> assemble_grid(BlockList blocks, const AssemblyRequest& request) {
    const auto marked = blocks.empty() ? std::nullopt : marked_slab(*blocks.front());
    if (!marked)
        return assemble_blocks(blocks, request);
    return assemble_blocks(blocks, request).map([&](GridAssembly&& slab) {
        slab.across = marked->across;
        add_note(slab.note,
                 "a plane flow: its cells are given a thickness, and nothing moves across");
        return std::move(slab);
    });
}

} // namespace wakesurf::importer
