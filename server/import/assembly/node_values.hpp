// The values of one field at the nodes of an assembled grid, at one time-step: point data as they are, cell data averaged.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "server/import/assembly/grid_assembly.hpp"

#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Reads a field of several arrays of equal length: `components` numbers a tuple.
struct FieldParts {
    std::vector<core::FieldInfo>
        arrays; ///< one of all components, or one a component; all of points or all of cells
    std::vector<core::FieldInfo>
        divisor; ///< empty, or one array of 1 component by which the others are divided
    int components = 1;
};

/// Cell data are averaged with equal weights over the cells round a node of the whole mesh, each counted once, before
/// polyhedra are cut: within a block what vtkCellDataToPointData returns. Where blocks meet, a node has the point value of
/// the first. Nodes in `still` (of the source) are 0; added nodes have the weighted mean of their parts. What is not
/// finite, or not in single precision, is NaN. Values interleaved, in node order.
/// Error, to be read after the file's name: NotFound, Corrupt.
core::Result<std::vector<float>> node_values(const GridAssembly& assembly,
                                             BlockList blocks,
                                             const FieldParts& field,
                                             std::span<const std::uint32_t> still = {});

} // namespace wakesurf::server
