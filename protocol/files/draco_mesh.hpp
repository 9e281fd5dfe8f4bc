// Triangles with attributes -> a Draco mesh (Edgebreaker), for exports. Other programs decode it; the live
// wire is draco_points, which keeps the order of vertices and knows quads.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_triangles.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace wakesurf::protocol {

/// Holds one array with a value for each vertex. Floats keep 16 bits over their range, positions 20 bits over
/// the longest side of the mesh.
struct MeshAttribute {
    std::string name; ///< named as in .vtp
    std::variant<std::vector<float>,
                 std::vector<core::Vec3f>,
                 std::vector<std::uint16_t>,
                 std::vector<std::uint8_t>>
        values;
    /// Counts the values that were not finite, and are the least finite one instead.
    std::size_t missing = 0;
};

/// Returns s, t, speed, velocity, deformation if the mesh has it, component (65535: that one or a smaller
/// part), approximated, error and interval_error if the mesh has them, and then the scalars in order.
std::vector<MeshAttribute> mesh_attributes(const core::QuadComplex& mesh,
                                           const MeshScalars& scalars);

/// Returns the points as floats. Error: Corrupt for positions that are not finite or beyond 1e38.
core::Result<std::vector<core::Vec3f>> narrowed_positions(std::span<const core::Vec3> points);

struct DracoMesh {
    std::string bytes;
    std::size_t points = 0;    ///< as a decoder counts them
    std::size_t triangles = 0; ///< those with three different corners
    core::Vec3f lo{0.0F};      ///< bounds of the decoded positions, to the bit
    core::Vec3f hi{0.0F};
};

/// Encodes triangles. Attribute 0 is the positions, attribute i + 1 is `attributes[i]`, by unique id. With
/// `metadata` the file holds it, and a name for each attribute. Same input, same bytes; Draco decides the
/// order of vertices and triangles. REQUIRES: triangles name vertices of the mesh; attributes have a value
/// for each. Error: Corrupt for positions that are not finite (or beyond 1e38) or for what Draco refuses,
/// InvalidArgument for no triangles, OverLimit. Cost: about 1 microsecond a triangle.
core::Result<DracoMesh> encode_triangles(const core::QuadComplex& mesh,
                                         const std::vector<Triangle>& triangles,
                                         const std::vector<MeshAttribute>& attributes,
                                         const MeshMetadata* metadata);

/// Writes a .drc file of triangles, hanging nodes included, with the attributes of mesh_attributes, each with its name in its metadata
/// (`name`), and the metadata of the surface as the file's. Error: as encode_triangles.
core::Result<std::string> mesh_drc(const core::QuadComplex& mesh,
                                   const MeshMetadata& metadata,
                                   const MeshScalars& scalars = {});

} // namespace wakesurf::protocol
