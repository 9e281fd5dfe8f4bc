// A surface -> the bytes of a .drc file: a Draco mesh with named attributes.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <string>

namespace wakesurf::protocol {

/// Writes triangles, hanging nodes included; attributes as in draco_mesh, each with its name in its metadata
/// (`name`), and the metadata of the surface as the file's. Error: as encode_triangles.
core::Result<std::string> mesh_drc(const core::QuadComplex& mesh,
                                   const MeshMetadata& metadata,
                                   const MeshScalars& scalars = {});

} // namespace wakesurf::protocol
