// The values of one field at the nodes of an assembled grid, at one time-step: point data as they are, cell
// data averaged.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/fields/velocity_choice.hpp"

#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns the point data of all blocks interleaved, one block after the other. What is not finite, or not in
/// single precision, is NaN. Error: as node_values.
core::Result<std::vector<float>> point_values(BlockList blocks, const FieldParts& field);

/// Returns values interleaved, in node order. Point data stay as they are. Cell data are averaged with equal
/// weights over the cells round a node of the whole mesh, each counted once, before polyhedra are cut: within
/// a block that is what vtkCellDataToPointData returns. A node of several points has the mean of their point
/// values. Nodes in `still` (of the source) are 0; added nodes have the weighted mean of their parts. What is
/// not finite, or not in single precision, is NaN. Error, to be read after the file's name: NotFound,
/// Corrupt.
core::Result<std::vector<float>> node_values(const GridAssembly& assembly,
                                             BlockList blocks,
                                             const FieldParts& field,
                                             std::span<const std::uint32_t> still = {});

} // namespace wakesurf::importer
