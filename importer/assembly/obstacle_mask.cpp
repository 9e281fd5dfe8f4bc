#include "importer/assembly/obstacle_mask.hpp"

#include "importer/assembly/block_cells.hpp"
#include "importer/assembly/node_values.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <limits>
#include <string>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

vtkDataSetAttributes& attributes_of(vtkDataSet& block, const FieldInfo& field) {
    return field.source == FieldInfo::Source::Point
               ? static_cast<vtkDataSetAttributes&>(*block.GetPointData())
               : static_cast<vtkDataSetAttributes&>(*block.GetCellData());
}

vtkDataArray* values_of(vtkDataSet& block, const FieldInfo& field) {
    return attributes_of(block, field).GetArray(field.name.c_str());
}

// Returns for each point or cell whether it is solid.
core::Result<std::vector<bool>> read_array(vtkDataSet& block, const FieldChoice& choice) {
    const FieldInfo& mask = *choice.mask;
    const bool of_points = mask.source == FieldInfo::Source::Point;
    vtkDataArray* const array = values_of(block, mask);
    const vtkIdType wanted = of_points ? block.GetNumberOfPoints() : block.GetNumberOfCells();
    if (array == nullptr || array->GetNumberOfTuples() != wanted)
        return core::fail(Error::Code::NotFound, "has no whole field " + mask.name);
    std::vector<bool> solid(static_cast<std::size_t>(wanted));
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
        if (value != 0.0 && value != 1.0)
            return core::fail(
                Error::Code::Corrupt,
                "has a mask " + mask.name + " that is " + std::to_string(value) +
                    (of_points ? " at node " : " in cell ") + std::to_string(i),
                "a mask holds 0 and 1 only; give the field another name if it is not a mask");
        solid[i] = (value == 1.0) == choice.mask_marks_solid;
    }
    return solid;
}

// Calls the condition for a cell's own points, some perhaps several times.
template <class Condition>
bool all_points(const BlockCell& cell, const Condition& condition) {
    if (cell.form == BlockCell::Form::Standard)
        return std::all_of(cell.point.begin(),
                           cell.point.begin() +
                               static_cast<std::ptrdiff_t>(core::node_count(cell.shape)),
                           condition);
    return std::all_of(cell.faces.begin(), cell.faces.end(), [&](const auto& face) {
        return std::all_of(face.begin(), face.end(), condition);
    });
}

core::Result<std::vector<bool>> solid_cells(vtkDataSet& block,
                                            const std::vector<bool>& solid_points) {
    BlockCells cells(block);
    BlockCell cell;
    std::vector<bool> solid(cells.size(), false);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (auto read = cells.read(i, cell); !read)
            return tl::unexpected(read.error());
        solid[i] = cell.form != BlockCell::Form::None &&
                   all_points(cell, [&](std::uint32_t p) { return solid_points[p]; });
    }
    return solid;
}

std::vector<bool> points_of(vtkDataSet& block, const std::vector<bool>& solid_cells) {
    std::vector<bool> solid(static_cast<std::size_t>(block.GetNumberOfPoints()), false);
    vtkNew<vtkIdList> points;
    for (std::size_t cell = 0; cell < solid_cells.size(); ++cell) {
        if (!solid_cells[cell])
            continue;
        block.GetCellPoints(static_cast<vtkIdType>(cell), points);
        for (const vtkIdType point : *points)
            solid[static_cast<std::size_t>(point)] = true;
    }
    return solid;
}

// Gives the block an array without values where it is solid, in the place of a field's.
void take_away(vtkDataSet& block, const FieldInfo& field, const std::vector<bool>& solid) {
    vtkDataArray* const array = values_of(block, field);
    if (array == nullptr || array->GetNumberOfTuples() != static_cast<vtkIdType>(solid.size()))
        return; // whoever reads its values says so
    vtkNew<vtkDoubleArray> without;
    without->DeepCopy(array);
    without->SetName(field.name.c_str());
    for (std::size_t i = 0; i < solid.size(); ++i)
        for (int c = 0; solid[i] && c < without->GetNumberOfComponents(); ++c)
            without->SetComponent(static_cast<vtkIdType>(i), c,
                                  std::numeric_limits<double>::quiet_NaN());
    attributes_of(block, field).AddArray(without);
}

core::Result<std::vector<std::uint8_t>> fluid_nodes(BlockList blocks, const FieldChoice& choice) {
    auto assembly = assemble_grid(blocks);
    if (!assembly)
        return tl::unexpected(assembly.error());
    return node_values(*assembly, blocks, {{*choice.mask}, {}, 1}).map([&](const auto& values) {
        std::vector<std::uint8_t> fluid(values.size());
        std::transform(values.begin(), values.end(), fluid.begin(), [&](float value) {
            return static_cast<std::uint8_t>((value >= 0.5f) != choice.mask_marks_solid);
        });
        return fluid;
    });
}

} // namespace

bool is_zero_or_one(BlockList blocks, const FieldInfo& field) {
    return std::all_of(blocks.begin(), blocks.end(), [&](const auto& block) {
        vtkDataArray* const array = values_of(*block, field);
        for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
            if (const double value = array->GetComponent(i, 0); value != 0.0 && value != 1.0)
                return false;
        return true;
    });
}

core::Result<ObstacleMask> read_mask(BlockList blocks, const FieldChoice& choice) {
    ObstacleMask mask;
    if (!choice.mask || choice.mask_use == MaskUse::Gap)
        return mask;
    const bool grid = is_grid(blocks);
    for (const auto& block : blocks) {
        auto solid = read_array(*block, choice);
        if (solid && !grid && choice.mask->source == FieldInfo::Source::Point)
            solid = solid_cells(*block, *solid);
        if (!solid)
            return tl::unexpected(solid.error());
        if (!grid)
            mask.solid.push_back(std::move(*solid));
    }
    if (!grid)
        return mask;
    return fluid_nodes(blocks, choice).map([&](auto fluid) {
        mask.fluid = std::move(fluid);
        return std::move(mask);
    });
}

core::Result<void> leave_body_out(std::vector<vtkSmartPointer<vtkDataSet>>& blocks,
                                  const FieldChoice& choice) {
    if (!choice.mask || choice.mask_use != MaskUse::Gap)
        return {};
    for (auto& block : blocks) {
        auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
        copy->ShallowCopy(block);
        block = copy;
        auto solid = read_array(*block, choice);
        const auto source = choice.velocity.arrays.front().source;
        if (solid && source != choice.mask->source)
            solid = source == FieldInfo::Source::Point ? points_of(*block, *solid)
                                                       : solid_cells(*block, *solid);
        if (!solid)
            return tl::unexpected(solid.error());
        for (const FieldInfo& field : choice.velocity.arrays)
            take_away(*block, field, *solid);
    }
    return {};
}

} // namespace wakesurf::importer
