// A surface in the integers of the wire: positions on the lattice, attributes as codes.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/lattice.hpp"
#include "protocol/wire_mesh.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Speed, s and t of each vertex; s and t as the mesh holds them, which must outlive this.
struct AttributeValues {
    std::vector<double> speed;
    std::span<const double> s, t;

    std::array<std::span<const double>, surface_attributes.size()> all() const {
        return {speed, s, t};
    }
};

AttributeValues attribute_values(const core::QuadComplex& mesh);

/// Ranges that hold all values: `held` as long as they do, else those widened by half, so that a growing surface does not
/// need new ones with each update.
std::vector<AttributeRange> ranges_for(const AttributeValues& values,
                                       std::span<const AttributeRange> held);

/// Positions and codes by place: vertex i of the surface is vertex place[i]. No topology, no changes.
/// REQUIRES: guard_mesh passed.
WireMesh quantise_mesh(const core::QuadComplex& mesh,
                       const Lattice& lattice,
                       const AttributeValues& values,
                       std::span<const AttributeRange> ranges,
                       std::span<const std::uint32_t> place);

} // namespace wakesurf::protocol
