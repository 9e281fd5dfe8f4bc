// A surface -> the bytes of a .glb file (glTF 2.0, binary) whose mesh is compressed with
// KHR_draco_mesh_compression, or plain for readers without it.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <string>

namespace wakesurf::protocol {

enum class GlbCoding { Draco, Plain };

/// Writes one two-sided mesh of triangles, hanging nodes included: POSITION, COLOR_0 (by age, a level surface by speed), _S, _T, _SPEED, _VELOCITY,
/// _DEFORMATION, _COMPONENT, _APPROXIMATED and one attribute a scalar, its name in capitals. Draco: the
/// extension is required, there is no second, uncompressed copy. Plain: 32-bit floats, with NORMAL, some 12
/// times as large. A surface without cells is a scene without a mesh. Metadata in the scene's extras. Same
/// input, same bytes. Error: as encode_triangles.
core::Result<std::string> mesh_glb(const core::QuadComplex& mesh,
                                   const MeshMetadata& metadata,
                                   const MeshScalars& scalars = {},
                                   GlbCoding coding = GlbCoding::Draco);

} // namespace wakesurf::protocol
