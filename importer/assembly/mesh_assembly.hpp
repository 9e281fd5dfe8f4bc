// Blocks of cells -> one core::CellMesh and the way from the blocks' points and cells to its nodes: the part
// of grid_assembly.hpp that images and rectilinear grids need not go through.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/cell_neighbours.hpp"
#include "core/dataset/grid.hpp"
#include "importer/assembly/point_merging.hpp"
#include "importer/assembly/polyhedron_cutter.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

using BlockList = std::span<const vtkSmartPointer<vtkDataSet>>;

/// Stands for no node.
inline constexpr std::uint32_t no_node = 0xffffffffu;

/// Says where the values of one block go.
struct BlockNodes {
    /// Holds the node of each point; no_node where the point is unused, or another block's stands for it.
    std::vector<std::uint32_t> node_of_point;
    /// The nodes of cell i, each once, are cell_nodes[first[i]] .. cell_nodes[first[i + 1]]; none of a cell
    /// left out.
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> cell_nodes;
};

/// A point of a node that has one before, in an earlier block or in this one.
struct FurtherPoint {
    std::uint32_t block, point, node;
    std::uint32_t number; ///< of the node's points so far, with this one
};

struct GridAssembly {
    core::Grid grid;
    /// Is true of a mesh of cells that is made of structured blocks only.
    bool curvilinear = false;
    /// Counts the cells that are kept, before polyhedra are cut.
    std::uint64_t source_cells = 0;
    /// Counts the nodes that are points of the source: they are the first ones.
    std::size_t source_nodes = 0;
    /// Is empty unless the grid is a mesh of cells: the points of other grids are their nodes.
    std::vector<BlockNodes> blocks;
    /// Lists the points that are a node which has a point before them: the values at a node are their mean.
    std::vector<FurtherPoint> further;
    /// The points of several pieces that are one node, as far as velocities were looked at.
    MeetingPoints meeting;
    /// Numbers the place of each node of the source; empty unless pieces that meet stay apart.
    std::vector<std::uint32_t> place;
    AddedNodes added;
    /// The nodes that are one where the flow repeats: along x, then y, then z.
    OppositeNodes opposite;
    /// The direction across a plane that was given a thickness.
    std::optional<core::Vec3> across{};
    /// Says what was left out or reordered; may be empty.
    std::string note;
};

/// Hands out the velocities at the points of all blocks, one block after the other, at one time-step after the
/// other.
using EachVelocity =
    std::function<core::Result<void>(const std::function<void(std::span<const float>)>& take)>;

struct AssemblyRequest {
    /// Holds by block which cells are solid; an empty block has none. They are left out, and the faces they
    /// leave are walls.
    std::vector<std::vector<bool>> solid;
    /// Asks for BlockNodes::first and cell_nodes, which cell data need.
    bool cell_nodes = true;
    /// Called where pieces meet: those whose velocities jump there stay apart. Without it none does.
    EachVelocity velocities{};
};

/// Returns a mesh that is connected (core/dataset/cell_neighbours.hpp). Fails as assemble_grid does.
core::Result<GridAssembly> assemble_mesh(BlockList blocks, const AssemblyRequest& request);

/// Returns the source's nodes of the polygon that a face is, or is a triangle of, in ascending order: a large
/// face that was cut is known by the centre it was cut round.
std::vector<std::uint32_t>
source_polygon(const GridAssembly& assembly, const core::MeshCell& cell, std::size_t face);

} // namespace wakesurf::importer
