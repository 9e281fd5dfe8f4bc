// A surface in the integers of the wire: positions on the lattice, attributes as codes.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Holds the attributes of each vertex. It refers to those of the mesh, which must outlive it.
class AttributeValues {
  public:
    /// Makes an empty set.
    AttributeValues() = default;

    /// Takes speed, s and t, all finite, then the fields: NaN is a missing value.
    AttributeValues(const core::QuadComplex& mesh, const MeshFields& fields);

    std::span<const std::span<const double>> all() const { return all_; }

  private:
    std::vector<std::vector<double>> own_;
    std::vector<std::span<const double>> all_;
};

/// Returns ranges that hold all values: `held` as long as they do, else those widened by half, so that a
/// growing surface does not need new ones with each update.
std::vector<AttributeRange> ranges_for(const AttributeValues& values,
                                       std::span<const AttributeRange> held);

/// Returns positions and codes by place: vertex i of the surface is vertex place[i]. No topology, no changes.
/// REQUIRES: guard_mesh passed.
WireMesh quantise_mesh(const core::QuadComplex& mesh,
                       const Lattice& lattice,
                       const AttributeValues& values,
                       std::span<const AttributeRange> ranges,
                       std::span<const std::uint32_t> place);

} // namespace wakesurf::protocol
