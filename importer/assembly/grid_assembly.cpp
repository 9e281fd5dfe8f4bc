#include "importer/assembly/grid_assembly.hpp"

#include "importer/assembly/mesh_assembly.hpp"
#include "importer/assembly/structured_grids.hpp"

#include <algorithm>

namespace wakesurf::importer {

namespace {

GridAssembly of_grid(core::Grid grid) {
    GridAssembly out;
    out.grid = std::move(grid);
    out.source_cells = core::cell_count(out.grid);
    out.source_nodes = core::node_count(out.grid);
    return out;
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
    const bool solid = std::any_of(request.solid.begin(), request.solid.end(),
                                   [](const auto& block) { return !block.empty(); });
    if (solid || !is_grid(blocks))
        return assemble_mesh(blocks, request);
    if (auto* image = vtkImageData::SafeDownCast(blocks.front()))
        return uniform_grid(*image).map([](const auto& grid) { return of_grid(grid); });
    return rectilinear_grid(*vtkRectilinearGrid::SafeDownCast(blocks.front()))
        .map([](const auto& grid) { return of_grid(grid); });
}

} // namespace wakesurf::importer
