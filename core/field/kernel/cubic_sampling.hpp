// Velocities of a batch's particles as CubicSampler has them: Catmull-Rom in space over 4^3 nodes, trilinear
// near obstacles, and four time-steps. A row of four nodes is twelve floats: Lanes::FourNodes. Rows are added
// up particle by particle whatever the vectors, as one row fills the widest. Twin: linear_sampling.hpp.
#pragma once

#include "core/field/kernel/linear_sampling.hpp"
#include "core/field/kernel/uniform_places.hpp"

namespace wakesurf::core {

/// Four nodes of a row, twelve floats, in vectors of eight and four: what Lanes::FourNodes is where none has
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

    /// Floats from a row to the next, and from a slice.
    std::int64_t row(std::size_t) const { return row_; }

    std::int64_t slice(std::size_t) const { return slice_; }

  private:
    const float* step_[Times];
    std::int64_t row_, slice_;
    alignas(64) std::int64_t node_[Rk4Batch::most];
};

/// The same of time-steps in bricks. Nodes of several bricks, as one particle in four has them where bricks have 32 cells, are brought
/// together: 64 nodes from as many as eight bricks. Marks lanes of which a brick is missing.
template <class Lanes, std::size_t Times>
class BrickBlocks {
    using Floats = typename Lanes::Floats;
    static constexpr std::size_t most = Rk4Batch::most;
    static constexpr std::size_t block =
        64 * 3 + 4; ///< floats, and what the last load reads beyond

  public:
    void take(const StoredPair& field,
              Rk4Batch& batch,
              const UniformPlaces<Lanes>& places,
              std::size_t g,
              const Floats (&begin)[3]) {
        float first[3][Floats::size];
        for (std::size_t axis = 0; axis < 3; ++axis)
            (places.first_cell(axis, g) + begin[axis]).store(first[axis]);
        for (std::size_t i = 0; i < Floats::size; ++i) {
            const std::int64_t node[3] = {static_cast<std::int64_t>(first[0][i]),
                                          static_cast<std::int64_t>(first[1][i]),
                                          static_cast<std::int64_t>(first[2][i])};
            if (g + i < batch.count)
                take_one(field, batch, g + i, node);
            else
                for (std::size_t t = 0; t < Times; ++t)
                    first_[t][g + i] = field.places.zeros;
        }
    }

    const float* first(std::size_t lane, std::size_t step) const { return first_[step][lane]; }

    std::int64_t row(std::size_t lane) const { return row_[lane]; }

    std::int64_t slice(std::size_t lane) const { return slice_[lane]; }

  private:
    void take_one(const StoredPair& field,
                  Rk4Batch& batch,
                  std::size_t lane,
                  const std::int64_t (&first)[3]) {
        const BrickPlaces& in = field.places;
        const auto cells = static_cast<std::int64_t>(in.cells);
        const std::int64_t along[3] = {static_cast<std::int64_t>(in.node[0]),
                                       static_cast<std::int64_t>(in.node[1]),
                                       static_cast<std::int64_t>(in.node[2])};
        std::int64_t brick[3][2], node[3][2], split[3]; // nodes before `split` are in the first
        bool one = true;
        std::int64_t number = 0, within = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t its = first[axis] / cells;
            const auto stride = static_cast<std::int64_t>(in.brick[axis]);
            const std::int64_t local = first[axis] - its * cells;
            split[axis] = local + 3 <= cells ? 4 : cells + 1 - local;
            brick[axis][0] = its * stride;
            brick[axis][1] = brick[axis][0] + stride;
            node[axis][0] = local * along[axis];
            node[axis][1] = (local - cells) * along[axis];
            one = one && split[axis] == 4;
            number += brick[axis][0];
            within += node[axis][0];
        }
        const StoredBricks four[4] = {field.bricks_before, field.bricks0, field.bricks1,
                                      field.bricks_after};
        const StoredBricks* steps = Times == 1 ? four + 1 : four;
        if (one) {
            row_[lane] = 3 * along[1];
            slice_[lane] = 3 * along[2];
            for (std::size_t t = 0; t < Times; ++t)
                first_[t][lane] = at(steps[t], in, batch, lane, number) + 3 * within;
            return;
        }
        row_[lane] = 12;
        slice_[lane] = 48;
        for (std::size_t t = 0; t < Times; ++t) {
            float* to = brought_[t][lane];
            first_[t][lane] = to;
            for (std::int64_t z = 0; z < 4; ++z)
                for (std::int64_t y = 0; y < 4; ++y) {
                    const std::int64_t sy = y < split[1] ? 0 : 1, sz = z < split[2] ? 0 : 1;
                    const std::int64_t b = brick[1][sy] + brick[2][sz];
                    const std::int64_t n = node[1][sy] + y * along[1] + node[2][sz] + z * along[2];
                    for (std::int64_t x = 0; x < 4;) {
                        const std::int64_t sx = x < split[0] ? 0 : 1;
                        const std::int64_t end = sx == 0 ? split[0] : 4;
                        const float* from = at(steps[t], in, batch, lane, b + brick[0][sx]) +
                                            3 * (n + node[0][sx] + x);
                        for (; x < end; ++x, to += 3, from += 3) {
                            to[0] = from[0];
                            to[1] = from[1];
                            to[2] = from[2];
                        }
                    }
                }
        }
    }

    static const float* at(const StoredBricks& step,
                           const BrickPlaces& in,
                           Rk4Batch& batch,
                           std::size_t lane,
                           std::int64_t brick) {
        const float* found = __atomic_load_n(step.at + brick, __ATOMIC_ACQUIRE);
        if (found == nullptr) {
            batch.missing |= Rk4Batch::Bits{1} << lane;
            batch.missing_brick[lane] = static_cast<std::uint32_t>(brick);
            return in.zeros;
        }
        std::uint16_t* used = step.used + brick;
        if (__atomic_load_n(used, __ATOMIC_RELAXED) != in.age)
            __atomic_store_n(used, in.age, __ATOMIC_RELAXED);
        return found;
    }

    const float* first_[Times][most];
    std::int64_t row_[most], slice_[most];
    alignas(64) float brought_[Times][most][block];
};

/// @tparam Times   4 time-steps, or 1 for a frozen field
/// @tparam Blocks  WholeBlocks or BrickBlocks
template <class Lanes, std::size_t Times, class Blocks, bool Tangents>
class CubicSampling {
    using Floats = typename Lanes::Floats;
    using Nodes = typename Lanes::FourNodes;
    using Vector = typename Lanes::Vector;
    static constexpr std::size_t most = Rk4Batch::most;

    /// Of four neighbouring nodes.
    struct Shares {
        Floats node[4];
    };

  public:
    void begin(const StoredPair&, const Rk4Batch&, std::size_t) {}

    void place(const StoredPair& field,
               Rk4Batch& batch,
               const UniformPlaces<Lanes>& places,
               std::size_t g,
               const Floats (&cell)[3],
               const Floats (&fraction)[3]) {
        const Floats none = Floats::all(0.0f);
        const Floats one = Floats::all(1.0f);
        Floats linear = none; // 1: near an obstacle
        if (field.near_solid != nullptr) {
            std::int64_t node[Floats::size];
            places.nodes(field, g, cell, node);
            float near[Floats::size];
            for (std::size_t i = 0; i < Floats::size; ++i)
                near[i] = field.near_solid[node[i]] != 0 ? 1.0f : 0.0f;
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

    /// As LinearSampling::Stage.
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

        /// Of one particle.
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
    /// Stores a row's shares: the straight ones where `linear` is not 0; where a node is missing the field goes on linearly, so that it is
    /// twice its neighbour less the next.
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
    alignas(
        32) float row_share_[16]
                            [most]; ///< of the rows in the value, those of the first slice first
    Blocks blocks_;
};

} // namespace wakesurf::core
