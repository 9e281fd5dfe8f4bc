// The state of a surface on the wire: integers that the server and all its clients hold alike.
// protocol/wire/FORMAT.md, State. Twin: web-client/src/protocol/wireMesh.ts.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// A checksum of 32 bit words that scripts and vector units compute fast: sums, and sums of sums, in four
/// lanes. protocol/wire/FORMAT.md, State sum. Twin: web-client/src/protocol/wireMesh.ts.
/// Returns the checksum, which finds accidents, not intent: any change of one word, and nearly all others.
std::uint32_t word_sum(std::span<const std::uint32_t> words);

/// Returns the checksum of codes, each one word.
std::uint32_t word_sum(std::span<const std::uint16_t> codes);

/// The cells of a state, and for each vertex the neighbours of lower index, which predictions need.
/// protocol/wire/FORMAT.md, Neighbours. Twin: web-client/src/protocol/wireMesh.ts.
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

/// The attributes of every surface's vertices, in the order of the wire; the surface's fields follow.
inline constexpr std::array<std::string_view, 3> surface_attributes{"speed", "s", "t"};

/// Holds further attributes of a mesh: one array each, one value a vertex.
using MeshFields = std::vector<std::vector<float>>;

/// Holds the values of the codes 0 and last() of an attribute. They have 64 bits: release times may be
/// seconds since 1970.
struct AttributeRange {
    /// The code of a missing value, if there are gaps.
    static constexpr std::uint16_t none = 65535;
    /// Updates round codes from here on, by less than the room below it.
    static constexpr std::uint16_t first_none = 0xf800;

    double lo = 0;     ///< value of code 0
    double hi = 0;     ///< value of code last()
    bool gaps = false; ///< some vertices have no value

    /// Returns the largest code of a value.
    double last() const { return gaps ? 0xefff : 0xffff; }

    /// Returns the value of a code; NaN for a missing one.
    double value(std::uint16_t code) const;

    /// Returns the codes a unit; 0 for a range without width.
    double scale() const { return hi > lo ? last() / (hi - lo) : 0.0; }

    /// Returns the nearest code; values outside of the range go to its end. REQUIRES: a finite value, or NaN
    /// if there are gaps.
    std::uint16_t code(double value) const { return code(value, scale()); }

    /// Does so for many values. @param scale  scale()
    std::uint16_t code(double value, double scale) const {
        if (gaps && std::isnan(value))
            return none;
        return static_cast<std::uint16_t>(
            std::min(std::max((value - lo) * scale + 0.5, 0.0), last()));
    }

    bool operator==(const AttributeRange&) const = default;
};

/// Holds a surface as both ends of the wire do.
struct WireMesh {
    int lattice_bits = 16;              ///< of positions
    double time = 0.0;                  ///< simulation time
    std::vector<AttributeRange> ranges; ///< one an attribute
    std::vector<LatticePoint> position; ///< one a vertex
    std::vector<LatticePoint> change;   ///< of the position by the last update, one a vertex
    std::vector<std::vector<std::uint16_t>> codes; ///< one array an attribute, one code a vertex
    /// The cells and their neighbours; never null.
    std::shared_ptr<const WireTopology> topology = std::make_shared<const WireTopology>();

    /// Returns the number of vertices.
    std::size_t vertices() const { return position.size(); }

    /// Returns the quads.
    const std::vector<core::Cell>& cells() const { return topology->cells; }

    /// Returns the memory of the state.
    std::size_t bytes() const;
};

/// Returns the checksum of everything but the changes. Cost: about 0.05 ns a byte.
std::uint32_t state_sum(const WireMesh& mesh);

} // namespace wakesurf::protocol
