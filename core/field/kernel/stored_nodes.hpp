// Where the lowest nodes of the particles' cells are in memory: in time-steps that are in one piece, or in
// their bricks.
#pragma once

#include "core/field/kernel/brick_lookup.hpp"

namespace wakesurf::core {

/// Offsets are in floats, from base().
template <class Lanes>
class WholeNodes {
    using Floats = typename Lanes::Floats;

  public:
    static const float* base(const StoredPair&, const float* velocity) { return velocity; }

    /// Returns the nodes between neighbours on each axis.
    static const double (&strides(const StoredPair& field))[3] { return field.stride; }

    void begin(const StoredPair&, Rk4Batch&) {}

    /// Finds the nodes of a vector of lanes from `g` on; cells count from the places' first ones.
    template <class Places>
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
    using LookUp = BrickLookUp<Lanes>;

  public:
    static const float* base(const StoredPair& field, const float*) { return field.places.zeros; }

    static const double (&strides(const StoredPair& field))[3] { return field.places.node; }

    void begin(const StoredPair& field, Rk4Batch& batch) {
        LookUp::begin(field, batch.bricks);
        for (std::size_t step = 0; step < 2; ++step)
            end_[step] = batch.bricks.end[batch.bricks.slot[step]];
    }

    template <class Places>
    void take(const StoredPair& field,
              Rk4Batch& batch,
              const Places& places,
              std::size_t g,
              const Floats (&cell)[3]) {
        Floats at[3], left[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] = places.first_cell(axis, g) + cell[axis];
        if (unsigned others = LookUp::outside(field, batch.bricks, g, at, 0.0f, left);
            others != 0) {
            float cells[3][Floats::size];
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis].store(cells[axis]);
            for (; others != 0; others &= others - 1u) {
                const auto i = static_cast<std::size_t>(__builtin_ctz(others));
                LookUp::keep(field, batch, g + i, {cells[0][i], cells[1][i], cells[2][i]});
            }
            LookUp::outside(field, batch.bricks, g, at, 0.0f, left);
        }
        LookUp::nodes_left(field, left, left_ + g);
    }

    template <std::size_t Step>
    std::int64_t offset(std::size_t lane) const {
        return end_[Step][lane] - 3 * left_[lane];
    }

  private:
    const std::int64_t* end_[2];
    alignas(64) std::int64_t left_[Rk4Batch::most]; ///< nodes to the end
};

} // namespace wakesurf::core
