// A surface -> the text of a Wavefront .obj file.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <string>

namespace wakesurf::protocol {

/// Writes `v x y z` as computed, `vt s t`, and faces as in mesh_ply. The format cannot hold further arrays.
/// Metadata in comments. Same input, same text. REQUIRES: as mesh_vtp.
std::string mesh_obj(const core::QuadComplex& mesh, const MeshMetadata& metadata);

} // namespace wakesurf::protocol
