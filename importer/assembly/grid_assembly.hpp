// A source's blocks -> one core::Grid and the way from the blocks' points and cells to its nodes. Done once for all
// time-steps of a source: they share one mesh.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "importer/assembly/added_nodes.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

using BlockList = std::span<const vtkSmartPointer<vtkDataSet>>;

inline constexpr std::uint32_t no_node = 0xffffffffu;

/// Where the values of one block go.
struct BlockNodes {
    std::vector<std::uint32_t>
        node_of_point; ///< no_node: unused, or another block's point stands for it
    /// The nodes of cell i, each once, are cell_nodes[first[i]] .. cell_nodes[first[i + 1]]; none of a cell left out.
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> cell_nodes;
};

struct GridAssembly {
    core::Grid grid;
    bool curvilinear = false;       ///< a mesh of cells made of structured blocks only
    std::uint64_t source_cells = 0; ///< kept, before polyhedra were cut
    std::size_t source_nodes = 0;   ///< nodes that are points of the source: the first ones
    std::vector<BlockNodes> blocks; ///< of a mesh of cells; points are the nodes of other grids
    AddedNodes added;
    std::string note; ///< what was left out or reordered; may be empty
};

struct AssemblyRequest {
    /// Cells that are solid, by block; an empty block has none. They are left out, and the faces they leave are walls.
    std::vector<std::vector<bool>> solid;
    bool cell_nodes = true; ///< fill BlockNodes::first and cell_nodes, which cell data need
};

/// One image is a uniform grid, one rectilinear grid a rectilinear one, unless cells of it are blanked or solid or the image
/// is rotated; everything else is a mesh of cells, connected (core/dataset/cell_neighbours.hpp).
/// Error, to be read after the file's name: Unsupported (no three-dimensional cells, curved cells), Corrupt, OverLimit
/// (2^32 points).
bool is_grid(BlockList blocks); ///< whether it is no mesh of cells
core::Result<GridAssembly> assemble_grid(BlockList blocks, const AssemblyRequest& request = {});

} // namespace wakesurf::importer
