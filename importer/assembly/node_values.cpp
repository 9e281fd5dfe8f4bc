#include "importer/assembly/node_values.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
constexpr float largest = std::numeric_limits<float>::max();

float stored(double value) {
    const auto out = static_cast<float>(value);
    return std::isfinite(out) ? out : no_value;
}

core::Result<vtkDataArray*> array_of(vtkDataSet& block, const FieldInfo& field) {
    const bool of_points = field.source == FieldInfo::Source::Point;
    vtkDataSetAttributes& attributes =
        of_points ? static_cast<vtkDataSetAttributes&>(*block.GetPointData())
                  : static_cast<vtkDataSetAttributes&>(*block.GetCellData());
    vtkDataArray* array = attributes.GetArray(field.name.c_str());
    if (array == nullptr)
        return core::fail(Error::Code::NotFound, "has no field " + field.name);
    const vtkIdType wanted = of_points ? block.GetNumberOfPoints() : block.GetNumberOfCells();
    if (array->GetNumberOfComponents() != field.components || array->GetNumberOfTuples() != wanted)
        return core::fail(Error::Code::Corrupt,
                          "has " + std::to_string(array->GetNumberOfTuples()) + " values of " +
                              std::to_string(array->GetNumberOfComponents()) +
                              " components in its field " + field.name + " instead of " +
                              std::to_string(wanted) + " of " + std::to_string(field.components));
    return array;
}

// Calls visit(component, value) for each component of a field, where value(i) is that of point or cell i.
template <class Visit>
core::Result<void>
visit_components(vtkDataSet& block, const FieldParts& field, const Visit& visit) {
    std::vector<double> divisor;
    for (const auto& info : field.divisor) {
        const auto array = array_of(block, info);
        if (!array)
            return tl::unexpected(array.error());
        divisor.resize(static_cast<std::size_t>((*array)->GetNumberOfTuples()));
        with_tuples(**array, [&](const auto& value) {
            for (std::size_t i = 0; i < divisor.size(); ++i)
                divisor[i] = value(i, 0);
        });
    }
    std::size_t component = 0;
    for (const auto& info : field.arrays) {
        const auto array = array_of(block, info);
        if (!array)
            return tl::unexpected(array.error());
        with_tuples(**array, [&](const auto& value) {
            for (std::size_t c = 0; c < static_cast<std::size_t>(info.components);
                 ++c, ++component) {
                if (divisor.empty())
                    visit(component, [&](std::size_t i) { return value(i, c); });
                else
                    visit(component, [&](std::size_t i) { return value(i, c) / divisor[i]; });
            }
        });
    }
    return {};
}

// Visits the hexahedra of a uniform or rectilinear grid, their nodes in VTK's order.
template <class Visit>
void visit_grid_cells(const std::array<std::size_t, 3>& nodes, const Visit& visit) {
    std::size_t cell = 0;
    for (std::size_t k = 0; k + 1 < nodes[2]; ++k)
        for (std::size_t j = 0; j + 1 < nodes[1]; ++j)
            for (std::size_t i = 0; i + 1 < nodes[0]; ++i, ++cell) {
                const std::size_t at = i + nodes[0] * (j + nodes[1] * k);
                const std::size_t up = at + nodes[0] * nodes[1];
                visit(cell, std::array{at, at + 1, at + nodes[0], at + nodes[0] + 1, up, up + 1,
                                       up + nodes[0], up + nodes[0] + 1});
            }
}

std::array<std::size_t, 3> nodes_along(const core::Grid& grid) {
    if (const auto* uniform = std::get_if<core::UniformGrid>(&grid))
        return {uniform->dimensions[0], uniform->dimensions[1], uniform->dimensions[2]};
    const auto& axes = std::get<core::RectilinearGrid>(grid).coordinates;
    return {axes[0].size(), axes[1].size(), axes[2].size()};
}

class NodeValues {
  public:
    NodeValues(const GridAssembly& assembly, const FieldParts& field)
        : assembly_(assembly), field_(field), width_(static_cast<std::size_t>(field.components)),
          out_(width_ * core::node_count(assembly.grid)) {}

    core::Result<std::vector<float>> run(BlockList blocks, std::span<const std::uint32_t> still) {
        const bool of_points = field_.arrays.front().source == FieldInfo::Source::Point;
        if (auto got = of_points ? copy(blocks) : average(blocks); !got)
            return tl::unexpected(got.error());
        if (of_points)
            join_opposite();
        for (const std::uint32_t node : still)
            std::fill_n(out_.begin() + static_cast<std::ptrdiff_t>(width_ * node), width_, 0.0f);
        if (width_ == 3)
            turn_round_axis();
        interpolate_added();
        return std::move(out_);
    }

  private:
    bool of_cells() const { return !assembly_.blocks.empty(); }

    core::Result<void> copy(BlockList blocks) {
        for (std::size_t b = blocks.size(); b-- > 0;) { // the first block's values stay
            const auto whole = copy_floats(*blocks[b], b);
            if (!whole)
                return tl::unexpected(whole.error());
            if (*whole)
                continue;
            auto copied =
                visit_components(*blocks[b], field_, [&](std::size_t c, const auto& value) {
                    visit_points(b, [&](std::size_t point, std::size_t node) {
                        out_[width_ * node + c] = stored(value(point));
                    });
                });
            if (!copied)
                return copied;
        }
        return add_further(blocks);
    }

    // Copies the commonest kind of field, one array of floats, in one pass. Returns false for any other kind.
    core::Result<bool> copy_floats(vtkDataSet& block, std::size_t number) {
        if (field_.arrays.size() != 1 || !field_.divisor.empty())
            return false;
        const auto array = array_of(block, field_.arrays.front());
        if (!array)
            return tl::unexpected(array.error());
        auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(*array);
        if (floats == nullptr)
            return false;
        const float* from = floats->GetPointer(0);
        const auto bounded = [](float value) {
            return std::abs(value) <= largest ? value : no_value;
        };
        if (!of_cells())
            std::transform(from, from + out_.size(), out_.begin(), bounded);
        else
            visit_points(number, [&](std::size_t point, std::size_t node) {
                for (std::size_t c = 0; c < width_; ++c)
                    out_[width_ * node + c] = bounded(from[width_ * point + c]);
            });
        return true;
    }

    // Calls visit(point, node) for the points of a block that have a node.
    template <class Visit>
    void visit_points(std::size_t block, const Visit& visit) const {
        if (!of_cells()) {
            for (std::size_t i = 0; i < assembly_.source_nodes; ++i)
                visit(i, i);
            return;
        }
        const auto& nodes = assembly_.blocks[block].node_of_point;
        for (std::size_t i = nodes.size(); i-- > 0;) // the first point's values stay
            if (nodes[i] != no_node)
                visit(i, std::size_t{nodes[i]});
    }

    // Makes values the means of those of all points of a node that have one.
    core::Result<void> add_further(BlockList blocks) {
        const auto& all = assembly_.further; // block by block
        for (auto begin = all.begin(); begin != all.end();) {
            const std::uint32_t block = begin->block;
            const auto end =
                std::find_if(begin, all.end(), [&](const auto& p) { return p.block != block; });
            auto added =
                visit_components(*blocks[block], field_, [&](std::size_t c, const auto& value) {
                    for (auto at = begin; at != end; ++at) {
                        float& mean = out_[width_ * at->node + c];
                        const float here = stored(value(at->point));
                        if (std::isnan(mean))
                            mean = here;
                        else if (!std::isnan(here))
                            mean = static_cast<float>(mean + (double{here} - mean) / at->number);
                    }
                });
            if (!added)
                return added;
            begin = end;
        }
        return {};
    }

    // Nodes that are one where the flow repeats have the mean of both.
    void join_opposite() {
        for (const auto& [low, high] : assembly_.opposite)
            for (std::size_t c = 0; c < width_; ++c) {
                float& a = out_[width_ * low + c];
                float& b = out_[width_ * high + c];
                a = b = std::isnan(a)   ? b
                        : std::isnan(b) ? a
                                        : static_cast<float>(0.5 * (double{a} + double{b}));
            }
    }

    // Averages one component at a time: sums are double, in the order of the cells.
    core::Result<void> average(BlockList blocks) {
        std::vector<std::uint32_t> cells = cells_round_nodes();
        std::vector<std::vector<double>> sums(width_, std::vector<double>(assembly_.source_nodes));
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            auto added =
                visit_components(*blocks[b], field_, [&](std::size_t c, const auto& value) {
                    visit_cells(b, [&](std::size_t cell, const auto& nodes) {
                        const double here = value(cell);
                        for (const auto node : nodes)
                            sums[c][node] += here;
                    });
                });
            if (!added)
                return added;
        }
        for (const auto& [low, high] : assembly_.opposite) { // the cells round both
            cells[low] = cells[high] += cells[low];
            for (auto& sum : sums)
                sum[low] = sum[high] += sum[low];
        }
        for (std::size_t i = 0; i < assembly_.source_nodes; ++i)
            for (std::size_t c = 0; c < width_ && cells[i] > 0; ++c)
                out_[width_ * i + c] = stored(sums[c][i] / cells[i]);
        return {};
    }

    template <class Visit>
    void visit_cells(std::size_t block, const Visit& visit) const {
        if (!of_cells())
            return visit_grid_cells(nodes_along(assembly_.grid), visit);
        const BlockNodes& nodes = assembly_.blocks[block];
        for (std::size_t cell = 0; cell + 1 < nodes.first.size(); ++cell)
            if (nodes.first[cell] != nodes.first[cell + 1])
                visit(cell,
                      std::span(nodes.cell_nodes)
                          .subspan(nodes.first[cell], nodes.first[cell + 1] - nodes.first[cell]));
    }

    std::vector<std::uint32_t> cells_round_nodes() const {
        std::vector<std::uint32_t> count(assembly_.source_nodes, 0);
        const std::size_t blocks = of_cells() ? assembly_.blocks.size() : 1;
        for (std::size_t b = 0; b < blocks; ++b)
            visit_cells(b, [&](std::size_t, const auto& nodes) {
                for (const auto node : nodes)
                    ++count[node];
            });
        return count;
    }

    // The vector of a wedge's cell is that in its half plane. A node has it on either side, so it is turned to where
    // the node is; on the axis only what points along it is left.
    void turn_round_axis() {
        const auto* mesh = std::get_if<core::CellMesh>(&assembly_.grid);
        if (mesh == nullptr || !mesh->axis)
            return;
        const core::SymmetryAxis& axis = *mesh->axis;
        const core::Vec3 around = glm::cross(axis.direction, axis.radial);
        const double size = core::bounds(assembly_.grid).diagonal();
        for (std::size_t node = 0; node < mesh->points.size(); ++node) {
            float* const values = out_.data() + 3 * node;
            const core::Vec3 v(values[0], values[1], values[2]);
            const core::Vec3 from = mesh->points[node] - axis.origin;
            const double x = glm::dot(from, axis.radial);
            const double y = glm::dot(from, around);
            const double radius = std::hypot(x, y);
            core::Vec3 turned = glm::dot(v, axis.direction) * axis.direction;
            if (radius > 1e-9 * size) {
                const double outward = glm::dot(v, axis.radial);
                const double sideways = glm::dot(v, around);
                turned += (outward * x - sideways * y) / radius * axis.radial +
                          (outward * y + sideways * x) / radius * around;
            }
            for (int k = 0; k < 3; ++k)
                values[k] = stored(turned[k]);
        }
    }

    void interpolate_added() {
        const AddedNodes& added = assembly_.added;
        for (std::size_t i = 0; i < added.size(); ++i)
            for (std::size_t c = 0; c < width_; ++c) {
                double sum = 0.0;
                for (std::size_t part = added.first[i]; part < added.first[i + 1]; ++part)
                    sum += added.weight[part] *
                           static_cast<double>(out_[width_ * added.node[part] + c]);
                out_[width_ * (assembly_.source_nodes + i) + c] = stored(sum);
            }
    }

    const GridAssembly& assembly_;
    const FieldParts& field_;
    std::size_t width_;
    std::vector<float> out_;
};

} // namespace

core::Result<std::vector<float>> point_values(BlockList blocks, const FieldParts& field) {
    std::size_t points = 0;
    for (const auto& block : blocks)
        points += static_cast<std::size_t>(block->GetNumberOfPoints());
    const auto width = static_cast<std::size_t>(field.components);
    std::vector<float> out(width * points);
    std::size_t first = 0;
    for (const auto& block : blocks) {
        const auto count = static_cast<std::size_t>(block->GetNumberOfPoints());
        auto taken = visit_components(*block, field, [&](std::size_t c, const auto& value) {
            for (std::size_t i = 0; i < count; ++i)
                out[width * (first + i) + c] = stored(value(i));
        });
        if (!taken)
            return tl::unexpected(taken.error());
        first += count;
    }
    return out;
}

core::Result<std::vector<float>> node_values(const GridAssembly& assembly,
                                             BlockList blocks,
                                             const FieldParts& field,
                                             std::span<const std::uint32_t> still) {
    return NodeValues(assembly, field).run(blocks, still);
}

} // namespace wakesurf::importer
