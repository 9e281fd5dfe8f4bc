// Reads what is stored of particles' cells, a byte each, that the grid's obstacle makes of them.
#pragma once

#include "core/field/kernel/rk4_batch.hpp"

namespace wakesurf::core {

/// Returns bits of the lanes from `g` on, a vector of them, whose cells have another byte than 0; cells count
/// from the places' first ones. REQUIRES: there are states.
template <class Lanes, class Places>
unsigned lanes_with_state(const StoredPair& field,
                          const StoredStates& states,
                          const Places& places,
                          std::size_t g,
                          const typename Lanes::Floats (&cell)[3]) {
    constexpr std::size_t size = Lanes::Floats::size;
    unsigned found = 0;
    if (states.whole != nullptr) {
        std::int64_t node[size];
        places.nodes(field, g, cell, node);
        for (std::size_t i = 0; i < size; ++i)
            found |= (states.whole[node[i]] != 0 ? 1u : 0u) << i;
        return found;
    }
    const BrickPlaces& in = field.places;
    const auto cells = static_cast<std::int64_t>(in.cells);
    float at[3][size];
    for (std::size_t axis = 0; axis < 3; ++axis)
        (places.first_cell(axis, g) + cell[axis]).store(at[axis]);
    for (std::size_t i = 0; i < size; ++i) {
        std::int64_t brick = 0;
        std::int64_t node = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto its = static_cast<std::int64_t>(at[axis][i] * in.per_cell);
            brick += its * static_cast<std::int64_t>(in.brick[axis]);
            node += (static_cast<std::int64_t>(at[axis][i]) - its * cells) *
                    static_cast<std::int64_t>(in.node[axis]);
        }
        found |= (states.bricks[brick][node] != 0 ? 1u : 0u) << i;
    }
    return found;
}

} // namespace wakesurf::core
