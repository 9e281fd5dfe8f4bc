// The cells of a state and what predictions need of them: for each vertex the neighbours of lower index.
// protocol/wire/FORMAT.md, Neighbours. Twin: web-client/src/protocol/neighbours.ts.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::protocol {

/// Neighbours of one vertex; `core::no_vertex` where there is none. All are below the vertex.
struct Neighbours {
    std::uint32_t highest = core::no_vertex; ///< a
    std::uint32_t lowest = core::no_vertex;  ///< b
    std::uint32_t beside =
        core::no_vertex; ///< p, of the first cell whose other corners are all lower
    std::uint32_t beside2 = core::no_vertex; ///< n
    std::uint32_t opposite =
        core::no_vertex; ///< o; none where p and n are the ends of the side the vertex hangs on

    bool operator==(const Neighbours&) const = default;
};

/// Immutable once made, and shared by all states with the same cells.
struct WireTopology {
    std::vector<core::Cell> cells;      ///< in the order of the wire
    std::vector<Neighbours> neighbours; ///< one a vertex

    /// REQUIRES: every id of the cells is below `vertices`. Cost: O(vertices + cells).
    WireTopology(std::vector<core::Cell> cells, std::size_t vertices);

    /// The same where those of `before` come first and have kept their vertices. Looks at the others only.
    WireTopology(const WireTopology& before, std::vector<core::Cell> cells, std::size_t vertices);

    WireTopology() = default;
};

} // namespace wakesurf::protocol
