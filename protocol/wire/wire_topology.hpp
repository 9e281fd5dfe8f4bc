// The cells of a state, and for each vertex the neighbours of lower index, which predictions need.
// protocol/wire/FORMAT.md, Neighbours. Twin: web-client/src/protocol/wireMesh.ts.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::protocol {

/// Names the neighbours of one vertex, all below it; `core::no_vertex` for a missing one.
struct Neighbours {
    std::uint32_t highest = core::no_vertex; ///< a
    std::uint32_t lowest = core::no_vertex;  ///< b
    /// p, of the first cell whose other corners are all lower.
    std::uint32_t beside = core::no_vertex;
    std::uint32_t beside2 = core::no_vertex; ///< n
    /// o; missing if p and n are the ends of the side that the vertex hangs on.
    std::uint32_t opposite = core::no_vertex;

    bool operator==(const Neighbours&) const = default;
};

/// The cells and neighbours of a mesh. Immutable, and shared by all states with the same cells.
struct WireTopology {
    std::vector<core::Cell> cells;      ///< in the order of the wire
    std::vector<Neighbours> neighbours; ///< one a vertex

    /// REQUIRES: every id of the cells is below `vertices`. Cost: O(vertices + cells).
    WireTopology(std::vector<core::Cell> cells, std::size_t vertices);

    /// Extends `before`, whose cells come first in `cells` and have kept their vertices. Reads only the other
    /// cells.
    WireTopology(const WireTopology& before, std::vector<core::Cell> cells, std::size_t vertices);

    WireTopology() = default;
};

} // namespace wakesurf::protocol
