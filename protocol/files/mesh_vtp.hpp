// A surface -> the bytes of a .vtp file (VTK XML PolyData, inline, compressed by zlib): one polygon a cell,
// corners and hanging nodes in order, so that the polygons share points and the file is as watertight as the
// surface.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <string>

namespace wakesurf::protocol {

/// Writes coordinates as computed (Float64). Same input, same bytes. About 60 bytes and 2 microseconds a
/// vertex and core. REQUIRES: every per-vertex array of `mesh` and `scalars` has mesh.vertices() entries;
/// `deformation` may be empty.
std::string mesh_vtp(const core::QuadComplex& mesh,
                     const MeshMetadata& metadata,
                     const MeshScalars& scalars = {});

} // namespace wakesurf::protocol
