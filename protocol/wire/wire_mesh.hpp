// The state of a surface on the wire: integers that the server and all its clients hold alike.
// protocol/wire/FORMAT.md, State. Twin: web-client/src/protocol/wireMesh.ts.
#pragma once

#include "protocol/wire/lattice.hpp"
#include "protocol/wire/wire_topology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

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
