#include "server/remote/zarr/brick_pieces.hpp"

#include "server/remote/zarr/zarr_chunk.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

/// Holds the numbers from..to along an axis.
struct Interval {
    std::uint64_t from = 0;
    std::uint64_t to = 1;
};

/// Returns the nodes of the brick that the grid has.
std::array<Interval, 3> nodes_of(const core::BrickLayout& layout, std::size_t brick) {
    const auto first = layout.first_node(brick);
    std::array<Interval, 3> out;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = {first[i], std::min<std::uint64_t>(first[i] + layout.brick_nodes()[i],
                                                    layout.dimensions()[i])};
    return out;
}

/// Returns the part of an interval that is in a chunk.
Interval within(const Interval& wanted, std::uint64_t chunk, std::uint64_t length) {
    return {std::max(wanted.from, chunk * length), std::min(wanted.to, (chunk + 1) * length)};
}

/// Collects the pieces of one array.
class Pieces {
  public:
    Pieces(const ZarrDataset& dataset, std::size_t array, std::vector<Interval> wanted)
        : of_(dataset.arrays[array]), axes_(dataset.axes[array]), array_(array),
          wanted_(std::move(wanted)) {}

    void add_to(std::vector<BrickPiece>& out,
                const std::array<Interval, 3>& nodes,
                const std::vector<ZarrPart>& parts) const {
        std::vector<std::uint64_t> chunk;
        for (std::size_t axis = 0; axis < wanted_.size(); ++axis)
            chunk.push_back(wanted_[axis].from / of_.chunks[axis]);
        do
            out.push_back(piece(chunk, nodes, parts));
        while (next(chunk));
    }

  private:
    /// Advances the last axis fastest; returns false behind the last chunk.
    bool next(std::vector<std::uint64_t>& chunk) const {
        for (std::size_t axis = chunk.size(); axis-- > 0;) {
            if (++chunk[axis] * of_.chunks[axis] < wanted_[axis].to)
                return true;
            chunk[axis] = wanted_[axis].from / of_.chunks[axis];
        }
        return false;
    }

    BrickPiece piece(const std::vector<std::uint64_t>& chunk,
                     const std::array<Interval, 3>& nodes,
                     const std::vector<ZarrPart>& parts) const {
        BrickPiece out{array_, chunk, {}, {}, {}, parts.size(), {}};
        const auto here = [&](std::size_t axis) {
            return within(wanted_[axis], chunk[axis], of_.chunks[axis]);
        };
        for (std::size_t axis = 0; axis < chunk.size(); ++axis)
            out.from.push_back(here(axis).from - chunk[axis] * of_.chunks[axis]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Interval along = here(axes_.place[i]);
            out.first[i] = static_cast<std::size_t>(along.from - nodes[i].from);
            out.count[i] = static_cast<std::size_t>(along.to - along.from);
        }
        const Interval has = axes_.component ? here(*axes_.component) : Interval{};
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].array == array_ && parts[i].component >= has.from &&
                parts[i].component < has.to)
                out.components.push_back({i, parts[i].component - has.from});
        return out;
    }

    const ZarrArray& of_;
    const ZarrAxes& axes_;
    std::size_t array_;
    std::vector<Interval> wanted_; ///< along each axis of the array
};

} // namespace

std::vector<BrickPiece> pieces_of(const ZarrDataset& dataset,
                                  const core::BrickLayout& layout,
                                  std::size_t column,
                                  std::size_t step,
                                  std::size_t brick) {
    const auto& parts = dataset.columns[column];
    const auto nodes = nodes_of(layout, brick);
    std::vector<BrickPiece> out;
    for (std::size_t array = 0; array < dataset.arrays.size(); ++array) {
        if (std::ranges::find(parts, array, &ZarrPart::array) == parts.end())
            continue;
        const ZarrAxes& axes = dataset.axes[array];
        std::vector<Interval> wanted(dataset.arrays[array].shape.size());
        if (axes.time)
            wanted[*axes.time] = {step, step + 1};
        if (axes.component)
            wanted[*axes.component] = {0, parts.size()};
        for (std::size_t i = 0; i < 3; ++i)
            wanted[axes.place[i]] = nodes[i];
        Pieces(dataset, array, std::move(wanted)).add_to(out, nodes, parts);
    }
    return out;
}

bool put_piece(const ZarrDataset& dataset,
               const core::BrickLayout& layout,
               const BrickPiece& piece,
               std::span<const std::byte> chunk,
               std::span<float> brick) {
    const ZarrArray& array = dataset.arrays[piece.array];
    const ZarrAxes& axes = dataset.axes[piece.array];
    const auto& nodes = layout.brick_nodes();
    std::vector<std::size_t> stride(array.shape.size(), array.number_bytes);
    for (std::size_t axis = stride.size() - 1; axis > 0; --axis)
        stride[axis - 1] = stride[axis] * static_cast<std::size_t>(array.chunks[axis]);
    std::size_t origin = 0;
    for (std::size_t axis = 0; axis < stride.size(); ++axis)
        origin += static_cast<std::size_t>(piece.from[axis]) * stride[axis];
    const float fill = chunk.empty() ? static_cast<float>(filled_value(array)) : 0.0F;
    bool finite = std::isfinite(fill);
    for (const auto& component : piece.components)
        for (std::size_t k = 0; k < piece.count[2]; ++k)
            for (std::size_t j = 0; j < piece.count[1]; ++j) {
                const std::size_t node =
                    piece.first[0] +
                    nodes[0] * (piece.first[1] + j + nodes[1] * (piece.first[2] + k));
                float* const to = brick.data() + node * piece.all_components + component.in_brick;
                if (chunk.empty()) {
                    for (std::size_t i = 0; i < piece.count[0]; ++i)
                        to[i * piece.all_components] = fill;
                    continue;
                }
                const std::size_t from =
                    origin + k * stride[axes.place[2]] + j * stride[axes.place[1]] +
                    (axes.component
                         ? static_cast<std::size_t>(component.from) * stride[*axes.component]
                         : 0);
                finite &= read_values(array, chunk.data() + from, stride[axes.place[0]], to,
                                      piece.all_components, piece.count[0]);
            }
    return finite;
}

void repeat_last(const core::BrickLayout& layout,
                 std::size_t brick,
                 std::size_t components,
                 std::span<float> values) {
    const auto there = nodes_of(layout, brick);
    std::size_t stride = components; // of a node along the axis
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t nodes = layout.brick_nodes()[axis];
        const auto filled = static_cast<std::size_t>(there[axis].to - there[axis].from);
        for (std::size_t row = 0; row < values.size(); row += stride * nodes)
            for (std::size_t node = filled; node < nodes; ++node)
                std::copy_n(values.data() + row + stride * (filled - 1), stride,
                            values.data() + row + stride * node);
        stride *= nodes;
    }
}

} // namespace wakesurf::server
