// Velocities of a batch's particles as CubicSampler has them: Catmull-Rom in space over 4^3 nodes, trilinear
// near obstacles, and four time-steps. A row of four nodes is twelve floats: Lanes::FourNodes. Rows are added
// up particle by particle whatever the vectors, as one row fills the widest. Twin: linear_sampling.hpp.
#pragma once

#include "core/field/kernel/linear_sampling.hpp"
#include "core/field/kernel/stored_states.hpp"
#include "core/field/kernel/uniform_places.hpp"

namespace wakesurf::core {

/// Four nodes of a row, twelve floats, in vectors of eight and four, if Lanes::FourNodes has no vector of
/// twelve.
template <class Lanes>
struct NodesInTwo {
    using Floats = typename Lanes::Floats;
    using Quad = typename Lanes::Quad;

    Floats first; ///< and second, and two components of the third
    Quad rest;

    static NodesInTwo none() { return {Floats::all(0.0f), Quad::all(0.0f)}; }

    static NodesInTwo load(const float* from) { return {Floats::load(from), Quad::load(from + 8)}; }

    void add(float share, const NodesInTwo& other) {
        const Floats shares = Floats::all(share);
        first = first + shares * other.first;
        rest = rest + shares.low() * other.rest;
    }

    /// The fourth element is anything.
    template <std::size_t K>
    Quad node() const {
        if constexpr (K == 0)
            return first.low();
        else if constexpr (K == 1)
            return first.second();
        else if constexpr (K == 2)
            return first.high().template from<2>(rest);
        else
            return rest.template from<1>(rest);
    }
};

/// The 4^3 nodes of each particle, in time-steps that are in one piece.
template <class Lanes, std::size_t Times>
class WholeBlocks {
    using Floats = typename Lanes::Floats;

  public:
    void begin(const StoredPair&, Rk4Batch&) {}

    void take(const StoredPair& field,
              Rk4Batch&,
              const UniformPlaces<Lanes>& places,
              std::size_t g,
              const Floats (&begin)[3]) {
        places.nodes(field, g, begin, node_ + g);
        if constexpr (Times == 1) {
            step_[0] = field.velocity0;
        } else {
            step_[0] = field.before;
            step_[1] = field.velocity0;
            step_[2] = field.velocity1;
            step_[3] = field.after;
        }
        row_ = 3 * static_cast<std::int64_t>(field.stride[1]);
        slice_ = 3 * static_cast<std::int64_t>(field.stride[2]);
    }

    const float* first(std::size_t lane, std::size_t step) const {
        return step_[step] + 3 * node_[lane];
    }

    /// Returns the floats from a row to the next; slice() those from a slice.
    std::int64_t row(std::size_t) const { return row_; }

    std::int64_t slice(std::size_t) const { return slice_; }

  private:
    const float* step_[Times];
    std::int64_t row_, slice_;
    alignas(64) std::int64_t node_[Rk4Batch::most];
};

/// Reads time-steps in bricks. Nodes of several bricks, as one particle in six has them where bricks have 32
/// cells, are brought together and kept: 64 nodes from as many as eight bricks. Marks lanes of which a brick
/// is missing.
template <class Lanes, std::size_t Times>
class BrickBlocks {
    using Floats = typename Lanes::Floats;
    using Quad = typename Lanes::Quad;
    using LookUp = BrickLookUp<Lanes>;
    static constexpr std::size_t most = Rk4Batch::most;

  public:
    void begin(const StoredPair& field, Rk4Batch& batch) {
        LookUp::begin(field, batch.bricks);
        row_ = 3 * static_cast<std::int64_t>(field.places.node[1]);
        slice_ = 3 * static_cast<std::int64_t>(field.places.node[2]);
    }

    void take(const StoredPair& field,
              Rk4Batch& batch,
              const UniformPlaces<Lanes>& places,
              std::size_t g,
              const Floats (&begin)[3]) {
        BrickReferences& bricks = batch.bricks;
        Floats at[3], left[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] = places.first_cell(axis, g) + begin[axis];
        unsigned apart = LookUp::outside(field, bricks, g, at, 2.0f, left);
        if (apart != 0) {
            float node[3][Floats::size];
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis].store(node[axis]);
            for (unsigned others = apart; others != 0; others &= others - 1u) {
                const auto i = static_cast<std::size_t>(__builtin_ctz(others));
                const float first[3] = {node[0][i], node[1][i], node[2][i]};
                if (in_one(field, first)) {
                    LookUp::keep(field, batch, g + i, first);
                    apart &= ~(1u << i);
                } else if (bricks.block_at[0][g + i] != 1.0f + first[0] ||
                           bricks.block_at[1][g + i] != 1.0f + first[1] ||
                           bricks.block_at[2][g + i] != 1.0f + first[2]) {
                    bring_together(field, batch, g + i, first);
                }
            }
            LookUp::outside(field, bricks, g, at, 2.0f, left);
        }
        std::int64_t nodes[Floats::size];
        LookUp::nodes_left(field, left, nodes);
        for (std::size_t t = 0; t < Times; ++t) {
            const std::int64_t* end = bricks.end[bricks.slot[in_order[t]]] + g;
            for (std::size_t i = 0; i < Floats::size; ++i)
                first_[t][g + i] = field.places.zeros + (end[i] - 3 * nodes[i]);
        }
        brought_ = (brought_ & ~(Rk4Batch::Bits{all_lanes} << g)) | Rk4Batch::Bits{apart} << g;
        for (; apart != 0; apart &= apart - 1u) {
            const std::size_t lane = g + static_cast<std::size_t>(__builtin_ctz(apart));
            for (std::size_t t = 0; t < Times; ++t)
                first_[t][lane] = bricks.block[bricks.slot[in_order[t]]][lane];
        }
    }

    const float* first(std::size_t lane, std::size_t step) const { return first_[step][lane]; }

    std::int64_t row(std::size_t lane) const { return brought(lane) ? 12 : row_; }

    std::int64_t slice(std::size_t lane) const { return brought(lane) ? 48 : slice_; }

  private:
    /// The indices into BrickReferences::slot of the time-step before, the pair's, and after.
    static constexpr std::size_t in_order[4] = {Times == 1 ? 0 : 2, 0, 1, 3};

    static bool in_one(const StoredPair& field, const float (&first)[3]) {
        const auto within = static_cast<std::int64_t>(field.places.cells) - 1;
        for (const float node : first)
            if ((static_cast<std::int64_t>(node) & within) > within - 2)
                return false;
        return true;
    }

    /// A part of four neighbouring nodes on an axis that is in one brick: where it begins, its first node in
    /// the brick, and what the brick adds to the number.
    struct Part {
        std::int64_t from, to, node, brick;
    };

    /// Returns one or two: the number of bricks that the nodes lie in along an axis.
    static int parts_of(const BrickPlaces& in, std::size_t axis, float first, Part (&part)[2]) {
        const auto cells = static_cast<std::int64_t>(in.cells);
        const auto its = static_cast<std::int64_t>(first * in.per_cell);
        const std::int64_t local = static_cast<std::int64_t>(first) - its * cells;
        const auto stride = static_cast<std::int64_t>(in.brick[axis]);
        const std::int64_t split = local + 3 <= cells ? 4 : cells + 1 - local;
        part[0] = {0, split, local, its * stride};
        part[1] = {split, 4, 1, (its + 1) * stride};
        return split == 4 ? 1 : 2;
    }

    static void bring_together(const StoredPair& field,
                               Rk4Batch& batch,
                               std::size_t lane,
                               const float (&first)[3]) {
        const BrickPlaces& in = field.places;
        BrickReferences& bricks = batch.bricks;
        Part parts[3][2];
        int count[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            count[axis] = parts_of(in, axis, first[axis], parts[axis]);
        bricks.absent &= ~(std::uint64_t{1} << lane);
        for (int part = 0; part < count[0] * count[1] * count[2]; ++part) {
            const Part& x = parts[0][part % count[0]];
            const Part& y = parts[1][part / count[0] % count[1]];
            const Part& z = parts[2][part / (count[0] * count[1])];
            for (std::size_t slot = 0; slot < 4; ++slot)
                if (bricks.of[slot].at != nullptr)
                    copy(field, x, y, z,
                         LookUp::in_memory(in, batch, lane, bricks.of[slot],
                                           x.brick + y.brick + z.brick),
                         bricks.block[slot][lane]);
        }
        const bool all = (bricks.absent >> lane & 1u) == 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            bricks.block_at[axis][lane] = all ? 1.0f + first[axis] : 0.0f;
    }

    static void copy(const StoredPair& field,
                     const Part& x,
                     const Part& y,
                     const Part& z,
                     const float* brick,
                     float* block) {
        const auto row = 3 * static_cast<std::int64_t>(field.places.node[1]);
        const auto slice = 3 * static_cast<std::int64_t>(field.places.node[2]);
        for (std::int64_t k = z.from; k < z.to; ++k)
            for (std::int64_t j = y.from; j < y.to; ++j) {
                const float* from = brick + 3 * x.node + row * (y.node + j - y.from) +
                                    slice * (z.node + k - z.from);
                float* to = block + 48 * k + 12 * j + 3 * x.from;
                if (x.from == 0 && x.to == 4)
                    for (std::int64_t i = 0; i < 12; i += 4)
                        Lanes::Vector::load(from + i).store(to + i);
                else
                    for (std::int64_t i = 0; i < 3 * (x.to - x.from); ++i)
                        to[i] = from[i];
            }
    }

    bool brought(std::size_t lane) const { return (brought_ >> lane & 1u) != 0; }

    static constexpr unsigned all_lanes = (1u << Floats::size) - 1u;

    const float* first_[Times][most];
    Rk4Batch::Bits brought_ = 0; ///< a bit a lane: its nodes are those of BrickReferences::block
    std::int64_t row_, slice_;   ///< of bricks
};

/// @tparam Times   4 time-steps, or 1 for a frozen field
/// @tparam Blocks  WholeBlocks or BrickBlocks
template <class Lanes, std::size_t Times, class Blocks, bool Tangents>
class CubicSampling {
    using Floats = typename Lanes::Floats;
    using Nodes = typename Lanes::FourNodes;
    using Vector = typename Lanes::Vector;
    static constexpr std::size_t most = Rk4Batch::most;

    /// The weights of four neighbouring nodes.
    struct Shares {
        Floats node[4];
    };

  public:
    void begin(const StoredPair& field, Rk4Batch& batch, std::size_t) {
        blocks_.begin(field, batch);
    }

    void place(const StoredPair& field,
               Rk4Batch& batch,
               const UniformPlaces<Lanes>& places,
               std::size_t g,
               const Floats (&cell)[3],
               const Floats (&fraction)[3]) {
        const Floats none = Floats::all(0.0f);
        const Floats one = Floats::all(1.0f);
        Floats linear = none; // 1: near an obstacle
        if (field.near_solid.whole != nullptr || field.near_solid.bricks != nullptr) {
            const unsigned lanes =
                lanes_with_state<Lanes>(field, field.near_solid, places, g, cell);
            float near[Floats::size];
            for (std::size_t i = 0; i < Floats::size; ++i)
                near[i] = (lanes >> i & 1u) != 0 ? 1.0f : 0.0f;
            linear = Floats::load(near);
        }
        Floats begin[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats at = places.first_cell(axis, g) + cell[axis];
            const Floats to_last = places.to_last_cell(axis, at);
            // Where a node is missing the four begin one later or earlier, and it has no share.
            begin[axis] = cell[axis] - one + Floats::where_zero(at, one, none) -
                          Floats::where_zero(to_last, one, none);
            const Floats f = fraction[axis];
            const Floats half = Floats::all(0.5f);
            Shares value{f * (f * (one - half * f) - half),
                         one + f * f * (Floats::all(1.5f) * f - Floats::all(2.5f)),
                         f * (half + f * (Floats::all(2.0f) - Floats::all(1.5f) * f)),
                         f * f * (half * f - half)};
            const Shares straight{none, one - f, f, none};
            shared(value, straight, linear, at, to_last, value_[axis], g);
            if constexpr (Tangents) {
                const Shares slope{f * (Floats::all(2.0f) - Floats::all(1.5f) * f) - half,
                                   f * (Floats::all(4.5f) * f - Floats::all(5.0f)),
                                   half + f * (Floats::all(4.0f) - Floats::all(4.5f) * f),
                                   f * (Floats::all(1.5f) * f - one)};
                shared(slope, {none, none - one, one, none}, linear, at, to_last, slope_[axis], g);
            }
        }
        blocks_.take(field, batch, places, g, begin);
        if constexpr (!Tangents)
            for (std::size_t z = 0; z < 4; ++z)
                for (std::size_t y = 0; y < 4; ++y)
                    (Floats::load(value_[1][y] + g) * Floats::load(value_[2][z] + g))
                        .store(row_share_[4 * z + y] + g);
    }

    /// Samples as LinearSampling::Stage does.
    class Stage {
      public:
        KernelSample<Lanes> sample(std::size_t i) const {
            One one[Lanes::together];
            for (std::size_t k = 0; k < Lanes::together; ++k)
                one[k] = sample_one(i + k);
            const auto together = [&](Vector One::*part) {
                Vector vector[Lanes::together];
                for (std::size_t k = 0; k < Lanes::together; ++k)
                    vector[k] = one[k].*part;
                return Lanes::quad(vector);
            };
            KernelSample<Lanes> result;
            result.value = together(&One::value);
            if constexpr (Tangents) {
                result.along_x = together(&One::along_x);
                result.along_yz = Floats::both(together(&One::along_y), together(&One::along_z));
            }
            return result;
        }

      private:
        friend CubicSampling;

        /// Samples for one particle.
        struct One {
            Vector value, along_x, along_y, along_z;
        };

        One sample_one(std::size_t i) const {
            const auto& value = of_->value_;
            const auto& slope = of_->slope_;
            const std::int64_t row = of_->blocks_.row(i);
            const std::int64_t rows[4] = {0, row, 2 * row, 3 * row};
            const std::int64_t to_next = of_->blocks_.slice(i);
            const float* slice[Times];
            for (std::size_t t = 0; t < Times; ++t)
                slice[t] = of_->blocks_.first(i, t);
            const auto next_slice = [&] {
                for (std::size_t t = 0; t < Times; ++t)
                    slice[t] += to_next;
            };
            if constexpr (Tangents) {
                Nodes total = Nodes::none(), along_y = Nodes::none(), along_z = Nodes::none();
                for (std::size_t z = 0; z < 4; ++z) {
                    Nodes in_slice = Nodes::none(), across = Nodes::none();
#pragma GCC unroll 4
                    for (std::size_t y = 0; y < 4; ++y) {
                        const Nodes now = at_time(
                            i, [&](std::size_t t) { return Nodes::load(slice[t] + rows[y]); });
                        in_slice.add(value[1][y][i], now);
                        across.add(slope[1][y][i], now);
                    }
                    next_slice();
                    total.add(value[2][z][i], in_slice);
                    along_y.add(value[2][z][i], across);
                    along_z.add(slope[2][z][i], in_slice);
                }
                return {sum(total, value[0], i), sum(total, slope[0], i), sum(along_y, value[0], i),
                        sum(along_z, value[0], i)};
            } else {
                Nodes total[Times];
                for (std::size_t t = 0; t < Times; ++t)
                    total[t] = Nodes::none();
                for (std::size_t z = 0; z < 4; ++z) {
#pragma GCC unroll 4
                    for (std::size_t y = 0; y < 4; ++y) {
                        const float share = of_->row_share_[4 * z + y][i];
#pragma GCC unroll 4
                        for (std::size_t t = 0; t < Times; ++t)
                            total[t].add(share, Nodes::load(slice[t] + rows[y]));
                    }
                    next_slice();
                }
                One one;
                one.value = sum(at_time(i, [&](std::size_t t) { return total[t]; }), value[0], i);
                return one;
            }
        }

        template <class Step>
        Nodes at_time(std::size_t i, const Step& step) const {
            if constexpr (Times == 1) {
                return step(0);
            } else {
                Nodes now = Nodes::none();
#pragma GCC unroll 4
                for (std::size_t t = 0; t < Times; ++t)
                    now.add(share_[t][i], step(t));
                return now;
            }
        }

        const CubicSampling* of_;
        const float (*share_)[most]; ///< of the time-steps
    };

    Stage stage(const StoredPair&, const Rk4Batch& batch, std::size_t time) const {
        Stage stage;
        stage.of_ = this;
        stage.share_ = batch.share[time];
        return stage;
    }

  private:
    /// Stores a row's shares: the straight ones where `linear` is not 0. At a missing node the field is
    /// extrapolated, so that it is twice its neighbour less the next.
    static void shared(const Shares& cubic,
                       const Shares& straight,
                       const Floats& linear,
                       const Floats& at,
                       const Floats& to_last,
                       float (&to)[4][most],
                       std::size_t g) {
        const Floats none = Floats::all(0.0f);
        const Floats two = Floats::all(2.0f);
        Floats w[4];
        for (std::size_t k = 0; k < 4; ++k)
            w[k] = Floats::where_zero(linear, cubic.node[k], straight.node[k]);
        const Shares first{w[1] + two * w[0], w[2] - w[0], w[3], none};
        const Shares last{none, w[0], w[1] - w[3], w[2] + two * w[3]};
        for (std::size_t k = 0; k < 4; ++k)
            Floats::where_zero(at, first.node[k], Floats::where_zero(to_last, last.node[k], w[k]))
                .store(to[k] + g);
    }

    static Vector sum(const Nodes& nodes, const float (&share)[4][most], std::size_t i) {
        return (Vector::all(share[0][i]) * nodes.template node<0>() +
                Vector::all(share[1][i]) * nodes.template node<1>()) +
               (Vector::all(share[2][i]) * nodes.template node<2>() +
                Vector::all(share[3][i]) * nodes.template node<3>());
    }

    alignas(64) float value_[3][4][most]; ///< shares along each axis
    alignas(64) float slope_[3][4][most]; ///< in the slope
    /// The shares of the rows in the value, those of the first slice first.
    alignas(32) float row_share_[16][most];
    Blocks blocks_;
};

} // namespace wakesurf::core
