// Lines, ribbons and arrows of a surface as the bytes of a file.
#pragma once

#include "core/base/result.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/surface_lines.hpp"

#include <string>

namespace wakesurf::protocol {

/// Writes lines (.vtp lines, .obj `l`, .ply edges, .glb LINES) or polygons (.vtp and .ply polygons, .obj `f`,
/// .glb triangles), with the value of s or t for each; in a .glb, which is never compressed, at each vertex.
/// Same input, same bytes. Error: Unsupported for .drc, Corrupt for coordinates that a .glb cannot hold.
core::Result<std::string> lines_file(MeshFormat format,
                                     const SurfaceLines& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata);

} // namespace wakesurf::protocol
