// The values of one field at the nodes of an assembled grid, at one time-step: point data as they are, cell
// data averaged.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/fields/velocity_choice.hpp"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Calls visit(value) with a function value(tuple, component) -> double. The function knows an array of float
/// or double by its type: a virtual call a number takes ten times as long.
template <class Visit>
void with_tuples(vtkDataArray& array, const Visit& visit) {
    const auto components = static_cast<std::size_t>(array.GetNumberOfComponents());
    if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(&array)) {
        const float* at = floats->GetPointer(0);
        visit([at, components](std::size_t i, std::size_t c) {
            return static_cast<double>(at[i * components + c]);
        });
    } else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(&array)) {
        const double* at = doubles->GetPointer(0);
        visit([at, components](std::size_t i, std::size_t c) { return at[i * components + c]; });
    } else {
        visit([&array](std::size_t i, std::size_t c) {
            return array.GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c));
        });
    }
}

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
