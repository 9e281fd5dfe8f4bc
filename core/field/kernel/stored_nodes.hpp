// Where the lowest nodes of the particles' cells are in memory: in time-steps that are in one piece, or in their bricks.
#pragma once

#include "core/field/kernel/rk4_batch.hpp"

namespace wakesurf::core {

/// Offsets are in floats, from base().
template <class Lanes>
class WholeNodes {
    using Floats = typename Lanes::Floats;

  public:
    static const float* base(const StoredPair&, const float* velocity) { return velocity; }

    /// Nodes between neighbours on each axis.
    static const double (&strides(const StoredPair& field))[3] { return field.stride; }

    /// Of lanes from `g` on, a vector of them, in so many time-steps; cells count from the places' first ones.
    template <std::size_t Steps, class Places>
    void take(const StoredPair& field,
              Rk4Batch&,
              const Places& places,
              std::size_t g,
              const Floats (&cell)[3]) {
        places.nodes(field, g, cell, node_ + g);
    }

    template <std::size_t Step>
    std::int64_t offset(std::size_t lane) const {
        return 3 * node_[lane];
    }

  private:
    alignas(64) std::int64_t node_[Rk4Batch::most];
};

/// Marks lanes of which a brick is missing.
template <class Lanes>
class BrickNodes {
    using Floats = typename Lanes::Floats;
    using Wide = typename Lanes::Wide;

  public:
    static const float* base(const StoredPair& field, const float*) { return field.places.zeros; }

    static const double (&strides(const StoredPair& field))[3] { return field.places.node; }

    template <std::size_t Steps, class Places>
    void take(const StoredPair& field,
              Rk4Batch& batch,
              const Places& places,
              std::size_t g,
              const Floats (&cell)[3]) {
        const Floats cells = Floats::all(static_cast<float>(field.places.cells));
        const Floats per_cell = Floats::all(static_cast<float>(field.places.per_cell));
        Wide brick[2] = {Wide::all(0.0), Wide::all(0.0)};
        Floats within = Floats::all(0.0f); // exact: a brick has few nodes
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats at = places.first_cell(axis, g) + cell[axis];
            const Floats its = (at * per_cell).floor();
            const Wide stride = Wide::all(field.places.brick[axis]);
            brick[0] = brick[0] + its.low().widen() * stride;
            brick[1] = brick[1] + its.high().widen() * stride;
            within = within +
                     (at - its * cells) * Floats::all(static_cast<float>(field.places.node[axis]));
        }
        std::int64_t number[Floats::size];
        float node[Floats::size];
        brick[0].integers(number);
        brick[1].integers(number + Wide::size);
        within.store(node);
        const StoredBricks steps[2] = {field.bricks0, field.bricks1};
        for (std::size_t i = 0; i < Floats::size; ++i) {
            const auto in_brick = 3 * static_cast<std::int64_t>(node[i]);
            for (std::size_t step = 0; step < Steps; ++step) {
                const float* at = __atomic_load_n(steps[step].at + number[i], __ATOMIC_ACQUIRE);
                if (at == nullptr) {
                    at = field.places.zeros;
                    batch.missing |= Rk4Batch::Bits{1} << (g + i);
                    batch.missing_brick[g + i] = static_cast<std::uint32_t>(number[i]);
                } else if (std::uint16_t* used = steps[step].used + number[i];
                           __atomic_load_n(used, __ATOMIC_RELAXED) != field.places.age) {
                    __atomic_store_n(used, field.places.age, __ATOMIC_RELAXED);
                }
                at_[step][g + i] = (at - field.places.zeros) + in_brick;
            }
        }
    }

    template <std::size_t Step>
    std::int64_t offset(std::size_t lane) const {
        return at_[Step][lane];
    }

  private:
    alignas(64) std::int64_t at_[2][Rk4Batch::most];
};

} // namespace wakesurf::core
